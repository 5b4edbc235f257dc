#pragma once

#include <vector>

#include "models/air/airflow_parameters.h"
#include "models/shared/model.h"

namespace fumon {

/// The plane of nodes over a fixed bed (Terada 2025, eq. 16): column i at x = i·Δr, node k at
/// z = k·Δr, the lid at node nz. Fields on it keep a column's nodes together.
struct AirPlane {
    int nx = 0;
    int nz = 0;
    double spacing = 0.0;         ///< Δr, m
    std::vector<double> height;   ///< h(x) of each column, m; the lowest is 0
    std::vector<int> under_bed;   ///< the highest node at or below the bed, z ≤ h (eq. 20)
    double largest_height = 0.0;  ///< m

    /// Nodes of a column, the lid's among them.
    [[nodiscard]] int column() const { return nz + 1; }
    [[nodiscard]] std::size_t at(int i, int k) const {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(column()) +
               static_cast<std::size_t>(k);
    }
    [[nodiscard]] int left(int i) const { return i == 0 ? nx - 1 : i - 1; }
    [[nodiscard]] int right(int i) const { return i + 1 == nx ? 0 : i + 1; }
};

/// Part of a cell within which a node counts as lying on the bed: a crest at k·Δr must not depend
/// on rounding.
inline constexpr double on_bed_tolerance = 1e-6;

/// Throws KeyError for a grid, bed or lid that the model does not admit: fewer than 4 columns,
/// cells that are not square, cells without data, a row that is not there, a bed within 2 cells of
/// the lid, or one steeper than 1 (eq. 27).
AirPlane make_air_plane(const AirflowParameters& parameters, const ModelSetup& setup);

}  // namespace fumon
