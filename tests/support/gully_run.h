#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/worker_pool.h"
#include "models/water/gully.h"

namespace fumon::test {

/// The published setting: transport as printed at slope 0.04, all else as by default.
inline GullyParameters as_printed(double slope = 0.04) {
    GullyParameters gully;
    gully.transport = SedimentTransport::as_printed;
    gully.slope = {"", slope};
    return gully;
}

inline EdgeSettings edge(GridSide side, EdgeFlow kind, double value = 0.0) {
    EdgeSettings settings;
    settings.side = side;
    settings.kind = kind;
    settings.value = value;
    return settings;
}

inline Grid noise(int nx, int ny, double height, std::uint64_t seed = 1) {
    Grid bed(nx, ny);
    for (int y = 0; y < ny; ++y) {
        RandomStream stream(seed, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (double& z : bed.row(y)) z = height * stream.uniform();
    }
    return bed;
}

/// A gully with its threads, on cells of a metre unless said.
struct GullyRun {
    GullyRun(const GullyParameters& parameters, Grid bed, int threads = 2, double dx = 1.0,
             double dy = 1.0, Mask nodata = {}, bool from_file = false)
        : pool(threads),
          gully(parameters,
                {std::move(bed), std::move(nodata), {dx, dy, 1.0, true}, 1, pool, from_file}) {}

    void to(double seconds) {
        while (gully.time() < seconds - 1e-9) gully.step();
    }
    [[nodiscard]] double number(const std::string& name) const {
        for (const SnapshotNumber& number : gully.snapshot().numbers) {
            if (number.name == name) return number.value;
        }
        return std::nan("");
    }
    [[nodiscard]] Grid field(const std::string& name) const {
        for (const SnapshotField& field : gully.snapshot().fields) {
            if (field.name == name) return field.values;
        }
        return {};
    }
    [[nodiscard]] double lowest_depth() const {
        const Grid depth = field("water_depth");
        return *std::min_element(depth.values().begin(), depth.values().end());
    }

    WorkerPool pool;
    Gully gully;
};

/// Means over y.
inline std::vector<double> column_means(const Grid& field) {
    std::vector<double> means(static_cast<std::size_t>(field.nx()));
    for (int y = 0; y < field.ny(); ++y) {
        for (int x = 0; x < field.nx(); ++x)
            means[static_cast<std::size_t>(x)] += field(x, y) / field.ny();
    }
    return means;
}

/// The bed's lowest and highest downslope mean, measured from the bed far from a channel in the
/// middle.
struct ChannelProfile {
    double floor = 0.0;
    double rim = 0.0;
};

inline ChannelProfile channel_profile(const Grid& bed) {
    const std::vector<double> means = column_means(bed);
    const auto nx = static_cast<int>(means.size());
    double far = 0.0;
    for (int k = -5; k < 5; ++k) far += 0.1 * means[static_cast<std::size_t>((k + nx) % nx)];
    ChannelProfile profile;
    for (const double mean : means) {
        profile.floor = std::min(profile.floor, mean - far);
        profile.rim = std::max(profile.rim, mean - far);
    }
    return profile;
}

/// Growth rate, 1/s, between two times of a cross-slope bed wave of so many cells that starts 1e-8
/// m high.
inline double growth_rate(const GullyParameters& parameters, int wavelength, double from,
                          double until, double cell = 1.0) {
    constexpr int rows = 4;
    Grid bed(wavelength, rows);
    const double k = 2.0 * std::numbers::pi / wavelength;
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < wavelength; ++x) bed(x, y) = 1e-8 * std::cos(k * x);
    }
    GullyRun run(parameters, bed, 1, cell, cell);
    const auto amplitude = [&] {
        const Grid now = run.gully.snapshot().bed;
        double cosine = 0.0;
        double sine = 0.0;
        for (int x = 0; x < wavelength; ++x) {
            cosine += now(x, 0) * std::cos(k * x);
            sine += now(x, 0) * std::sin(k * x);
        }
        return std::hypot(cosine, sine);
    };
    run.to(from);
    const double before = amplitude();
    run.to(until);
    return std::log(amplitude() / before) / (until - from);
}

/// The larger root s of (s + D_w k²)(s + D k²) = E D_w k²: linear growth of a cross-slope wave
/// without variation down the slope.
inline double linear_growth_rate(const GullyParameters& p, double wavelength) {
    const double slope = p.slope.value;
    const double speed = std::sqrt(p.gravity * p.depth * slope / p.friction_coefficient);
    const double flux = std::pow(speed, p.velocity_exponent) * std::pow(slope, p.slope_exponent);
    const double erosion = 0.5 * p.velocity_exponent * flux / p.depth;
    const double water = p.gravity * p.depth * p.depth / (p.friction_coefficient * speed);
    const double k2 = std::pow(2.0 * std::numbers::pi / wavelength, 2);
    const double a = water * k2;
    const double b = p.bed_diffusion.value * k2;
    return 0.5 * (std::sqrt((a - b) * (a - b) + 4.0 * erosion * a) - (a + b));
}

}  // namespace fumon::test
