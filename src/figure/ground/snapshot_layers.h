#pragma once

#include <memory>
#include <span>

#include "base/snapshot.h"
#include "scene/view/layers.h"
#include "scene/view/view.h"

namespace fumon {

/// Whether a layer shows what follows from the bed, and changes with it.
bool any_of_ground(std::span<const LayerSettings> settings);

/// What becomes of more contours than ground_contours() makes: an InputError, or lines at ten, a
/// hundred … intervals, on a bed that has grown since its run began.
enum class ManyContours { refused, thinned };

/// Puts into `placed`, which has a layer for each of the settings, those of the ground: contours
/// and streams of a snapshot. Contours at multiples of five intervals are one and a half times as
/// wide, and have their heights as labels where they are asked for; streams are half a width wider
/// from order to order. Throws InputError as ground_contours() does, where these are refused.
void place_ground_layers(std::span<const LayerSettings> settings, const Snapshot& snapshot,
                         PlacedLayers& placed, ManyContours many = ManyContours::refused);

/// The layers of a view as they lie over a snapshot; null where it has none.
std::shared_ptr<const PlacedLayers> layers_over(const View& view, const Snapshot& snapshot);

}  // namespace fumon
