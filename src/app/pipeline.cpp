#include "app/pipeline.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "app/bounded_queue.h"
#include "app/check_finite.h"
#include "app/interrupt.h"
#include "app/picture_text.h"
#include "app/recorder.h"
#include "files/terrain_file.h"
#include "output/movie.h"
#include "output/png.h"
#include "scene/schedule.h"
#include "support/error.h"
#include "support/thread_clock.h"
#include "support/worker_pool.h"

namespace fumon {

namespace {

constexpr std::size_t frames_in_a_queue = 2;  // enough to overlap, few enough for large pictures

using SharedSnapshot = std::shared_ptr<const Snapshot>;

/// What is to be drawn: a step, and the measurements up to it that plots show.
struct Frame {
    SharedSnapshot snapshot;
    MeasuredRows rows;
};

struct Picture {
    std::int64_t number;
    SharedSnapshot snapshot;
    std::shared_ptr<const Image> image;
};

class Stopwatch {
  public:
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// One run under way: the queues, and a method for each stage.
class Pipeline {
  public:
    Pipeline(Model& model, const Scene& scene, const std::vector<InputFile>& inputs,
             RunFolder& folder, const PipelineOptions& options, Progress& progress)
        : model_(model),
          scene_(scene),
          inputs_(inputs),
          folder_(folder),
          options_(options),
          progress_(progress),
          resolved_(resolved_scene(scene, inputs)) {}

    RunOutcome run(const std::function<void(const DrawingRecord&)>& started) {
        const Stopwatch wall;
        const double cpu_before = cpu_seconds_of_process();
        const bool pictures = scene_.output.frames || scene_.output.movie;
        if (pictures) begin_drawing();
        try {
            started(outcome_.drawing);
        } catch (...) {
            abort();
            throw;
        }
        progress_.expect(scene_.run.steps, pictures ? frame_schedule(scene_).count() : 0);
        start("fumon-simulate", [this] { simulate(); });
        if (pictures) start("fumon-encode", [this] { write_pictures(); });
        if (scene_.output.movie) start("fumon-movie", [this] { write_movie(); });
        if (bed_schedule(scene_).count() > 0) start("fumon-beds", [this] { write_beds(); });
        wait_for_all();

        if (outcome_.steps_done < scene_.run.steps) outcome_.signal = interrupting_signal();
        outcome_.error = error_;
        outcome_.timing.wall = wall.seconds();
        outcome_.timing.encoding_wall = pictures_wall_ + movie_wall_;
        outcome_.timing.encoding_cpu = cpu_seconds_of_process() - cpu_before -
                                       outcome_.timing.simulation_cpu -
                                       outcome_.timing.rendering_cpu;
        return std::move(outcome_);
    }

  private:
    // ---- the stages, in the order in which a frame passes them ----

    void simulate() {
        std::optional<Recorder> recorder;
        try {
            recorder.emplace(scene_, model_, resolved_, folder_.records());
            advance(*recorder);
            check_finite(model_.snapshot());
            outcome_.state = state_hash(model_);
        } catch (...) {  // what was made before goes its way: the later stages drain their queues
            remember(std::current_exception());
        }
        outcome_.steps_done = model_.steps_done();
        outcome_.time = model_.time();
        outcome_.timing.simulation_cpu = cpu_seconds_of_threads({"fumon-simulate"});
        to_draw_.close();
        to_beds_.close();
        if (!recorder) return;
        try {
            recorder->commit();
        } catch (...) {
            remember(std::current_exception());
        }
        outcome_.recorded = recorder->recorded();
    }

    void advance(Recorder& recorder) {
        const Schedule frames = frame_schedule(scene_);
        const Schedule beds = bed_schedule(scene_);
        const bool pictures = scene_.output.frames || scene_.output.movie;
        for (;;) {
            const std::int64_t step = model_.steps_done();
            const bool frame = pictures && frames.due(step);
            const bool record = recorder.due(step);
            if (frame || record || beds.due(step)) {
                const auto snapshot = std::make_shared<const Snapshot>(model_.snapshot());
                check_finite(*snapshot);
                if (record) recorder.record(*snapshot);
                if (beds.due(step) && !to_beds_.push(snapshot)) return;
                if (frame && !to_draw_.push({snapshot, recorder.rows()})) return;
            }
            if (step >= scene_.run.steps || interrupting_signal() != 0 || aborted()) return;
            const Stopwatch watch;
            model_.step();
            outcome_.timing.simulation_wall += watch.seconds();
            recorder.note(model_.avalanches());
            progress_.steps_done = model_.steps_done();
        }
    }

    void draw(std::promise<void> ready) {
        WorkerPool pool(options_.threads, "fumon-render");
        std::unique_ptr<FramePainter> painter;
        try {
            painter = make_frame_painter(scene_, model_.snapshot(), options_.backend, pool);
            outcome_.drawing = painter->record();
            ready.set_value();
        } catch (...) {
            ready.set_exception(std::current_exception());
            return;
        }
        std::int64_t number = 0;
        while (const auto frame = to_draw_.pop()) {
            const Stopwatch watch;
            const Picture picture{
                number++, frame->snapshot,
                std::make_shared<const Image>(painter->paint(*frame->snapshot, frame->rows))};
            outcome_.timing.rendering_wall += watch.seconds();
            if (!to_pictures_.push(picture)) break;
            if (scene_.output.movie && !to_movie_.push(picture)) break;
        }
        outcome_.timing.rendering_cpu = cpu_seconds_of_threads({"fumon-render", "llvmpipe"});
        to_pictures_.close();
        to_movie_.close();
    }

