#pragma once

#include <functional>
#include <vector>

/// Exact solutions of the shallow-water equations, as Delestre et al. (2013, arXiv 1110.0288)
/// compile them (SWASHES), in metres and seconds; g = 9.81.
namespace fumon::exact {

inline constexpr double gravity = 9.81;

struct Flow {
    double depth = 0.0;  ///< h, m
    double u = 0.0;      ///< m/s
    double v = 0.0;
};

/// A bump of 0.2 m on a flat bed of 25 m: 0.2 − 0.05 (x − 10)² for 8 < x < 12.
double bump(double x);

/// Steady flow over the bump: the root of Bernoulli's cubic, subcritical everywhere.
Flow bump_subcritical(double x, double discharge, double depth_out);
/// … critical on its top, supercritical behind it.
Flow bump_transcritical(double x, double discharge);
/// … and subcritical again behind the jump at bump_jump().
Flow bump_with_jump(double x, double discharge, double depth_out);
double bump_jump(double discharge, double depth_out);

/// A dam that breaks at t = 0: Ritter (1892) over a dry bed, Stoker (1957) over a wet one.
Flow dam_break(double left, double right, double x, double t);

/// A dam of `left` m that breaks over a dry bed with Chézy's friction (Dressler 1952, first order
/// in the resistance); valid up to dressler_tip().
Flow dressler(double left, double chezy, double x, double t);
/// Where the velocity is largest, m from the dam: beyond it the first order does not hold.
double dressler_tip(double left, double chezy, double t);

/// Thacker (1981): a plane surface in a parabola, z = h0 (x²/a² − 1), released from rest.
Flow thacker_parabola(double x, double t, double a, double h0);
/// … in a paraboloid, going round: z = h0 (r²/a² − 1), its middle at a distance eta.
Flow thacker_planar(double x, double y, double t, double a, double h0, double eta);
/// … and a curved one that swells and sinks, its shore at r0 at the start.
Flow thacker_radial(double x, double y, double t, double a, double h0, double r0);

/// A steady flow of given depth over the bed that it needs (MacDonald et al. 1997), with rain R and
/// Manning's friction: dz/dx = (q²/(g h³) − 1) dh/dx − 2 q R/(g h²) − n² q²/h^(10/3).
struct Channel {
    double length = 0.0;
    double inflow = 0.0;  ///< q at x = 0, m²/s
    double rain = 0.0;    ///< R, m/s
    double manning = 0.0;
    std::function<double(double)> depth;
    std::function<double(double)> depth_slope;
    double jump = -1.0;  ///< where the depth jumps, m, or none

    [[nodiscard]] double discharge(double x) const { return inflow + rain * x; }
    /// The bed at the middles of `cells`, 0 at x = length; by Simpson's rule.
    [[nodiscard]] std::vector<double> bed(int cells) const;
};

Channel subcritical_channel(double inflow, double rain);
Channel supercritical_channel(double rain);
Channel channel_to_supercritical();
Channel channel_with_jump();

}  // namespace fumon::exact
