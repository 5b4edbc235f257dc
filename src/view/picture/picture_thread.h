#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "run/terminal/work_options.h"
#include "view/picture/camera_pose.h"
#include "view/picture/look_changes.h"
#include "view/subject/subject.h"

namespace fumon {

class DraftPainter;
class WorkerPool;

/// A picture that a client asks for.
struct ViewRequest {
    std::string client;
    std::vector<std::string> settings{};  ///< of the page
    std::size_t moment = 0;
    int width = 0;  ///< pixels: of a draft at most, of a picture exactly; 0: the scene's
    int height = 0;
    bool draft = false;
    std::optional<CameraPlace> place{};
    std::string ending = ".png";  ///< of a picture
};

enum class RequestOutcome { drawn, superseded, computing, too_many };

struct DrawnPicture {
    RequestOutcome outcome = RequestOutcome::drawn;
    std::string type{};  ///< of its media: "image/png"
    std::string bytes{};
    std::vector<std::string> camera{};  ///< the settings of the place that was asked for
    std::int64_t step = 0;
    double seconds = 0.0;  ///< that drawing took
};

/// The threads that draw, one for drafts and one for pictures, each with an OpenGL context of its
/// own: a draft waits for no picture. Of each client the newest request alone is drawn. A picture
/// is made as `fumon still` makes it, and has its bytes.
class PictureThread {
  public:
    /// Subject and changes outlive it.
    PictureThread(ViewSubject& subject, const LookChanges& changes, const WorkOptions& work);
    ~PictureThread();
    PictureThread(const PictureThread&) = delete;
    PictureThread& operator=(const PictureThread&) = delete;

    /// Waits until the request is drawn or given up. Any thread may call it. Throws InputError
    /// where settings, moment or format are wrong, and what drawing throws.
    DrawnPicture draw(ViewRequest request);

    /// Gives up what waits, and all that is asked for from now on; what is being drawn is finished.
    void cancel_all();

    /// The scene of a request with its place and size, and the settings of the place. Throws
    /// likewise.
    struct Settled {
        Scene scene;
        std::vector<std::string> camera;
    };
    [[nodiscard]] Settled settled(const ViewRequest& request, const Snapshot& snapshot) const;

  private:
    struct Waiting {
        ViewRequest request;
        std::promise<DrawnPicture> promise;
    };

    void work(bool of_drafts);
    DrawnPicture drawn(const ViewRequest& request, DraftPainter& drafts, WorkerPool& pool);

    ViewSubject& subject_;
    const LookChanges& changes_;
    WorkOptions options_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<Waiting> waiting_;
    bool ended_ = false;
    std::thread drafts_;
    std::thread pictures_;
};

}  // namespace fumon
