// A run as stages, each a thread of its own, with bounded queues between them:
//
//                     +-> to_beds_ -> fumon-beds                                beds/
//   fumon-simulate ---+
//     model           +-> to_draw_ -> fumon-render -+-> to_frames_ -> fumon-encode   frames/
//                     |                 painter     +-> to_movie_ --> fumon-movie    movie.mp4
//                     +-> fumon-record, one snapshot at a time        measurements.csv …
//
// 1. Queues hold two items. A full one makes the stage before it wait, so memory does not grow with
//    the number of frames, and nothing is dropped.
// 2. Snapshots and images go through as shared pointers to const: no stage copies them, and frames
//    and movie share a picture.
// 3. The drawing thread, to which OpenGL belongs, makes its painter first: `started` is called, and
//    the other stages begin, only when drawing is known to work. Nothing is written before.
// 4. The end runs downstream: a stage that has sent all closes its queues, the next one empties
//    them and ends.
// 5. The first error of a stage is kept and aborts all queues. An error of the simulation itself is
//    kept only: what was made before it still reaches its files.
// 6. A signal stops the simulation between two steps; frames under way are finished. A step that
//    does not end in time is cancelled (base/cancellation.h), and there is no state then.
// 7. A checkpoint waits until all that was sent is written (Recorder, WrittenOutputs), so that it
//    never counts a row or frame that is not on disk. A resumed movie begins with frames on disk.

#include "run/pipeline.h"

#include <fmt/format.h>

#include <future>
#include <memory>
#include <utility>

#include "base/cancellation.h"
#include "base/stopwatch.h"
#include "base/thread_clock.h"
#include "base/worker_pool.h"
#include "files/atomic_file.h"
#include "files/terrain/terrain_format.h"
#include "models/shared/check_finite.h"
#include "models/shared/state_hash.h"
#include "picture/movie.h"
#include "picture/png.h"
#include "render/colour/colouring.h"
#include "run/bounded_queue.h"
#include "run/output_files.h"
#include "run/picture_text.h"
#include "run/stage_threads.h"
#include "run/step_observers.h"
#include "run/terminal/interrupt.h"
#include "run/terminal/job_watch.h"
#include "run/written_outputs.h"
#include "scene/read.h"

namespace fumon {

namespace {

constexpr std::size_t queue_capacity = 2;  // enough to overlap, few enough for large pictures

/// What is to be drawn: a step, and the measurements up to it that plots show.
struct Frame {
    SharedSnapshot snapshot;
    MeasuredRows rows;
};

/// One run under way: the queues, and a method for each stage.
class Pipeline {
  public:
    Pipeline(Model& model, const Scene& scene, const std::vector<InputFile>& inputs,
             const RunOutputs& outputs, const PipelineOptions& options, Progress& progress)
        : model_(model),
          scene_(scene),
          inputs_(inputs),
          folder_(outputs.folder),
          movie_(outputs.movie),
          options_(options),
          progress_(progress),
          clock_(options.checkpoint_minutes),
          parts_(folder_ == nullptr ? RunParts{} : run_parts(scene, options.checkpoint_minutes)),
          pictures_(parts_.frames || movie_),
          last_step_(options.last_step.value_or(scene.run.steps)),
          resolved_(resolved_scene(scene, inputs)),
          first_(options.previous != nullptr ? options.previous->first : model.snapshot()),
          written_(options.previous != nullptr ? options.previous->checkpoint.beds
                                               : std::vector<BedRecord>{}) {
        if (options.previous == nullptr) return;
        const RunCheckpoint& previous = options.previous->checkpoint;
        previous_frames_ = previous.frames;
        outcome_.steps_before = previous.step;
        outcome_.resumed_at = previous.resumed_at;
        outcome_.resumed_at.push_back(previous.step);
        outcome_.checkpoint = previous.step;
        progress.steps_done = previous.step;
        progress.frames_done = previous_frames_.frames;
    }

