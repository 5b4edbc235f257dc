#include "models/sand/saltation_flux.h"

#include <algorithm>
#include <cstddef>

#include "base/compensated_sum.h"
#include "models/sand/hop_terms.h"
#include "models/sand/row_hops.h"

namespace fumon {

namespace {

/// What leaves a cell.
double amount_of(const SandParameters& p, double height, double slope, double upwind) {
    if (p.order == HopOrder::random_sequential && height <= 0.0) return 0.0;
    if (p.shadow == Shadow::upwind_higher && upwind > height) return 0.0;
    return std::max(hop_amount(p, height, slope), 0.0);
}

}  // namespace

Grid saltation_flux(const SandParameters& parameters, const Grid& bed) {
    const int nx = bed.nx();
    const RowHops hops(parameters, nx);
    CompensatedSum sum;
    for (const double height : bed.values()) sum.add(height);
    const double mean = sum.value() / static_cast<double>(bed.size());
    const double level = amount_of(parameters, mean, 0.0, mean) * hops.length(mean, 0.0);
    Grid flux(nx, bed.ny());
    if (!(level > 0.0)) return flux;
    for (int y = 0; y < bed.ny(); ++y) {
        const auto row = bed.row(y);
        const auto at = [&](int x) { return row[static_cast<std::size_t>((x + nx) % nx)]; };
        for (int x = 0; x < nx; ++x) {
            const double before = at(x - 1);
            const double here = at(x);
            const double slope = slope_at(parameters.slope_difference, before, here, at(x + 1));
            flux(x, y) = amount_of(parameters, here, slope, before) *
                         std::min(hops.length(here, slope), static_cast<double>(nx)) / level;
        }
    }
    return flux;
}

}  // namespace fumon
