#pragma once

#include <glm/glm.hpp>

#include "base/elementary.h"
#include "render/sky/atmosphere.h"

namespace fumon {

inline glm::dvec3 exp_of(const glm::dvec3& x) {
    return {elementary::exp(x.r), elementary::exp(x.g), elementary::exp(x.b)};
}

/// ∫ exp(−extinction·s) ds over a step, whose transmittance is known.
inline glm::dvec3 effective_length(const glm::dvec3& extinction, const glm::dvec3& transmittance,
                                   double step) {
    glm::dvec3 transmitted(step);
    for (int band = 0; band < 3; ++band) {
        if (extinction[band] * step > 1e-6)
            transmitted[band] = (1.0 - transmittance[band]) / extinction[band];
    }
    return transmitted;
}

/// A step along a ray.
struct RayStep {
    double middle;
    double length;
};

/// Of so many that grow along the ray: what is near, and low, matters most.
inline RayStep growing_step(double distance, int number, int count) {
    const double from = static_cast<double>(number) / count;
    const double to = (number + 1.0) / count;
    const double before = distance * from * from;
    const double after = distance * to * to;
    return {0.5 * (before + after), after - before};
}

/// A step along a ray, and how much of the light that is scattered in it arrives.
struct ScatteringStep {
    double middle;
    RayPoint point;
    AirOptics optics;
    glm::dvec3 transmitted;  ///< over the extinction on the way, per scattering coefficient
};

/// Walks along a ray of that length by growing steps and hands each to `use`; returns the share of
/// light that passes all of it.
template <class Use>
glm::dvec3 march(const Atmosphere& air, double radius, double up, double distance, int steps,
                 const Use& use) {
    glm::dvec3 passed(1.0);
    for (int i = 0; i < steps; ++i) {
        const auto [middle, length] = growing_step(distance, i, steps);
        const RayPoint point = along_ray(radius, up, middle);
        const AirOptics optics = air.optics(point.radius - air.ground);
        const glm::dvec3 extinction = optics.extinction();
        const glm::dvec3 through = exp_of(-extinction * length);
        use(ScatteringStep{middle, point, optics,
                           passed * effective_length(extinction, through, length)});
        passed *= through;
    }
    return passed;
}

}  // namespace fumon
