#include "models/shared/two_cell_pattern.h"

#include <cmath>

namespace fumon {

namespace {

constexpr double least_ripple = 0.15;  // of the change around a cell
constexpr double least_change = 0.3;   // of the mean of all
constexpr int least_turns = 6;         // cells that go up and down by turns

/// Marks the cells of one line, whose values lie `stride` apart from `first` on.
void mark_line(const Grid& change, std::size_t first, std::size_t stride, int count, double least,
               Mask& marked) {
    const auto at = [&](int i) {
        return change.values()[first + static_cast<std::size_t>(i) * stride];
    };
    int turns = 0;
    double before = 0.0;
    for (int i = 2; i + 2 < count; ++i) {
        const double ripple =
            (at(i - 2) - 4.0 * at(i - 1) + 6.0 * at(i) - 4.0 * at(i + 1) + at(i + 2)) / 16.0;
        double around = 0.0;
        for (int j = i - 2; j <= i + 2; ++j) around += std::fabs(at(j)) / 5.0;
        const bool counts = around > least && std::fabs(ripple) > least_ripple * around;
        turns = !counts ? 0 : turns > 0 && ripple * before < 0.0 ? turns + 1 : 1;
        before = ripple;
        if (turns < least_turns) continue;
        for (int j = turns == least_turns ? i - least_turns + 1 : i; j <= i; ++j)
            marked.values()[first + static_cast<std::size_t>(j) * stride] = 1;
    }
}

}  // namespace

TwoCellPattern two_cell_pattern(const Grid& change) {
    double sum = 0.0;
    for (const double value : change.values()) sum += std::fabs(value);
    if (!(sum > 0.0)) return {};
    const double least = least_change * sum / static_cast<double>(change.size());
    Mask marked(change.nx(), change.ny());
    const auto width = static_cast<std::size_t>(change.nx());
    for (int y = 0; y < change.ny(); ++y)
        mark_line(change, static_cast<std::size_t>(y) * width, 1, change.nx(), least, marked);
    for (int x = 0; x < change.nx(); ++x)
        mark_line(change, static_cast<std::size_t>(x), width, change.ny(), least, marked);
    TwoCellPattern found;
    std::size_t changed = 0;
    std::size_t rippled = 0;
    double most = 0.0;
    for (std::size_t cell = 0; cell < change.size(); ++cell) {
        const double here = std::fabs(change.values()[cell]);
        if (here > least) ++changed;
        if (marked.values()[cell] == 0) continue;
        ++rippled;
        if (here > most) {
            most = here;
            found.cell = cell;
        }
    }
    found.share = static_cast<double>(rippled) / static_cast<double>(changed > 0 ? changed : 1);
    return found;
}

}  // namespace fumon
