#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "base/snapshot.h"
#include "python/process.h"
#include "run/still.h"

namespace fumon::python {

/// Draws the snapshots of a run as `fumon still` draws them, on a thread of its own, to which its
/// OpenGL belongs; any thread may ask. The thread starts with the first picture.
class Drawer {
  public:
    /// `first` is the run's first snapshot, by which pictures are framed; `results` as in
    /// StillSubject.
    Drawer(Scene scene, std::vector<InputFile> inputs, SharedSnapshot first,
           std::string results = {});
    ~Drawer();
    Drawer(const Drawer&) = delete;
    Drawer& operator=(const Drawer&) = delete;

    /// The caller does not hold the interpreter's lock. Throws as FramePainter does, Error in a
    /// fork of a process that has drawn, and as check_signals().
    [[nodiscard]] Drawing draw(SharedSnapshot snapshot, const MeasuredRows& rows);
    /// Its light and layers, without overlays. Throws likewise, KeyError for a flat figure.
    [[nodiscard]] LayersDrawing draw_layers(SharedSnapshot snapshot);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const std::vector<InputFile>& inputs() const { return inputs_; }
    [[nodiscard]] const SharedSnapshot& first() const { return first_; }
    [[nodiscard]] const std::string& results() const { return results_; }

  private:
    /// The painter of pictures or that of layers, made when it is first asked for.
    using Painter = std::function<FramePainter&(PaintedContent)>;
    using Task = std::packaged_task<void(const Painter&)>;
    struct Worker {
        std::mutex mutex;
        std::condition_variable_any changed;
        std::deque<Task> tasks;
        std::jthread thread;  // last: joined before what it uses goes
    };

    void work(Worker& worker, const std::stop_token& stop) const;
    Worker& started();
    void wait_until_done(Task task);

    Scene scene_;
    std::vector<InputFile> inputs_;
    SharedSnapshot first_;
    std::string results_;
    Process process_;
    std::mutex starting_;
    std::unique_ptr<Worker> worker_;
};

}  // namespace fumon::python
