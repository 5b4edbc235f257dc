#include "run/written_outputs.h"

namespace fumon {

void WrittenOutputs::list_frames(const std::filesystem::path& file, const FrameCount& previous) {
    frames_ = std::make_unique<FrameList>(file, previous);
    frames_sent_ = previous.frames;
}

void WrittenOutputs::send_frame() {
    const std::lock_guard lock(mutex_);
    ++frames_sent_;
}

void WrittenOutputs::send_bed() {
    const std::lock_guard lock(mutex_);
    ++beds_sent_;
}

void WrittenOutputs::add_frame(const FrameRecord& frame) {
    const std::lock_guard lock(mutex_);
    frames_->add(frame);
    written_.notify_all();
}

void WrittenOutputs::add_bed(BedRecord bed) {
    const std::lock_guard lock(mutex_);
    beds_.push_back(std::move(bed));
    written_.notify_all();
}

bool WrittenOutputs::wait_for_all() {
    std::unique_lock lock(mutex_);
    written_.wait(lock, [this] {
        return aborted_ || (frames_->frames() >= frames_sent_ && beds_.size() >= beds_sent_);
    });
    return !aborted_;
}

void WrittenOutputs::abort() {
    const std::lock_guard lock(mutex_);
    aborted_ = true;
    written_.notify_all();
}

}  // namespace fumon
