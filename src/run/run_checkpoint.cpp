#include "run/run_checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/checkpoint.h"
#include "files/hash.h"
#include "picture/png.h"

namespace fumon {

namespace {

void carry_inputs(std::vector<InputFile>& inputs, StateCarrier& carrier) {
    auto count = static_cast<std::int64_t>(inputs.size());
    constexpr std::int64_t most = 1000;
    carrier.count("inputs", count);
    if (count > most) carrier.refuse("it has too many inputs");
    inputs.resize(static_cast<std::size_t>(count));
    for (InputFile& input : inputs) {
        carrier.text("input_path", input.path);
        carrier.text("input_sha256", input.hash);
    }
}

/// Frames are numbered from 0 without gaps.
void carry_frames(std::vector<FrameRecord>& frames, StateCarrier& carrier) {
    std::vector<std::int64_t> steps;
    std::vector<double> times;
    std::string hashes;
    for (const FrameRecord& frame : frames) {
        steps.push_back(frame.step);
        times.push_back(frame.time);
        hashes.append(frame.pixels.begin(), frame.pixels.end());
    }
    carrier.list("frame_steps", steps);
    carrier.list("frame_times", times);
    carrier.text("frame_pixels", hashes);
    constexpr std::size_t bytes = std::tuple_size_v<Sha256>;
    if (times.size() != steps.size() || hashes.size() != bytes * steps.size())
        carrier.refuse("its frames do not fit each other");
    frames.resize(steps.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i].number = static_cast<std::int64_t>(i);
        frames[i].step = steps[i];
        frames[i].time = times[i];
        std::copy_n(hashes.begin() + static_cast<std::ptrdiff_t>(bytes * i), bytes,
                    frames[i].pixels.begin());
    }
}

}  // namespace

void RunCheckpoint::carry(StateCarrier& carrier) {
    carrier.text("fumon", version);
    carrier.text("scene", scene);
    carry_inputs(inputs, carrier);
    carrier.text("drawing", drawing);
    carrier.count("step", step);
    carrier.value("measurements_bytes", records.measurements);
    carrier.value("avalanches_bytes", records.avalanches);
    carrier.value("fields_records", records.fields);
    carry_frames(frames, carrier);
    carrier.list("bed_steps", bed_steps);
    carrier.list("resumed_at", resumed_at);
}

void Checkpointer::write(RunCheckpoint now, Model& model, Recorder& recorder) {
    clock_.begin();
    const struct Ended {
        CheckpointClock& clock;
        ~Ended() { clock.end(); }
    } ended{clock_};
    put_on_disk(now);
    now.version = FUMON_VERSION;
    now.step = model.steps_done();
    now.records = recorder.sync();
    CheckpointWriter writer(folder_.checkpoint());
    now.carry(writer);
    model.carry(writer);
    recorder.carry(writer);
    writer.commit();
}

void Checkpointer::put_on_disk(const RunCheckpoint& now) {
    for (; frames_on_disk_ < now.frames.size(); ++frames_on_disk_) {
        const std::int64_t number = now.frames[frames_on_disk_].number;
        if (parts_.frames) sync_file(folder_.frame(number));
        if (parts_.kept_frames) sync_file(folder_.kept_frame(number));
    }
    for (; beds_on_disk_ < now.bed_steps.size(); ++beds_on_disk_) {
        for (const auto& bed : folder_.beds(now.bed_steps[beds_on_disk_])) sync_file(bed);
    }
    if (parts_.frames) sync_folder_of(folder_.frame(0));
    if (parts_.kept_frames) sync_folder_of(folder_.kept_frame(0));
    if (parts_.beds) sync_folder_of(folder_.bed(0, ""));
}

Image read_frame(const RunFolder& folder, const RunParts& parts, const RunCheckpoint& checkpoint,
                 std::int64_t number) {
    const std::filesystem::path file =
        parts.frames ? folder.frame(number) : folder.kept_frame(number);
    Image image = read_png(file);
    if (pixel_hash(image) == checkpoint.frames.at(static_cast<std::size_t>(number)).pixels)
        return image;
    throw Error(
        fmt::format("{}: its pixels are not those that the run wrote, so the movie cannot "
                    "be begun again; bring the old file back",
                    file.string()));
}

void CheckpointClock::end() {
    constexpr double least_ratio = 50.0;  // of a run's seconds to those of its checkpoints
    wait_ = std::max(interval_, least_ratio * seconds_since(begun_));
    last_ = Clock::now();
}

}  // namespace fumon
