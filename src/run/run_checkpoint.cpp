#include "run/run_checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/checkpoint.h"

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

void carry_count(FrameCount& count, StateCarrier& carrier) {
    carrier.count("frames", count.frames);
    std::string hash(count.hash.begin(), count.hash.end());
    carrier.text("frames_sha256", hash);
    if (hash.size() != count.hash.size()) carrier.refuse("the hash of its frames is no SHA-256");
    std::copy(hash.begin(), hash.end(), count.hash.begin());
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
    carry_count(frames, carrier);
    carrier.list("bed_steps", bed_steps);
    carrier.list("resumed_at", resumed_at);
}

Checkpointer::Checkpointer(const RunFolder& folder, const RunParts& parts,
                           const CheckpointClock& clock, RunCheckpoint fixed,
                           WrittenOutputs& written, Recorder& recorder,
                           std::function<void(const std::string&)> tell)
    : folder_(folder),
      parts_(parts),
      clock_(clock),
      now_(std::move(fixed)),
      written_(written),
      recorder_(recorder),
      tell_(std::move(tell)),
      frames_on_disk_(written.frames().frames()),
      beds_on_disk_(written.bed_steps().size()) {}

void Checkpointer::before_step(Model& model, bool interrupted) {
    if (!clock_.on() || !(interrupted || clock_.due())) return;
    if (!written_.wait_for_all()) return;
    try {
        write(model);
        last_ = model.steps_done();
    } catch (const Error& fault) {
        tell_(fmt::format("no checkpoint of step {}: {}; the run goes on", model.steps_done(),
                          fault.what()));
    }
}

void Checkpointer::write(Model& model) {
    clock_.begin();
    const struct Ended {
        CheckpointClock& clock;
        ~Ended() { clock.end(); }
    } ended{clock_};
    put_on_disk();
    now_.version = FUMON_VERSION;
    now_.step = model.steps_done();
    now_.frames = written_.frames().sync();
    now_.bed_steps = written_.bed_steps();
    now_.records = recorder_.sync();
    CheckpointWriter writer(folder_.checkpoint());
    now_.carry(writer);
    model.carry(writer);
    recorder_.carry(writer);
    writer.commit();
}

void Checkpointer::put_on_disk() {
    if (!last_) {  // the folder itself, and what tells it for a run's
        sync_file(folder_.manifest());
        const auto whole = std::filesystem::absolute(folder_.manifest());
        for (auto path = whole.parent_path(); path.has_relative_path(); path = path.parent_path())
            sync_folder_of(path);
    }
    for (; frames_on_disk_ < written_.frames().frames(); ++frames_on_disk_) {
        if (parts_.frames) sync_file(folder_.frame(frames_on_disk_));
        if (parts_.movie_frames) sync_file(folder_.movie_frame(frames_on_disk_));
    }
    for (; beds_on_disk_ < written_.bed_steps().size(); ++beds_on_disk_) {
        for (const auto& bed : folder_.beds(written_.bed_steps()[beds_on_disk_])) sync_file(bed);
    }
    if (parts_.frames) sync_folder_of(folder_.frame(0));
    if (parts_.movie_frames) sync_folder_of(folder_.movie_frame(0));
    if (parts_.beds) sync_folder_of(folder_.bed(0, ""));
}

void CheckpointClock::end() {
    constexpr double least_ratio = 50.0;  // of a run's seconds to those of its checkpoints
    wait_ = std::max(interval_, least_ratio * since_begin_.seconds());
    since_last_ = {};
}

}  // namespace fumon
