#pragma once

#include <exception>
#include <functional>
#include <thread>

#include "base/image.h"
#include "run/bounded_queue.h"

namespace fumon {

/// Uses the frames of a film, one after the other, on a thread of its own, while the next one is
/// drawn. One frame at most waits.
class FrameConsumer {
  public:
    using Use = std::function<void(const Image&)>;

    explicit FrameConsumer(Use use);
    ~FrameConsumer();  ///< uses what waits first
    FrameConsumer(const FrameConsumer&) = delete;
    FrameConsumer& operator=(const FrameConsumer&) = delete;

    /// Waits for room. Throws what the use of an earlier frame threw; none is used after that.
    void add(Image image);
    /// Waits until all frames are used. Throws likewise.
    void finish();

  private:
    void work();
    void end();

    Use use_;
    BoundedQueue<Image> waiting_;
    std::exception_ptr error_;  // written before the queue is aborted or the thread ends
    std::jthread thread_;       // last: it uses the others
};

}  // namespace fumon
