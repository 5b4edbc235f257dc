#include "foreign/mesh/mesh.h"

#include <algorithm>
#include <cmath>

#include "base/elementary_angle.h"
#include "base/elementary_power.h"

namespace fumon {

double cell_of_edges(const FaceMesh& mesh) {
    std::vector<double> lengths;
    lengths.reserve(mesh.corners.size());
    for (std::size_t face = 0; face < mesh.faces(); ++face) {
        const auto corners = mesh.face(face);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const auto a = static_cast<std::size_t>(corners[k]);
            const auto b = static_cast<std::size_t>(corners[(k + 1) % corners.size()]);
            lengths.push_back(elementary::hypot(mesh.x[a] - mesh.x[b], mesh.y[a] - mesh.y[b]));
        }
    }
    if (lengths.empty()) return 0.0;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::ranges::nth_element(lengths, middle);
    const double half = 0.5 * *middle;
    if (!(half > 0.0)) return 0.0;
    const double scale = elementary::pow(10.0, 2.0 - std::floor(elementary::log10(half)));
    return std::round(half * scale) / scale;
}

}  // namespace fumon
