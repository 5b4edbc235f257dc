#include "examination/exact_water.h"

#include <algorithm>
#include <cmath>

namespace fumon::exact {

namespace {

constexpr double g = gravity;

double square(double x) {
    return x * x;
}

double critical_depth(double discharge) {
    return std::cbrt(discharge * discharge / g);
}

/// h + q²/(2 g h²), the height of the energy over the bed.
double energy(double discharge, double depth) {
    return depth + square(discharge / depth) / (2.0 * g);
}

/// The depth of that energy above or below the critical one, by bisection.
double depth_of(double discharge, double height, bool subcritical) {
    const double critical = critical_depth(discharge);
    double low = subcritical ? critical : 1e-6;
    double high = subcritical ? std::max(height, critical) : critical;
    for (int halving = 0; halving < 200; ++halving) {
        const double middle = 0.5 * (low + high);
        const bool too_high = energy(discharge, middle) > height;
        (too_high == subcritical ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

Flow of_discharge(double depth, double discharge) {
    return {depth, discharge / depth, 0.0};
}

double momentum(double discharge, double depth) {
    return square(discharge) / depth + 0.5 * g * square(depth);
}

/// The first-order functions of Dressler's solution.
double dressler_depth_term(double place) {
    const double s = 2.0 - place;
    return 6.0 / (5.0 * s) - 2.0 / 3.0 + 4.0 * std::sqrt(3.0) / 135.0 * std::pow(s, 1.5);
}

double dressler_velocity_term(double place) {
    const double s = 2.0 - place;
    return 12.0 / s - 8.0 / 3.0 + 8.0 * std::sqrt(3.0) / 189.0 * std::pow(s, 1.5) -
           108.0 / (7.0 * square(s));
}

double dressler_velocity(double left, double chezy, double place, double t) {
    const double c = std::sqrt(g * left);
    return 2.0 / 3.0 * c * (1.0 + place) + square(g / chezy) * dressler_velocity_term(place) * t;
}

const double unit_depth = std::cbrt(4.0 / g);  // critical for 2 m²/s

}  // namespace

double bump(double x) {
    return x > 8.0 && x < 12.0 ? 0.2 - 0.05 * square(x - 10.0) : 0.0;
}

Flow bump_subcritical(double x, double discharge, double depth_out) {
    return of_discharge(depth_of(discharge, energy(discharge, depth_out) - bump(x), true),
                        discharge);
}

Flow bump_transcritical(double x, double discharge) {
    const double height = energy(discharge, critical_depth(discharge)) + bump(10.0);
    return of_discharge(depth_of(discharge, height - bump(x), x < 10.0), discharge);
}

double bump_jump(double discharge, double depth_out) {
    double low = 10.0 + 1e-9;
    double high = 12.0;
    for (int halving = 0; halving < 200; ++halving) {
        const double middle = 0.5 * (low + high);
        const double before = bump_transcritical(middle, discharge).depth;
        const double height = energy(discharge, depth_out) - bump(middle);
        const bool reaches =
            height > energy(discharge, critical_depth(discharge)) &&
            momentum(discharge, depth_of(discharge, height, true)) > momentum(discharge, before);
        (reaches ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

Flow bump_with_jump(double x, double discharge, double depth_out) {
    if (x < bump_jump(discharge, depth_out)) return bump_transcritical(x, discharge);
    return bump_subcritical(x, discharge, depth_out);
}

Flow dam_break(double left, double right, double x, double t) {
    const double c_left = std::sqrt(g * left);
    const double place = x / t;
    const auto behind_wave = [&](double h) { return 2.0 * (c_left - std::sqrt(g * h)); };
    double middle = 0.0;
    if (right > 0.0) {
        double low = right;
        double high = left;
        for (int halving = 0; halving < 200; ++halving) {
            middle = 0.5 * (low + high);
            const double behind_shock =
                (middle - right) * std::sqrt(0.5 * g * (1.0 / middle + 1.0 / right));
            (behind_shock < behind_wave(middle) ? low : high) = middle;
        }
    }
    const double velocity = behind_wave(middle);
    if (place <= -c_left) return {left, 0.0, 0.0};
    if (place < velocity - std::sqrt(g * middle))
        return {square((2.0 * c_left - place) / 3.0) / g, 2.0 / 3.0 * (c_left + place), 0.0};
    if (right > 0.0 && place < middle * velocity / (middle - right)) return {middle, velocity, 0.0};
    return {right, 0.0, 0.0};
}

double dressler_tip(double left, double chezy, double t) {
    double best = -1.0;
    for (int k = 0; k <= 30000; ++k) {
        const double place = -1.0 + 2.9999 * k / 30000.0;
        if (dressler_velocity(left, chezy, place, t) > dressler_velocity(left, chezy, best, t))
            best = place;
    }
    return best * t * std::sqrt(g * left);
}

Flow dressler(double left, double chezy, double x, double t) {
    const double c = std::sqrt(g * left);
    const double place = x / (t * c);
    if (place <= -1.0) return {left, 0.0, 0.0};
    if (place >= 2.0) return {};
    const double root =
        c * (2.0 - place) / 3.0 + square(g / chezy) * dressler_depth_term(place) * t;
    return {square(std::max(root, 0.0)) / g, dressler_velocity(left, chezy, place, t), 0.0};
}

Flow thacker_parabola(double x, double t, double a, double h0) {
    const double omega = std::sqrt(2.0 * g * h0) / a;
    const double shifted = (x + 0.5 * std::cos(omega * t)) / a;
    const double depth = h0 * (1.0 - square(shifted));
    if (!(depth > 0.0)) return {};
    return {depth, 0.5 * omega * std::sin(omega * t), 0.0};
}

Flow thacker_planar(double x, double y, double t, double a, double h0, double eta) {
    const double omega = std::sqrt(2.0 * g * h0) / a;
    const double c = std::cos(omega * t);
    const double s = std::sin(omega * t);
    const double depth =
        h0 / (a * a) * (eta * (2.0 * x * c + 2.0 * y * s - eta) - x * x - y * y) + h0;
    if (!(depth > 0.0)) return {};
    return {depth, -eta * omega * s, eta * omega * c};
}

Flow thacker_radial(double x, double y, double t, double a, double h0, double r0) {
    const double omega = std::sqrt(8.0 * g * h0) / a;
    const double swing = (std::pow(a, 4) - std::pow(r0, 4)) / (std::pow(a, 4) + std::pow(r0, 4));
    const double below = 1.0 - swing * std::cos(omega * t);
    const double curve = (1.0 - swing * swing) / (below * below);
    const double depth = h0 * (std::sqrt(curve) - (x * x + y * y) / (a * a) * curve);
    if (!(depth > 0.0)) return {};
    const double rate = 0.5 * omega * swing * std::sin(omega * t) / below;
    return {depth, rate * x, rate * y};
}

std::vector<double> Channel::bed(int cells) const {
    const auto steepness = [&](double x) {
        const double h = depth(x);
        const double q = discharge(x);
        return (q * q / (g * h * h * h) - 1.0) * depth_slope(x) - 2.0 * q * rain / (g * h * h) -
               square(manning * q) / std::pow(h, 10.0 / 3.0);
    };
    const double dx = length / cells;
    const auto rise = [&](double from, double to) {  // by Simpson's rule in 16 parts
        constexpr int parts = 16;
        double sum = 0.0;
        for (int k = 0; k < parts; ++k) {
            const double a = from + (to - from) * k / parts;
            const double b = from + (to - from) * (k + 1) / parts;
            sum += (steepness(a) + 4.0 * steepness(0.5 * (a + b)) + steepness(b)) * (b - a) / 6.0;
        }
        return sum;
    };
    // The bed goes on evenly where the depth jumps: neither side's slope is taken across.
    const auto rise_across = [&](double from, double to) {
        if (!(from < jump && jump < to)) return rise(from, to);
        return rise(from, jump - 1e-9) + rise(jump + 1e-9, to);
    };
    std::vector<double> heights(static_cast<std::size_t>(cells));
    double height = -rise_across(length - 0.5 * dx, length);
    for (int k = cells - 1; k >= 0; --k) {
        heights[static_cast<std::size_t>(k)] = height;
        if (k > 0) height -= rise_across((k - 0.5) * dx, (k + 0.5) * dx);
    }
    return heights;
}

Channel subcritical_channel(double inflow, double rain) {
    Channel channel{1000.0, inflow, rain, 0.033, {}, {}};
    channel.depth = [](double x) {
        return unit_depth * (1.0 + 0.5 * std::exp(-16.0 * square(x / 1000.0 - 0.5)));
    };
    channel.depth_slope = [](double x) {
        const double s = x / 1000.0 - 0.5;
        return unit_depth * 0.5 * std::exp(-16.0 * s * s) * (-32.0 * s) / 1000.0;
    };
    return channel;
}

Channel supercritical_channel(double rain) {
    Channel channel{1000.0, 2.5, rain, 0.04, {}, {}};
    channel.depth = [](double x) {
        return unit_depth * (1.0 - 0.2 * std::exp(-36.0 * square(x / 1000.0 - 0.5)));
    };
    channel.depth_slope = [](double x) {
        const double s = x / 1000.0 - 0.5;
        return unit_depth * 0.2 * std::exp(-36.0 * s * s) * (72.0 * s) / 1000.0;
    };
    return channel;
}

Channel channel_to_supercritical() {
    Channel channel{1000.0, 2.0, 0.0, 0.0218, {}, {}};
    channel.depth = [](double x) {
        const double k = x <= 500.0 ? 3.0 : 6.0;
        return unit_depth * (1.0 - std::tanh(k * (x / 1000.0 - 0.5)) / k);
    };
    channel.depth_slope = [](double x) {
        const double k = x <= 500.0 ? 3.0 : 6.0;
        return -unit_depth / square(std::cosh(k * (x / 1000.0 - 0.5))) / 1000.0;
    };
    return channel;
}

Channel channel_with_jump() {
    Channel channel{1000.0, 2.0, 0.0, 0.0218, {}, {}, 500.0};
    static constexpr double terms[] = {-0.348427, 0.552264, -0.55558};
    channel.depth = [](double x) {
        if (x < 500.0) return unit_depth * (0.9 - std::exp(-x / 250.0) / 6.0);
        double sum = 1.0 + 0.8 * std::exp(x / 1000.0 - 1.0);
        for (int k = 1; k <= 3; ++k) sum += terms[k - 1] * std::exp(-20.0 * k * (x / 1000.0 - 0.5));
        return unit_depth * sum;
    };
    channel.depth_slope = [](double x) {
        if (x < 500.0) return unit_depth * std::exp(-x / 250.0) / 1500.0;
        double sum = 0.8 * std::exp(x / 1000.0 - 1.0);
        for (int k = 1; k <= 3; ++k)
            sum -= 20.0 * k * terms[k - 1] * std::exp(-20.0 * k * (x / 1000.0 - 0.5));
        return unit_depth * sum / 1000.0;
    };
    return channel;
}

}  // namespace fumon::exact
