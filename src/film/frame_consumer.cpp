#include "film/frame_consumer.h"

#include <optional>
#include <utility>

#include "base/thread_clock.h"

namespace fumon {

FrameConsumer::FrameConsumer(Use use)
    : use_(std::move(use)), waiting_(1), thread_([this] { work(); }) {}

FrameConsumer::~FrameConsumer() {
    end();
}

void FrameConsumer::work() {
    name_this_thread("fumon-encode");
    try {
        while (const std::optional<Image> image = waiting_.pop()) use_(*image);
    } catch (...) {
        error_ = std::current_exception();
        waiting_.abort();
    }
}

void FrameConsumer::end() {
    waiting_.close();
    if (thread_.joinable()) thread_.join();
}

void FrameConsumer::add(Image image) {
    if (waiting_.push(std::move(image))) return;
    end();
    std::rethrow_exception(error_);
}

void FrameConsumer::finish() {
    end();
    if (error_) std::rethrow_exception(error_);
}

}  // namespace fumon
