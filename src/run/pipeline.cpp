#include "run/pipeline.h"

#include <fmt/format.h>

#include <cmath>
#include <condition_variable>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "base/thread_clock.h"
#include "base/worker_pool.h"
#include "files/atomic_file.h"
#include "files/terrain/terrain_format.h"
#include "models/shared/state_hash.h"
#include "picture/movie.h"
#include "picture/png.h"
#include "run/bounded_queue.h"
#include "run/check_finite.h"
#include "run/interrupt.h"
#include "run/picture_text.h"
#include "run/recorder.h"
#include "scene/schedule.h"

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
          parts_(run_parts(scene, options.checkpoint_minutes)),
          last_step_(options.last_step.value_or(scene.run.steps)),
          resolved_(options.resolved.empty() ? resolved_scene(scene, inputs) : options.resolved),
          first_(options.former != nullptr ? options.former->first : model.snapshot()),
          checkpoints_(folder, parts_, options.checkpoint_minutes) {
        if (options.former == nullptr) return;
        const RunCheckpoint& former = options.former->checkpoint;
        outcome_.frames = former.frames;
        outcome_.bed_steps = former.bed_steps;
        outcome_.steps_before = former.step;
        outcome_.resumed_at = former.resumed_at;
        outcome_.resumed_at.push_back(former.step);
        outcome_.checkpoint = former.step;
        frames_taken_ = outcome_.frames.size();
        beds_taken_ = outcome_.bed_steps.size();
        checkpoints_.skip(frames_taken_, beds_taken_);
        progress.steps_done = former.step;
        progress.frames_done = std::ssize(former.frames);
    }

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
        progress_.expect(last_step_, pictures ? frame_schedule(scene_).count() : 0);
        start("fumon-simulate", [this] { simulate(); });
        if (pictures) start("fumon-encode", [this] { write_pictures(); });
        if (scene_.output.movie) start("fumon-movie", [this] { write_movie(); });
        if (bed_schedule(scene_).count() > 0) start("fumon-beds", [this] { write_beds(); });
        wait_for_all();

        if (outcome_.steps_done < last_step_) outcome_.signal = interrupting_signal();
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
            std::optional<RecordPositions> former;
            if (options_.former != nullptr) former = options_.former->checkpoint.records;
            recorder.emplace(scene_, first_, resolved_, folder_.records(), former);
            if (former) recorder->carry(options_.former->measured);
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
        for (bool told = options_.former != nullptr;; told = false) {
            const std::int64_t step = model_.steps_done();
            const bool frame = !told && pictures && frames.due(step);
            const bool bed = !told && beds.due(step);
            const bool record = !told && recorder.due(step);
            if (frame || record || bed) {
                const auto snapshot = std::make_shared<const Snapshot>(model_.snapshot());
                check_finite(*snapshot);
                if (record) recorder.record(*snapshot);
                if (bed && !to_beds_.push(snapshot)) return;
                if (frame && !to_draw_.push({snapshot, recorder.rows()})) return;
                frames_taken_ += frame ? 1 : 0;
                beds_taken_ += bed ? 1 : 0;
            }
            if (step >= last_step_ || aborted()) return;
            const bool stop = interrupting_signal() != 0;
            if (checkpoints_.on() && (stop || checkpoints_.due())) save_checkpoint(recorder);
            if (stop) return;
            const Stopwatch watch;
            model_.step();
            outcome_.timing.simulation_wall += watch.seconds();
            recorder.note(model_.avalanches());
            progress_.steps_done = model_.steps_done();
        }
    }

    /// A disk that is full for a checkpoint does not end the run: the former one stays.
    void save_checkpoint(Recorder& recorder) {
        if (!wait_until_written(frames_taken_, beds_taken_)) return;
        RunCheckpoint now;
        now.scene = resolved_;
        now.inputs = inputs_;
        now.drawing = environment_text(outcome_.drawing.environment);
        now.resumed_at = outcome_.resumed_at;
        {
            const std::lock_guard lock(mutex_);
            now.frames = outcome_.frames;
            now.bed_steps = outcome_.bed_steps;
        }
        try {
            checkpoints_.write(std::move(now), model_, recorder);
            outcome_.checkpoint = model_.steps_done();
        } catch (const Error& fault) {
            tell(fmt::format("no checkpoint of step {}: {}; the run goes on", model_.steps_done(),
                             fault.what()));
        }
    }

    void draw(std::promise<void> ready) {
        WorkerPool pool(options_.threads, "fumon-render");
        std::unique_ptr<FramePainter> painter;
        try {
            painter = make_frame_painter(scene_, first_, options_.backend, pool);
            outcome_.drawing = painter->record();
            ready.set_value();
        } catch (...) {
            ready.set_exception(std::current_exception());
            return;
        }
        auto number = static_cast<std::int64_t>(frames_before());
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
            const auto write = [&](const std::filesystem::path& file, const PictureText& texts) {
                write_file(file,
                           encode_png(*picture->image, scene_.view.image.dots_per_inch, texts));
            };
            if (parts_.frames) {
                write(folder_.frame(picture->number),
                      picture_text(resolved_, scene_, snapshot.step, inputs_, pixels,
                                   outcome_.drawing.environment));
            }
            if (parts_.kept_frames) write(folder_.kept_frame(picture->number), {});
            ++progress_.frames_done;
            pictures_wall_ += watch.seconds();
            const std::lock_guard lock(mutex_);
            outcome_.frames.push_back({picture->number, snapshot.step, snapshot.time, pixels});
            written_.notify_all();
        }
    }

    void write_movie() {
        const OutputSettings& output = scene_.output;
        Movie movie(options_.movie.value_or(folder_.movie()),
                    static_cast<int>(scene_.view.image.width),
                    static_cast<int>(scene_.view.image.height), output.movie_rate,
                    static_cast<int>(output.movie_quality));
        std::int64_t frames = 0;
        for (; std::cmp_less(frames, frames_before()); ++frames)
            movie.add(read_frame(folder_, parts_, options_.former->checkpoint, frames));
        while (const auto picture = to_movie_.pop()) {
            const Stopwatch watch;
            movie.add(*picture->image);
            ++frames;
            movie_wall_ += watch.seconds();
        }
        PictureText texts;  // none where the run broke off
        if (wait_until_written(static_cast<std::size_t>(frames), 0))
            texts = movie_text(resolved_, scene_, inputs_, outcome_.frames,
                               outcome_.drawing.environment);
        const Stopwatch watch;
        movie.finish(texts);
        movie_wall_ += watch.seconds();
        outcome_.movie = {frames, movie.padded_width(), movie.padded_height()};
    }

    void write_beds() {
        while (const auto popped = to_beds_.pop()) {
            const Snapshot& snapshot = **popped;
            for (const TerrainBytes& file : bed_files(snapshot, scene_.output.bed_format))
                write_file(folder_.bed(snapshot.step, file.ending), file.bytes);
            const std::lock_guard lock(mutex_);
            outcome_.bed_steps.push_back(snapshot.step);
            written_.notify_all();
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
            written_.notify_all();
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

    /// Waits until as many frames and beds are written. False when the run was aborted.
    bool wait_until_written(std::size_t frames, std::size_t beds) {
        std::unique_lock lock(mutex_);
        written_.wait(lock, [&] {
            return aborted_ ||
                   (outcome_.frames.size() >= frames && outcome_.bed_steps.size() >= beds);
        });
        return !aborted_;
    }

    [[nodiscard]] std::size_t frames_before() const {
        return options_.former == nullptr ? 0 : options_.former->checkpoint.frames.size();
    }

    /// Has the thread that shows the progress say something lasting, the same thing once.
    void tell(const std::string& line) {
        const std::lock_guard lock(mutex_);
        if (line != told_) to_tell_ = told_ = line;
    }

    void wait_for_all() {
        constexpr std::chrono::milliseconds between_looks{50};
        std::unique_lock lock(mutex_);
        while (!all_done_.wait_for(lock, between_looks, [this] { return running_ == 0; })) {
            const std::string line = std::exchange(to_tell_, {});
            lock.unlock();
            if (!line.empty()) progress_.note(line);
            progress_.show();
            lock.lock();
        }
        if (!to_tell_.empty()) progress_.note(to_tell_);
        lock.unlock();
        threads_.clear();
    }

    Model& model_;
    const Scene& scene_;
    const std::vector<InputFile>& inputs_;
    RunFolder& folder_;
    PipelineOptions options_;
    Progress& progress_;
    RunParts parts_;
    std::int64_t last_step_;
    std::string resolved_;
    Snapshot first_;
    Checkpointer checkpoints_;
    RunOutcome outcome_;
    std::size_t frames_taken_ = 0;  ///< by the simulation, of all steps so far
    std::size_t beds_taken_ = 0;
    double pictures_wall_ = 0.0;  // of two threads, added up at the end
    double movie_wall_ = 0.0;

    BoundedQueue<Frame> to_draw_{frames_in_a_queue};
    BoundedQueue<SharedSnapshot> to_beds_{frames_in_a_queue};
    BoundedQueue<Picture> to_pictures_{frames_in_a_queue};
    BoundedQueue<Picture> to_movie_{frames_in_a_queue};

    std::mutex mutex_;
    std::condition_variable all_done_;
    std::condition_variable written_;
    std::string to_tell_;
    std::string told_;
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
