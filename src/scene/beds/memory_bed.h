#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "files/terrain/terrain_file.h"

namespace fumon {

/// A bed that a program hands over in memory, where a scene otherwise names a file: bed.file is its
/// name(), which scenes of this process find as long as somebody holds the bed.
class MemoryBed {
  public:
    /// Held by its hash: the same heights, mask, cells and place have one name. `unit_counts`:
    /// whether the sizes of cells stand in the unit of the place's reference system, see
    /// make_true_lengths(), which makes true metres of them; none: they are true metres already.
    /// Throws InputError as that does.
    static std::shared_ptr<const MemoryBed> hold(Terrain terrain, std::optional<bool> unit_counts);

    [[nodiscard]] const Terrain& terrain() const { return terrain_; }
    /// SHA-256 (hexadecimal) of the number of cells, their sizes and what these count, the place,
    /// heights and mask.
    [[nodiscard]] const std::string& hash() const { return hash_; }
    [[nodiscard]] std::string name() const;

  private:
    MemoryBed(Terrain terrain, std::string hash);

    Terrain terrain_;
    std::string hash_;
};

/// What messages call such a bed.
inline constexpr const char* memory_bed_title = "the array";

/// Whether a bed.file names one: "memory:" and a SHA-256.
bool is_memory_bed(std::string_view name);

/// The bed of this name that is held in this process. Throws InputError where none is, which says
/// that its heights came from memory.
std::shared_ptr<const MemoryBed> find_memory_bed(const std::string& name);

/// The same refusal: no file holds the heights; how to go on.
std::string missing_memory_bed(std::string_view name);

}  // namespace fumon