    void write_pictures() {
        while (const auto picture = to_pictures_.pop()) {
            const Stopwatch watch;
            const Sha256 pixels = pixel_hash(*picture->image);
            const Snapshot& snapshot = *picture->snapshot;
            if (scene_.output.frames) {
                const auto texts = picture_text(resolved_, scene_, snapshot.step, inputs_, pixels,
                                                outcome_.drawing.environment);
                write_file(folder_.frame(picture->number),
                           encode_png(*picture->image, scene_.view.image.dots_per_inch, texts));
            }
            outcome_.frames.push_back({picture->number, snapshot.step, snapshot.time, pixels});
            ++progress_.frames_done;
            pictures_wall_ += watch.seconds();
        }
    }

    void write_movie() {
        const OutputSettings& output = scene_.output;
        Movie movie(folder_.movie(), static_cast<int>(scene_.view.image.width),
                    static_cast<int>(scene_.view.image.height), output.movie_rate,
                    static_cast<int>(output.movie_quality));
        std::int64_t frames = 0;
        while (const auto picture = to_movie_.pop()) {
            const Stopwatch watch;
            movie.add(*picture->image);
            ++frames;
            movie_wall_ += watch.seconds();
        }
        const Stopwatch watch;
        movie.finish();
        movie_wall_ += watch.seconds();
        outcome_.movie = {frames, movie.padded_width(), movie.padded_height()};
    }

    void write_beds() {
        while (const auto popped = to_beds_.pop()) {
            const Snapshot& snapshot = **popped;
            Grid heights =
                snapshot.bed;  // in metres where there are metres, as terrain files are read
            for (double& height : heights.values()) height *= snapshot.scale.height_unit;
            write_file(folder_.bed(snapshot.step),
                       esri_ascii(heights, snapshot.nodata, snapshot.scale.dx, snapshot.scale.dy));
            outcome_.bed_steps.push_back(snapshot.step);
        }
    }

    // ---- starting, failing, ending ----

    /// Starts the drawing thread and waits until it can draw. Throws what keeps it from that.
    void begin_drawing() {
        std::promise<void> ready;
        auto is_ready = ready.get_future();
        start("fumon-render", [this, promise = std::make_shared<std::promise<void>>(
                                         std::move(ready))] { draw(std::move(*promise)); });
        is_ready.get();
    }

    template <class Body>
    void start(const std::string& name, Body body) {
        {
            const std::lock_guard lock(mutex_);
            ++running_;
        }
        threads_.emplace_back([this, name, body] {
            name_this_thread(name);
            try {
                body();
            } catch (...) {
                remember(std::current_exception());
                abort();
            }
            const std::lock_guard lock(mutex_);
            if (--running_ == 0) all_done_.notify_all();
        });
    }

    void remember(const std::exception_ptr& error) {
        const std::lock_guard lock(mutex_);
        if (!error_) error_ = error;
    }

    void abort() {
        {
            const std::lock_guard lock(mutex_);
            aborted_ = true;
        }
        to_draw_.abort();
        to_beds_.abort();
        to_pictures_.abort();
        to_movie_.abort();
    }

    [[nodiscard]] bool aborted() {
        const std::lock_guard lock(mutex_);
        return aborted_;
    }

    void wait_for_all() {
        constexpr std::chrono::milliseconds between_looks{50};
        std::unique_lock lock(mutex_);
        while (!all_done_.wait_for(lock, between_looks, [this] { return running_ == 0; })) {
            lock.unlock();
            progress_.show();
            lock.lock();
        }
        lock.unlock();
        threads_.clear();
    }

    Model& model_;
    const Scene& scene_;
    const std::vector<InputFile>& inputs_;
    RunFolder& folder_;
    PipelineOptions options_;
    Progress& progress_;
    std::string resolved_;
    RunOutcome outcome_;
    double pictures_wall_ = 0.0;  // of two threads, added up at the end
    double movie_wall_ = 0.0;

    BoundedQueue<Frame> to_draw_{frames_in_a_queue};
    BoundedQueue<SharedSnapshot> to_beds_{frames_in_a_queue};
    BoundedQueue<Picture> to_pictures_{frames_in_a_queue};
    BoundedQueue<Picture> to_movie_{frames_in_a_queue};

    std::mutex mutex_;
    std::condition_variable all_done_;
    int running_ = 0;
    bool aborted_ = false;
    std::exception_ptr error_;
    std::vector<std::jthread> threads_;  // last: joined before what they use goes
};

}  // namespace

RunOutcome run_pipeline(Model& model, const Scene& scene, const std::vector<InputFile>& inputs,
                        RunFolder& folder, const PipelineOptions& options, Progress& progress,
                        const std::function<void(const DrawingRecord&)>& started) {
    return Pipeline(model, scene, inputs, folder, options, progress).run(started);
}

}  // namespace fumon
