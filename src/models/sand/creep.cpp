#include "models/sand/creep.h"

#include <cstddef>

#include "models/sand/creep_vectors.h"

namespace fumon {

void creep_row(std::span<const double> south, std::span<const double> here,
               std::span<const double> north, double rate, std::span<double> after) {
    const int nx = static_cast<int>(here.size());
    if (nx > 2)
        creep_vectors::creep_inside(south.data(), here.data(), north.data(), rate, nx - 2,
                                    after.data());
    const auto edge = [&](int west, int x, int east) {
        const double s[3] = {south[static_cast<std::size_t>(west)],
                             south[static_cast<std::size_t>(x)],
                             south[static_cast<std::size_t>(east)]};
        const double h[3] = {here[static_cast<std::size_t>(west)],
                             here[static_cast<std::size_t>(x)],
                             here[static_cast<std::size_t>(east)]};
        const double n[3] = {north[static_cast<std::size_t>(west)],
                             north[static_cast<std::size_t>(x)],
                             north[static_cast<std::size_t>(east)]};
        double out[3] = {0.0, 0.0, 0.0};
        creep_vectors::creep_inside(s, h, n, rate, 1, out);
        after[static_cast<std::size_t>(x)] = out[1];
    };
    edge(nx - 1, 0, 1 % nx);
    edge((nx - 2 + nx) % nx, nx - 1, 0);
}

}  // namespace fumon
