#include "measure/bed/crest_height.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "measure/bed/sampled_rank.h"
#include "measure/shared/undefined.h"

namespace fumon {

double top_one_percent_mean(const Grid& bed) {
    if (bed.empty()) return undefined;
    constexpr std::size_t sampled_sites = 61;  // of which one is of the sample
    const auto values = bed.values();
    const std::size_t count = (values.size() + 99) / 100;
    const std::size_t rank = values.size() - count;  // of the lowest one that counts
    std::vector<double> sample;
    for (std::size_t cell = 0; cell < values.size(); cell += sampled_sites)
        sample.push_back(values[cell]);
    SampledRank highest(std::move(sample), 1.0 - 0.01);
    const auto add_all = [&] {
        for (int y = 0; y < bed.ny(); ++y) highest.add(bed.row(y));
        return highest.find(rank).has_value();
    };
    if (!add_all()) {
        highest.widen();
        add_all();
    }
    const auto top = highest.kept().last(count);
    std::sort(top.begin(), top.end());
    double sum = 0.0;
    for (const double height : top) sum += height;
    return sum / static_cast<double>(count);
}

double crest_to_trough(const BedWaves& waves) {
    return waves.reliefs > 0 ? waves.relief / static_cast<double>(waves.reliefs) : undefined;
}

double crest_to_trough_height(const Grid& bed, bool periodic) {
    return crest_to_trough(bed_waves(bed, periodic));
}

}  // namespace fumon
