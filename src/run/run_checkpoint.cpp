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

void carry_hash(const std::string& name, Sha256& hash, StateCarrier& carrier) {
    std::string bytes(hash.begin(), hash.end());
    carrier.text(name, bytes);
    if (bytes.size() != hash.size()) carrier.refuse(fmt::format("its {} is no SHA-256", name));
    std::copy(bytes.begin(), bytes.end(), hash.begin());
}

void carry_table(const std::string& name, FileBeginning& table, StateCarrier& carrier) {
    carrier.value(name + "_bytes", table.length);
    carry_hash(name + "_sha256", table.hash, carrier);
}

/// A list whose memory grows only as far as there are entries.
template <class Entry, class CarryEntry>
void carry_entries(const std::string& name, std::vector<Entry>& entries, StateCarrier& carrier,
                   const CarryEntry& carry_entry) {
    auto count = static_cast<std::int64_t>(entries.size());
    carrier.count(name, count);
    entries.resize(std::min(entries.size(), static_cast<std::size_t>(count)));
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        if (i == entries.size()) entries.emplace_back();
        carry_entry(entries[i]);
    }
}

void carry_inputs(std::vector<InputFile>& inputs, StateCarrier& carrier) {
    carry_entries("inputs", inputs, carrier, [&](InputFile& input) {
        carrier.text("input_path", input.path);
        carrier.text("input_sha256", input.hash);
    });
}

void carry_beds(std::vector<BedRecord>& beds, StateCarrier& carrier) {
    carry_entries("beds", beds, carrier, [&](BedRecord& bed) {
        carrier.count("bed_step", bed.step);
        carry_entries("bed_files", bed.files, carrier, [&](BedRecord::File& file) {
            carrier.text("bed_ending", file.ending);
            carry_hash("bed_sha256", file.hash, carrier);
        });
    });
}

}  // namespace

void RunCheckpoint::carry(StateCarrier& carrier) {
    carrier.text("fumon", version);
    carrier.text("sources", build.sources);
    carrier.text("tools", build.tools);
    carrier.text("scene", scene);
    carry_inputs(inputs, carrier);
    carrier.text("drawing", drawing);
    carrier.count("step", step);
    carry_table("measurements", records.measurements, carrier);
    carry_table("avalanches", records.avalanches, carrier);
    carrier.value("fields_records", records.fields.records);
    carry_hash("fields_sha256", records.fields.hash, carrier);
    carrier.count("frames", frames.frames);
    carry_hash("frames_sha256", frames.hash, carrier);
    carry_beds(beds, carrier);
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
      beds_on_disk_(written.beds().size()) {}

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
    now_.build = this_build();
    now_.step = model.steps_done();
    now_.frames = written_.frames().sync();
    now_.beds = written_.beds();
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
    for (; beds_on_disk_ < written_.beds().size(); ++beds_on_disk_) {
        const BedRecord& bed = written_.beds()[beds_on_disk_];
        for (const BedRecord::File& file : bed.files) sync_file(folder_.bed(bed.step, file.ending));
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
