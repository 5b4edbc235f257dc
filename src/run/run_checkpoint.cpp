#include "run/run_checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <utility>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/checkpoint.h"

namespace fumon {

namespace {

void serialise_hash(const std::string& name, Sha256& hash, StateArchive& archive) {
    std::string bytes(hash.begin(), hash.end());
    archive.text(name, bytes);
    if (bytes.size() != hash.size()) archive.refuse(fmt::format("its {} is not a SHA-256", name));
    std::copy(bytes.begin(), bytes.end(), hash.begin());
}

void serialise_table(const std::string& name, FileBeginning& table, StateArchive& archive) {
    archive.value(name + "_bytes", table.length);
    serialise_hash(name + "_sha256", table.hash, archive);
}

/// A list whose memory grows only as far as there are entries.
template <class Entry, class SerialiseEntry>
void serialise_entries(const std::string& name, std::vector<Entry>& entries, StateArchive& archive,
                       const SerialiseEntry& serialise_entry) {
    auto count = static_cast<std::int64_t>(entries.size());
    archive.count(name, count);
    entries.resize(std::min(entries.size(), static_cast<std::size_t>(count)));
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        if (i == entries.size()) entries.emplace_back();
        serialise_entry(entries[i]);
    }
}

void serialise_inputs(std::vector<InputFile>& inputs, StateArchive& archive) {
    serialise_entries("inputs", inputs, archive, [&](InputFile& input) {
        archive.text("input_path", input.path);
        archive.text("input_sha256", input.hash);
    });
}

void serialise_beds(std::vector<BedRecord>& beds, StateArchive& archive) {
    serialise_entries("beds", beds, archive, [&](BedRecord& bed) {
        archive.count("bed_step", bed.step);
        serialise_entries("bed_files", bed.files, archive, [&](BedRecord::File& file) {
            archive.text("bed_ending", file.ending);
            serialise_hash("bed_sha256", file.hash, archive);
        });
    });
}

/// Counts the bytes of a state's values.
class StateSize : public StateArchive {
  public:
    void values(std::string_view /*name*/, std::span<double> values) override {
        bytes_ += values.size_bytes();
    }
    void values(std::string_view /*name*/, std::span<std::int64_t> values) override {
        bytes_ += values.size_bytes();
    }
    void list(std::string_view /*name*/, std::vector<double>& values) override {
        bytes_ += values.size() * sizeof(double);
    }
    void list(std::string_view /*name*/, std::vector<std::int64_t>& values) override {
        bytes_ += values.size() * sizeof(std::int64_t);
    }
    void text(std::string_view /*name*/, std::string& text) override { bytes_ += text.size(); }
    [[noreturn]] void refuse(const std::string& why) const override { throw Error(why); }

    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

  private:
    std::uint64_t bytes_ = 0;
};

}  // namespace

void RunCheckpoint::serialise(StateArchive& archive) {
    archive.text("fumon", version);
    archive.text("sources", build.sources);
    archive.text("tools", build.tools);
    archive.text("scene", scene);
    serialise_inputs(inputs, archive);
    archive.text("drawing", drawing);
    archive.count("step", step);
    serialise_table("measurements", records.measurements, archive);
    serialise_table("avalanches", records.avalanches, archive);
    archive.value("fields_records", records.fields.records);
    serialise_hash("fields_sha256", records.fields.hash, archive);
    archive.count("frames", frames.frames);
    serialise_hash("frames_sha256", frames.hash, archive);
    serialise_beds(beds, archive);
    archive.list("resumed_at", resumed_at);
}

Checkpointer::Checkpointer(const RunFolder& folder, const RunParts& parts,
                           const CheckpointClock& clock, RunCheckpoint fixed,
                           WrittenOutputs& written, Recorder& recorder,
                           std::function<void(const std::string&)> report)
    : folder_(folder),
      parts_(parts),
      clock_(clock),
      now_(std::move(fixed)),
      written_(written),
      recorder_(recorder),
      report_(std::move(report)),
      frames_on_disk_(written.frames().frames()),
      beds_on_disk_(written.beds().size()) {}

void Checkpointer::before_step(Model& model, bool interrupted) {
    if (!clock_.on() || !(interrupted || clock_.due())) return;
    recorder_.settle();  // what fails there ends the run; a checkpoint that fails does not
    if (written_.wait_for_all()) try_to_write(model, "the run continues");
}

bool Checkpointer::keep_last_state(Model& model) {
    if (!clock_.on()) return false;
    StateSize size;
    model.serialise(size);
    recorder_.serialise(size);
    if (size.bytes() > most_bytes_kept || !written_.wait_for_all()) return false;
    return try_to_write(model, "the run cannot be made longer later");
}

bool Checkpointer::try_to_write(Model& model, std::string_view consequence) {
    try {
        write(model);
        last_ = model.steps_done();
        return true;
    } catch (const Error& fault) {
        report_(fmt::format("no checkpoint of step {}: {}; {}", model.steps_done(), fault.what(),
                            consequence));
        return false;
    }
}

void Checkpointer::write(Model& model) {
    clock_.begin();
    const struct Ended {
        CheckpointClock& clock;
        ~Ended() { clock.end(); }
    } ended{clock_};
    sync_to_disk();
    now_.version = FUMON_VERSION;
    now_.build = this_build();
    now_.step = model.steps_done();
    now_.frames = written_.frames().sync();
    now_.beds = written_.beds();
    now_.records = recorder_.sync();
    CheckpointWriter writer(folder_.checkpoint());
    now_.serialise(writer);
    model.serialise(writer);
    recorder_.serialise(writer);
    writer.commit();
}

void Checkpointer::sync_to_disk() {
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
