#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/snapshot.h"
#include "figure/panels/colour_bar.h"
#include "render/colour/colouring.h"
#include "scene/scene.h"

namespace fumon {

/// A field over the ground and the colours that show it: a plain value.
struct MapPicture {
    Grid values;         ///< in the unit that the colours' label states; row 0 is the southernmost
    Mask blank;          ///< 1: a cell without a value; empty: none
    Field<float> light;  ///< of hill_light, of the same size; empty: not shaded
    WorldScale scale;
    ColourScale colours;
    /// Seen where cells have no value, over the same ground; null: none.
    std::shared_ptr<const Drape> background{};
};

/// The palette in which a quantity is shown where look.palette is "sand", that of beds seen as
/// sand.
const char* usual_palette(Colouring colour_by);

/// What a colour bar of the field that look.field names says, or of its change: the name, in words
/// where the model has some, and the unit. `called`: another name. Throws InputError where the
/// snapshot has no such field.
std::string field_label(const LookSettings& look, const Snapshot& snapshot,
                        const std::string& called = {});

/// A picture of what look.colour_by says, with look's palette ("sand", the one for beds seen as
/// sand, gives way to one that suits the quantity) and range, in metres or millimetres of height
/// where the snapshot has metres. `first` is the reference of "change". Natural colouring shows the
/// height. Throws InputError for a quantity of the water where there is none, and where there is no
/// such palette.
MapPicture map_picture(const LookSettings& look, const Snapshot& snapshot, const Snapshot& first,
                       const RangeTails& tails = {});

/// The same for several snapshots, of one run or of several, that are seen side by side: one unit,
/// and one range that holds the ranges of all. `tails` are those of colour_range().
std::vector<MapPicture> map_pictures(const LookSettings& look, std::span<const Snapshot> snapshots,
                                     const Snapshot& first, const RangeTails& tails = {});

/// A picture of the model's field of that name, where look does not say between its least and
/// greatest value, or the percentiles that `tails` cut off. Throws InputError where the model has
/// no such field.
MapPicture field_picture(const LookSettings& look, const Snapshot& snapshot, std::string_view name,
                         const RangeTails& tails = {0.0, 0.0});

/// The least and the greatest value of a picture; nothing where every cell is blank.
std::optional<std::pair<double, double>> values_of(const MapPicture& picture);

/// The picture's cells as pixels, north up; blank ones take `blank`. Where a side has more than
/// `most` cells, k × k of them are averaged first, the smallest k that will do. Light multiplies
/// luminance and nothing else. A background gives the picture as many pixels to a cell as it has
/// itself, up to `most` a side; it has no light.
Image map_image(const MapPicture& picture, const Ink& blank, int most);

}  // namespace fumon
