#pragma once

#include <span>
#include <vector>

#include "base/grid.h"
#include "models/dunes/wind/wind_shadow.h"
#include "numerics/plane_filter.h"

namespace fumon {

class WorkerPool;

/// Multiplies each wave of a plane over the ground by a response to it.
///
/// The transform sees any bed as periodic. Across open edges the plane goes on for half its length,
/// over which it passes smoothly from its values at one edge to those at the other, so that what is
/// at one edge is far from the other.
class GroundFilter {
  public:
    GroundFilter(const DuneGround& ground, WorkerPool& pool);

    /// A wave of the plane: its modes, 0 or more, and wave vector, 1/m.
    struct Wave {
        int m;
        int n;
        double kx;
        double ky;
    };
    struct Response {
        double real;
        double imaginary;
    };

    /// In place. response(wave) is asked for by several threads.
    template <class OfWave>
    void apply(Grid& plane, const OfWave& response) {
        filter(plane, [&](int n, std::span<double> real, std::span<double> imaginary,
                          std::span<double> mirrored_real, std::span<double> mirrored_imaginary) {
            const double ky = unit_y_ * n;
            for (std::size_t i = 0; i < real.size(); ++i) {
                const int m = static_cast<int>(i);
                const double kx = unit_x_ * static_cast<double>(i);
                const Response here = response(Wave{m, n, kx, ky});
                const Response mirrored = response(Wave{m, n, -kx, ky});
                real[i] = here.real;
                imaginary[i] = here.imaginary;
                mirrored_real[i] = mirrored.real;
                mirrored_imaginary[i] = mirrored.imaginary;
            }
        });
    }

    /// The ground with what goes on past its edges, whose modes are those of the waves.
    [[nodiscard]] const DuneGround& transformed() const { return ground_; }

  private:
    void filter(Grid& plane, const PlaneFilter::Response& response);
    void extend_past_edges(const Grid& plane);

    int nx_;  ///< of the bed
    int ny_;
    DuneGround ground_;
    double unit_x_;  ///< 1/m: the wave number of mode 1
    double unit_y_;
    WorkerPool& pool_;
    Grid extended_;  ///< empty where nothing goes on past the edges
    PlaneFilter filter_;
};

/// exp(−(scale · angle)²/2) of the modes of a row of `count` cells, whose angle is what their phase
/// changes by from cell to cell.
std::vector<double> gaussian_of_modes(int count, double scale);

}  // namespace fumon