    RunOutcome run(const std::function<void(const DrawingRecord&)>& started) {
        const Stopwatch wall;
        const double cpu_before = cpu_seconds_of_process();
        if (pictures_) begin_drawing();
        try {
            started(outcome_.drawing);
        } catch (...) {
            stages_.abort();
            throw;
        }
        if (pictures_ && folder_ != nullptr)
            stages_.guard(
                [this] { written_.list_frames(folder_->frame_list(), previous_frames_); });
        progress_.expect(last_step_, pictures_ ? frame_schedule(scene_).count() : 0);
        stages_.start("fumon-simulate", [this] { simulate(); });
        if (pictures_) stages_.start("fumon-encode", [this] { write_frames(); });
        if (movie_) stages_.start("fumon-movie", [this] { write_movie(); });
        if (parts_.beds) stages_.start("fumon-beds", [this] { write_beds(); });
        stages_.wait(progress_);
        stages_.guard([this] { written_.frames().commit(); });

        outcome_.error = stages_.error();
        if (outcome_.steps_done < last_step_ || outcome_.cancelled)
            outcome_.signal = interrupting_signal();
        outcome_.frames = written_.frames().frames();
        outcome_.beds = written_.beds();
        Timing& timing = outcome_.timing;
        timing.wall = wall.seconds();
        timing.encoding_wall = frames_wall_ + movie_wall_;
        timing.encoding_cpu =
            cpu_seconds_of_process() - cpu_before - timing.simulation_cpu - timing.rendering_cpu;
        return std::move(outcome_);
    }

  private:
    // ---- the stages, in the order in which a frame passes them ----

    void simulate() {
        std::unique_ptr<Recorder> recorder;
        try {
            recorder = make_recorder();
            if (options_.previous != nullptr) recorder->serialise(options_.previous->measured);
            const bool at_end = advance(*recorder) == 0;
            if (!at_end && !outcome_.cancelled) check_finite(model_.snapshot());
            if (!outcome_.cancelled) {
                outcome_.state = state_hash(model_);
                outcome_.plausibility_warning = model_.plausibility_warning();
                if (!outcome_.plausibility_warning.empty())
                    stages_.report("implausible: " + outcome_.plausibility_warning);
            }
        } catch (const Cancelled&) {
            outcome_.cancelled = true;
        } catch (...) {  // what was made before goes its way: the later stages drain their queues
            stages_.keep(std::current_exception());
        }
        outcome_.steps_done = model_.steps_done();
        outcome_.time = model_.time();
        outcome_.timing.simulation_cpu = cpu_seconds_of_threads({"fumon-simulate", "fumon-record"});
        to_draw_.close();
        to_beds_.close();
        if (!recorder) return;
        try {
            recorder->commit();
        } catch (...) {
            stages_.keep(std::current_exception());
        }
        outcome_.recorded = recorder->recorded();
    }

    /// Returns the signal that interrupted it, or 0.
    int advance(Recorder& recorder) {
        ScheduledSnapshots beds(parts_.beds ? bed_schedule(scene_) : Schedule{},
                                [&](const auto& snapshot) {
                                    if (to_beds_.push(snapshot)) written_.send_bed();
                                });
        ScheduledSnapshots frames(pictures_ ? frame_schedule(scene_) : Schedule{},
                                  [&](const auto& snapshot) {
                                      if (to_draw_.push({snapshot, recorder.rows()}))
                                          written_.send_frame();
                                  });
        StepCounter count(progress_);
        WatchedState watched(progress_.watch(), last_step_);
        PlausibilityReporter plausibility_warning(
            [this](const std::string& line) { stages_.report("implausible: " + line); });
        std::vector<StepObserver*> observers{&recorder, &beds, &frames, &plausibility_warning};
        std::optional<Checkpointer> checkpoints;
        if (progress_.watch() != nullptr) observers.push_back(&watched);
        if (folder_ != nullptr && clock_.on()) {
            checkpoints.emplace(*folder_, parts_, clock_, checkpoint_facts(), written_, recorder,
                                [this](const std::string& line) { stages_.report(line); });
            observers.push_back(&*checkpoints);
        }
        observers.push_back(&count);
        Stepper stepper(model_, observers, options_.previous != nullptr);
        const struct Ended {
            RunOutcome& outcome;
            const Stepper& stepper;
            const std::optional<Checkpointer>& checkpoints;
            ~Ended() {
                outcome.timing.simulation_wall = stepper.seconds();
                outcome.cancelled = stepper.cancelled();
                if (checkpoints && checkpoints->last()) outcome.checkpoint = checkpoints->last();
            }
        } ended{outcome_, stepper, checkpoints};
        const int signal = stepper.advance([this](const Model& model) {
            return model.steps_done() >= last_step_ || stages_.aborted();
        });
        if (checkpoints && signal == 0 && !stages_.aborted())
            outcome_.keeps_last_state = checkpoints->keep_last_state(model_);
        return signal;
    }

