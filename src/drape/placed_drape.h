#pragma once

#include <optional>
#include <string>

#include "base/geo_reference.h"
#include "base/image.h"
#include "drape/picture_source.h"
#include "scene/view/drape.h"

namespace fumon {

/// The cells of a bed, and where they lie; no place where the bed does not say.
struct BedCells {
    int nx = 0;
    int ny = 0;
    std::optional<GeoReference> place{};
};

/// The reference system of a place: WGS 84 where it has degrees and names none; empty where it is
/// not known.
std::string system_of(const GeoReference& place);

/// The most pixels of a drape, over the whole bed.
inline constexpr long long most_drape_pixels = 1LL << 24;

/// A picture brought to the extent of a bed, with about as many pixels as it has there, as far as
/// `most_drape_pixels` allow. Where both say where they lie, it is brought to the bed's reference
/// system (PROJ, through GDAL) and sampled bilinearly, in integers, at places rounded to 1/256 of a
/// pixel; pixels as the bed's own lattice has them stay as they are. Else it is fitted to the bed's
/// extent. Throws InputError where it lies beside the bed or cannot be brought to the bed's system.
Drape placed_drape(const PictureSource& picture, const BedCells& bed);

/// An image, whose first row is the northernmost, fitted to the extent of a bed.
Drape fitted_drape(Image image);

}  // namespace fumon
