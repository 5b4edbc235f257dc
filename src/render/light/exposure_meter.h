#pragma once

#include "render/light/light.h"
#include "render/view/camera.h"

namespace fumon {

/// The share of its exposure that is left to a camera which looks into a bright sky: where the mean
/// radiance of the clear sky times π is L over the width of the picture and up to 15 degrees above
/// the horizon, (1 + (L/1.2)²)^−0.13, as far as the picture reaches above the horizon. A high sun
/// and a sun behind leave nearly all.
double exposure_under_sky(const Light& light, const Camera& camera);

}  // namespace fumon
