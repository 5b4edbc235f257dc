#pragma once

#include <string_view>

#include "base/snapshot.h"

namespace fumon {

/// The air of a section between its nodes: bilinear, periodic in x, constant above its top. Points
/// are in metres. Refers to the snapshot, which must outlive it.
class SectionAir {
  public:
    /// `snapshot` has a section and a bed of one row.
    explicit SectionAir(const Snapshot& snapshot);

    [[nodiscard]] double length() const;  ///< of the period, metres
    [[nodiscard]] double height() const;  ///< of the highest nodes, metres
    [[nodiscard]] double bed(double x) const;

    /// The field of that name, or nullptr.
    [[nodiscard]] const SnapshotField* find(std::string_view name) const;
    /// A field that is truly 0 at the bed, as the velocity is.
    [[nodiscard]] double value(const SnapshotField& field, double x, double z) const;
    /// A field whose zeros at and below the bed mean nothing, as those of the pressure: there the
    /// lowest node of the column that lies in the air counts.
    [[nodiscard]] double value_of_air(const SnapshotField& field, double x, double z) const;

  private:
    template <class Node>
    [[nodiscard]] double between(double x, double z, Node node) const;
    [[nodiscard]] int lowest_in_air(int column) const;

    const Snapshot& snapshot_;
    const SnapshotSection& section_;
};

}  // namespace fumon
