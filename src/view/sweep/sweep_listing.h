#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fumon {

/// What a sweep varies: a key, or several that go together, or the seed.
struct ListedAxis {
    std::string label;  ///< "model.creep_rate", "grid.nx+grid.ny", "seed"
    std::string unit;   ///< empty: none
    std::vector<std::string> values;
};

/// One run of a sweep.
struct ListedRun {
    std::int64_t number = 0;
    std::vector<std::size_t> at;     ///< its value on each axis, by the value's place
    std::string status = "pending";  ///< "pending", "running", "done" or "failed"
    std::string message{};           ///< why it failed, or what is to be doubted about it
    bool stored = false;             ///< it stored beds
};

/// A sweep as its folder tells of it: sweep.json, runs.csv and what each run has left there. It
/// reads only, while another program may be at work there. Not for several threads.
class SweepListing {
  public:
    /// Throws InputError where the folder holds no sweep.
    explicit SweepListing(std::filesystem::path folder);

    /// Looks at the runs that are not done, at most once a second.
    const std::vector<ListedRun>& runs();

    [[nodiscard]] const std::vector<ListedAxis>& axes() const { return axes_; }
    [[nodiscard]] const std::string& title() const { return title_; }
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  private:
    void read_manifest();
    void place_runs();
    void look_at(ListedRun& run) const;

    std::filesystem::path folder_;
    std::string title_;
    std::vector<ListedAxis> axes_;
    std::vector<ListedRun> runs_;
    std::filesystem::file_time_type manifest_written_{};
    std::filesystem::file_time_type table_written_{};  ///< of runs.csv
    double next_look_ = 0.0;                           ///< seconds of the steady clock
};

/// Whether a folder is that of a sweep.
bool is_sweep_folder(const std::filesystem::path& folder);

}  // namespace fumon
