#include "measure/bed/row_crests.h"

#include <algorithm>
#include <cstddef>

#include "numerics/peak_offset.h"

namespace fumon {

void find_row_crests(std::span<const double> row, bool periodic, double fall,
                     std::vector<double>& crests) {
    crests.clear();
    if (row.size() < 3 || !(fall > 0.0)) return;
    const std::size_t nx = row.size();
    const std::size_t start =
        periodic ? static_cast<std::size_t>(std::min_element(row.begin(), row.end()) - row.begin())
                 : 0;
    const std::size_t end = periodic ? start + nx + 1 : nx;
    const auto around = [&](std::size_t x) { return x < nx ? x : x - nx; };
    bool climbing = false;
    double lowest = row[start];
    double highest = row[start];
    std::size_t top = start;
    for (std::size_t i = start; i < end; ++i) {
        const std::size_t x = around(i);
        const double height = row[x];
        if (climbing) {
            if (height > highest) {
                highest = height;
                top = x;
            } else if (height <= highest - fall) {
                const double before = row[top == 0 ? nx - 1 : top - 1];
                const double after = row[around(top + 1)];
                const double place =
                    static_cast<double>(top) + peak_offset(before, row[top], after);
                crests.push_back(place);
                climbing = false;
                lowest = height;
            }
        } else if (height >= lowest + fall) {
            climbing = true;
            highest = height;
            top = x;
        } else {
            lowest = std::min(lowest, height);
        }
    }
    std::sort(crests.begin(), crests.end());
}

}  // namespace fumon
