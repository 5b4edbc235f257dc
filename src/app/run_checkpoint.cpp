#include "app/run_checkpoint.h"

#include <algorithm>
#include <tuple>

#include "app/run_folder.h"
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

/// Frames are numbered from 0 without gaps.
void carry_frames(std::vector<FrameRecord>& frames, StateCarrier& carrier) {
    std::vector<std::int64_t> steps;
    std::vector<double> times;
    std::string hashes;
    for (const FrameRecord& frame : frames) {
        steps.push_back(frame.step);
        times.push_back(frame.time);
        hashes.append(frame.pixels.begin(), frame.pixels.end());
    }
    carrier.list("frame_steps", steps);
    carrier.list("frame_times", times);
    carrier.text("frame_pixels", hashes);
    constexpr std::size_t bytes = std::tuple_size_v<Sha256>;
    if (times.size() != steps.size() || hashes.size() != bytes * steps.size())
        carrier.refuse("its frames do not fit each other");
    frames.resize(steps.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i].number = static_cast<std::int64_t>(i);
        frames[i].step = steps[i];
        frames[i].time = times[i];
        std::copy_n(hashes.begin() + static_cast<std::ptrdiff_t>(bytes * i), bytes,
                    frames[i].pixels.begin());
    }
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
    carry_frames(frames, carrier);
    carrier.list("bed_steps", bed_steps);
    carrier.list("resumed_at", resumed_at);
}

void write_checkpoint(const RunFolder& folder, RunCheckpoint checkpoint, Model& model,
                      Recorder& recorder) {
    checkpoint.version = FUMON_VERSION;
    checkpoint.step = model.steps_done();
    checkpoint.records = recorder.sync();
    CheckpointWriter writer(folder.checkpoint());
    checkpoint.carry(writer);
    model.carry(writer);
    recorder.carry(writer);
    writer.commit();
}

void CheckpointClock::end() {
    constexpr double least_ratio = 50.0;  // of a run's seconds to those of its checkpoints
    wait_ = std::max(interval_, least_ratio * seconds_since(begun_));
    last_ = Clock::now();
}

}  // namespace fumon
