#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <future>
#include <optional>

#include "base/worker_pool.h"
#include "render/ready_picture.h"

namespace fumon {

/// A picture of one run at a moment of a shot.
struct PictureRequest {
    std::size_t run = 0;
    std::size_t shot = 0;
    double share = 0.0;      ///< of the shot
    std::int64_t frame = 0;  ///< of the film, where something moves in each; else 0

    friend bool operator==(const PictureRequest&, const PictureRequest&) = default;
};

/// Finds what the next picture of a film needs besides OpenGL while the present one is drawn.
class PicturePrefetch {
  public:
    /// How it is found, with the threads of a pool.
    using Find = std::function<ReadyPicture(WorkerPool& pool)>;

    /// With one thread nothing is found ahead.
    explicit PicturePrefetch(int threads);

    /// Begins with a picture. None is under way.
    void begin(const PictureRequest& wanted, Find find);
    /// The picture that begin() began with, if it is this one. Waits for it, and throws what
    /// finding it threw. None is under way then.
    std::optional<ReadyPicture> take(const PictureRequest& wanted);
    /// Waits for the picture that is under way, if any, which nobody wants.
    void wait_idle();

  private:
    std::optional<WorkerPool> pool_;
    PictureRequest wanted_;
    std::future<ReadyPicture> found_;  // last: it uses the pool
};

}  // namespace fumon