    void draw(std::promise<void> ready) {
        WorkerPool pool(options_.threads, "fumon-render");
        const bool layers = parts_.frames && scene_.output.exr_frames;
        Scene drawn = scene_;
        std::shared_ptr<const std::string> resolved;  // with colours that are kept
        std::unique_ptr<FramePainter> painter;
        try {
            if (const auto previous = previous_look()) {
                drawn.view.look.low = previous->low;
                drawn.view.look.high = previous->high;
                resolved = std::make_shared<const std::string>(resolved_scene(drawn, inputs_));
            }
            painter = make_frame_painter(
                drawn, first_, options_.backend, pool,
                layers ? PaintedContent::pictures_and_layers : PaintedContent::pictures);
            painter->keep_colours();
            outcome_.drawing = painter->record();
            ready.set_value();
        } catch (...) {
            ready.set_exception(std::current_exception());
            return;
        }
        std::int64_t number = previous_frames_.frames;
        while (const auto frame = to_draw_.pop()) {
            const Stopwatch watch;
            Picture picture{
                number++, frame->snapshot,
                std::make_shared<const Image>(painter->paint(*frame->snapshot, frame->rows)),
                nullptr, resolved};
            if (const FrameColourRange colours = painter->frame_colour_range();
                colours.kept && !resolved) {
                Scene kept = scene_;
                kept.view.look.low = colours.low;
                kept.view.look.high = colours.high;
                resolved = std::make_shared<const std::string>(resolved_scene(kept, inputs_));
                picture.resolved = resolved;
            }
            if (layers)
                picture.layers =
                    std::make_shared<const LayeredImage>(painter->paint_layers(*frame->snapshot));
            outcome_.timing.rendering_wall += watch.seconds();
            progress_.seconds_of_frames += watch.seconds();
            if (JobWatch* const job = progress_.watch(); job != nullptr && job->wants_picture()) {
                job->show(picture.image,
                          fmt::format("frame {}, step {}", picture.number, picture.snapshot->step));
            }
            if (!to_frames_.push(picture)) break;
            if (movie_ && !to_movie_.push(picture)) break;
        }
        outcome_.timing.rendering_cpu = cpu_seconds_of_threads({"fumon-render", "llvmpipe"});
        to_frames_.close();
        to_movie_.close();
    }

    void write_frames() {
        const PictureFacts facts{resolved_, scene_, inputs_, outcome_.drawing.environment};
        while (const auto picture = to_frames_.pop()) {
            const Stopwatch watch;
            const FrameRecord record = write_frame(folder_, parts_, *picture, facts);
            ++progress_.frames_done;
            frames_wall_ += watch.seconds();
            written_.add_frame(record);
        }
    }

    void write_movie() {
        const OutputSettings& output = scene_.output;
        Movie movie(*movie_, static_cast<int>(scene_.view.image.width),
                    static_cast<int>(scene_.view.image.height), output.movie_rate,
                    static_cast<int>(output.movie_quality));
        std::int64_t frames = 0;
        if (previous_frames_.frames > 0) {
            FrameListReader previous(folder_->frame_list());
            for (; frames < previous_frames_.frames; ++frames)
                movie.add(read_frame(*folder_, parts_, previous.next()));
        }
        while (const auto picture = to_movie_.pop()) {
            const Stopwatch watch;
            movie.add(*picture->image);
            ++frames;
            movie_wall_ += watch.seconds();
        }
        PictureText texts = own_text();  // where the run broke off
        if (written_.wait_for_all())
            texts = movie_text(resolved_, scene_, inputs_, written_.frames(),
                               outcome_.drawing.environment);
        const Stopwatch watch;
        movie.finish(texts);
        movie_wall_ += watch.seconds();
        outcome_.movie = {frames, movie.padded_width(), movie.padded_height()};
    }

    void write_beds() {
        while (const auto snapshot = to_beds_.pop()) {
            written_.add_bed(write_bed(*folder_, **snapshot, scene_.output.bed_format));
        }
    }

    // ---- what they need, and how they end ----

