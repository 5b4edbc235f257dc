#include "python/drawer.h"

#include <atomic>
#include <map>
#include <memory>
#include <utility>

#include "base/thread_clock.h"
#include "base/worker_pool.h"
#include "python/signal_polling.h"

namespace fumon::python {

namespace {

/// The process that drew first. OpenGL's own threads do not follow a fork, in whatever context.
void check_drawing_process() {
    static std::atomic<pid_t> first{0};
    pid_t none = 0;
    if (first.compare_exchange_strong(none, getpid()) || none == getpid()) return;
    throw Error(
        "this process was forked from one that had drawn, and OpenGL does not follow a fork; let "
        "multiprocessing start processes by \"spawn\" (multiprocessing.get_context(\"spawn\"))");
}

}  // namespace

Drawer::Drawer(Scene scene, std::vector<InputFile> inputs, SharedSnapshot first,
               std::string results)
    : scene_(std::move(scene)),
      inputs_(std::move(inputs)),
      first_(std::move(first)),
      results_(std::move(results)) {}

Drawer::~Drawer() {
    if (!process_.is_this()) static_cast<void>(worker_.release());  // its thread is not here
}

Drawing Drawer::draw(SharedSnapshot snapshot, const MeasuredRows& rows) {
    const auto drawn = std::make_shared<Drawing>();  // the caller may be interrupted before it is
    wait_until_done(Task([snapshot = std::move(snapshot), rows, drawn](const Painter& painter) {
        FramePainter& pictures = painter(PaintedContent::pictures);
        drawn->image = pictures.paint(*snapshot, rows);
        drawn->record = pictures.record();
    }));
    return std::move(*drawn);
}

LayersDrawing Drawer::draw_layers(SharedSnapshot snapshot) {
    const auto drawn = std::make_shared<LayersDrawing>();
    wait_until_done(Task([snapshot = std::move(snapshot), drawn](const Painter& painter) {
        FramePainter& layers = painter(PaintedContent::layers);
        drawn->layers = layers.paint_layers(*snapshot);
        drawn->record = layers.record();
    }));
    return std::move(*drawn);
}

void Drawer::wait_until_done(Task task) {
    process_.check();
    check_drawing_process();
    std::future<void> done = task.get_future();
    Worker& worker = started();
    {
        const std::lock_guard lock(worker.mutex);
        worker.tasks.push_back(std::move(task));
    }
    worker.changed.notify_all();
    wait_for(std::move(done));
}

Drawer::Worker& Drawer::started() {
    const std::lock_guard lock(starting_);
    if (!worker_) {
        worker_ = std::make_unique<Worker>();
        worker_->thread = std::jthread(
            [this, worker = worker_.get()](const std::stop_token& stop) { work(*worker, stop); });
    }
    return *worker_;
}

void Drawer::work(Worker& worker, const std::stop_token& stop) const {
    name_this_thread("fumon-draw");
    WorkerPool pool(0, "fumon-render");
    std::map<PaintedContent, std::unique_ptr<FramePainter>> made;
    const Painter painter = [&](PaintedContent frames) -> FramePainter& {
        std::unique_ptr<FramePainter>& one = made[frames];
        if (!one) one = make_frame_painter(scene_, *first_, gl::Backend::automatic, pool, frames);
        return *one;
    };
    for (;;) {
        Task task;
        {
            std::unique_lock lock(worker.mutex);
            if (!worker.changed.wait(lock, stop, [&] { return !worker.tasks.empty(); })) return;
            task = std::move(worker.tasks.front());
            worker.tasks.pop_front();
        }
        task(painter);
    }
}

}  // namespace fumon::python
