#include "models/dunes/transport/wind_over_bed.h"

#include <algorithm>
#include <cmath>

#include "models/dunes/plants/plant_shelter.h"
#include "models/dunes/plants/plants.h"

namespace fumon {

double lift_factor(const WindOverBed& wind, int x, int y) {
    double factor = 1.0 - wind.shade(x, y);
    if (wind.shear != nullptr) factor *= std::clamp(1.0 + (*wind.shear)(x, y), 0.0, greatest_lift);
    if (wind.along_walls != nullptr) {
        const double u = (*wind.before_walls)(x, y);
        const double back = std::min(u, 0.0);
        const double aside = (*wind.along_walls)(x, y);
        factor = factor * std::max(u, 0.0) + std::sqrt(back * back + aside * aside);
    } else if (wind.before_walls != nullptr) {
        factor *= std::abs((*wind.before_walls)(x, y));
    }
    if (wind.sheltered != nullptr)
        return PlantShelter::lifted_under(factor, (*wind.sheltered)(x, y), wind.blowing);
    if (wind.plants != nullptr) factor *= wind.plants->lifted(wind.plants->cover()(x, y));
    return factor;
}

}  // namespace fumon