    /// Starts the drawing thread and waits until it is ready. Rethrows the error that keeps it from
    /// drawing.
    void begin_drawing() {
        std::promise<void> ready;
        auto is_ready = ready.get_future();
        auto promise = std::make_shared<std::promise<void>>(std::move(ready));
        stages_.start("fumon-render", [this, promise] { draw(std::move(*promise)); });
        is_ready.get();
    }

    [[nodiscard]] std::unique_ptr<Recorder> make_recorder() const {
        Recording recording;
        if (folder_ != nullptr) recording.files = folder_->records();
        recording.resolved = resolved_;
        recording.plots = pictures_;
        recording.threads = options_.threads;
        std::optional<RecordPositions> previous;
        if (options_.previous != nullptr) {
            previous = options_.previous->checkpoint.records;
            recording.longer = options_.previous->is_longer;
        }
        return std::make_unique<Recorder>(scene_, first_, std::move(recording), previous);
    }

    /// What all checkpoints of the run hold.
    [[nodiscard]] RunCheckpoint checkpoint_facts() const {
        RunCheckpoint facts;
        facts.scene = resolved_;
        facts.inputs = inputs_;
        facts.drawing = environment_text(outcome_.drawing.environment);
        facts.resumed_at = outcome_.resumed_at;
        return facts;
    }

    /// The look of the last frame of a former run, where it has a range of colours that this one
    /// goes on with.
    [[nodiscard]] std::optional<LookSettings> previous_look() const {
        const LookSettings& look = scene_.view.look;
        const bool kept = ranges_by_values(look) && look.range == ColourSpan::run;
        if (!kept || previous_frames_.frames == 0) return std::nullopt;
        const std::int64_t last = previous_frames_.frames - 1;
        const std::filesystem::path file =
            parts_.frames ? folder_->frame(last) : folder_->movie_frame(last);
        if (!parts_.frames && read_png_texts(file).empty()) return std::nullopt;
        const LookSettings then = parse_scene(read_origin(file).scene, file.string(), "").view.look;
        if (then.low.is_word() || then.high.is_word()) return std::nullopt;
        return then;
    }

    void stop() {
        written_.abort();
        to_draw_.abort();
        to_beds_.abort();
        to_frames_.abort();
        to_movie_.abort();
    }

    Model& model_;
    const Scene& scene_;
    const std::vector<InputFile>& inputs_;
    RunFolder* folder_;  ///< none: nothing but the movie is written
    std::optional<std::filesystem::path> movie_;
    PipelineOptions options_;
    Progress& progress_;
    CheckpointClock clock_;
    RunParts parts_;
    bool pictures_;
    std::int64_t last_step_;
    std::string resolved_;
    Snapshot first_;
    WrittenOutputs written_;
    RunOutcome outcome_;
    FrameCount previous_frames_;
    double frames_wall_ = 0.0;  // of two threads, added up at the end
    double movie_wall_ = 0.0;

    BoundedQueue<Frame> to_draw_{queue_capacity};
    BoundedQueue<SharedSnapshot> to_beds_{queue_capacity};
    BoundedQueue<Picture> to_frames_{queue_capacity};
    BoundedQueue<Picture> to_movie_{queue_capacity};

    StageThreads stages_{[this] { stop(); }};  // last: joined before what they use goes
};

}  // namespace

RunOutputs outputs_in(RunFolder& folder, const Scene& scene) {
    RunOutputs outputs{&folder};
    if (scene.output.movie) outputs.movie = folder.movie();
    return outputs;
}

std::string padding_text(const std::string& file, const MovieRecord& movie,
                         const ImageSettings& frames) {
    if (movie.frames == 0 || (movie.width == frames.width && movie.height == frames.height))
        return {};
    return fmt::format(
        "{} is {} x {}: H.264 needs even sides, so the edge of the {} x {} frames is repeated",
        file, movie.width, movie.height, frames.width, frames.height);
}

RunOutcome run_pipeline(Model& model, const Scene& scene, const std::vector<InputFile>& inputs,
                        const RunOutputs& outputs, const PipelineOptions& options,
                        Progress& progress,
                        const std::function<void(const DrawingRecord&)>& started) {
    return Pipeline(model, scene, inputs, outputs, options, progress).run(started);
}

}  // namespace fumon
