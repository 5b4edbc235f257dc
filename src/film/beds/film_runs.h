#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "film/beds/blended_bed.h"
#include "film/beds/stored_beds.h"
#include "film/script/film.h"

namespace fumon {

/// Most runs in one picture, and most of them in a row.
inline constexpr std::size_t most_panes = 9;
inline constexpr int most_pane_columns = 3;

/// Whether a path is what FilmRuns takes: the folder of a run or of a sweep.
bool is_run_folder(const std::filesystem::path& path);

/// How a film shows its runs.
enum class RunArrangement { together, in_turn };

/// In turn where it cuts from other films.
RunArrangement arrangement_of(const Film& film);

/// The runs that a film shows: one, or several in step or in turn.
class FilmRuns {
  public:
    /// Folders of runs and of sweeps, each of which stands for all its runs, and files of other
    /// models' runs. Throws InputError as
    /// StoredBeds, and for more than nine runs (24 in turn) and, together, for runs whose grids
    /// differ.
    FilmRuns(const std::vector<std::string>& folders, int threads,
             RunArrangement showing = RunArrangement::together, const ForeignQuery& query = {});

    /// Of runs that are read already, at least one. Throws InputError where their grids differ.
    explicit FilmRuns(std::vector<StoredBeds> beds,
                      RunArrangement showing = RunArrangement::together);

    /// One of them alone.
    [[nodiscard]] FilmRuns only(std::size_t run) const;

    [[nodiscard]] std::size_t size() const { return beds_.size(); }
    [[nodiscard]] const StoredBeds& first() const { return *beds_.front(); }
    [[nodiscard]] const StoredBeds& beds(std::size_t run) const { return *beds_[run]; }

    /// The keys of the runs' scenes that differ among them, at most two; none where more do.
    [[nodiscard]] const std::vector<std::string>& varied() const { return varied_; }
    /// What is written above a run: film.panes.label filled in, or what differs ("creep rate 0.2").
    /// Throws InputError, located.
    [[nodiscard]] std::string label(const Film& film, std::size_t run) const;
    /// The value of the one number that differs among the runs, for each of them; empty where there
    /// is no such number.
    [[nodiscard]] std::vector<double> values() const;
    /// Columns of a grid whose rows and columns are the values of two keys; nothing where the runs
    /// fill no such grid.
    [[nodiscard]] std::optional<int> grid_columns() const;

    /// The bed of another run that goes with a bed of the first one: of the same step, or of the
    /// nearest time. Throws InputError, saying what is missing, where there is none.
    [[nodiscard]] std::size_t in_step(std::size_t run, std::size_t bed, FilmClock clock) const;
    /// The place among another run's beds that goes with one among the first run's: between the
    /// beds of the same steps, or by the time between the two of its own around that time. Throws
    /// as above.
    [[nodiscard]] RecordPlace in_step(std::size_t run, const RecordPlace& place,
                                      FilmClock clock) const;

    /// The files that are read.
    [[nodiscard]] std::vector<std::filesystem::path> files() const;

  private:
    FilmRuns() = default;
    void check() const;
    void find_varied();

    std::vector<std::shared_ptr<const StoredBeds>> beds_;
    std::vector<std::string> varied_;
};

}  // namespace fumon
