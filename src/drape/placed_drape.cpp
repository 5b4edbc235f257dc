#include "drape/placed_drape.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/error.h"
#include "files/gdal/gdal_functions.h"
#include "files/gdal/gdal_session.h"
#include "files/gdal/spatial_reference.h"

namespace fumon {

namespace {

constexpr int longest_side = 8192;  // pixels of a drape, which OpenGL's textures allow
constexpr int parts = 256;          // of a pixel, to which places are rounded
constexpr int nodes = 129;          // along each side of the bed, between which places are linear

/// Places in a picture, pixels from its upper left corner, over a bed: at nodes that lie evenly
/// from its western to its eastern and from its southern to its northern edge.
class PlacesInPicture {
  public:
    PlacesInPicture() : x_(nodes * nodes), y_(nodes * nodes) {}

    double& x(int column, int row) { return x_[at(column, row)]; }
    double& y(int column, int row) { return y_[at(column, row)]; }
    std::vector<double>& all_x() { return x_; }
    std::vector<double>& all_y() { return y_; }

    /// East and north: 0 … 1 over the bed.
    [[nodiscard]] std::array<double, 2> place(double east, double north) const {
        const double u = east * (nodes - 1);
        const double v = north * (nodes - 1);
        const int column = std::clamp(static_cast<int>(u), 0, nodes - 2);
        const int row = std::clamp(static_cast<int>(v), 0, nodes - 2);
        const auto between = [&](const std::vector<double>& values) {
            const double s = u - column;
            const double t = v - row;
            const double low =
                values[at(column, row)] * (1.0 - s) + values[at(column + 1, row)] * s;
            const double high =
                values[at(column, row + 1)] * (1.0 - s) + values[at(column + 1, row + 1)] * s;
            return low * (1.0 - t) + high * t;
        };
        return {between(x_), between(y_)};
    }

    /// How many pixels the bed is wide or high, along its middle.
    [[nodiscard]] double length(bool eastward) const {
        double sum = 0.0;
        for (int k = 0; k + 1 < nodes; ++k) {
            const std::size_t one = eastward ? at(k, nodes / 2) : at(nodes / 2, k);
            const std::size_t next = eastward ? at(k + 1, nodes / 2) : at(nodes / 2, k + 1);
            const double dx = x_[next] - x_[one];
            const double dy = y_[next] - y_[one];
            sum += std::sqrt(dx * dx + dy * dy);
        }
        return sum;
    }

  private:
    static std::size_t at(int column, int row) {
        return static_cast<std::size_t>(row) * nodes + static_cast<std::size_t>(column);
    }

    std::vector<double> x_;
    std::vector<double> y_;
};

/// Brings places from the bed's reference system to the picture's.
void transform(PlacesInPicture& places, const std::string& from, const std::string& to) {
    if (!has_gdal()) {
        throw InputError("lies in another reference system than the bed, and to bring it there " +
                         missing_gdal());
    }
    const GdalSession session;
    const SpatialReference bed(from);
    const SpatialReference picture(to);
    OGRCoordinateTransformationH way =
        bed.understood() && picture.understood()
            ? gdal().OCTNewCoordinateTransformation(bed.get(), picture.get())
            : nullptr;
    std::vector<double> heights(places.all_x().size());
    const bool done =
        way != nullptr &&
        gdal().OCTTransform(way, static_cast<int>(heights.size()), places.all_x().data(),
                            places.all_y().data(), heights.data()) != 0;
    if (way != nullptr) gdal().OCTDestroyCoordinateTransformation(way);
    const auto finite = [](double value) { return std::isfinite(value); };
    if (done && std::ranges::all_of(places.all_x(), finite) &&
        std::ranges::all_of(places.all_y(), finite))
        return;
    throw InputError(fmt::format(
        "cannot be brought to the bed's reference system{}{}; bring it there first (gdalwarp "
        "-t_srs)",
        session.fault().empty() ? "" : ": ", session.fault()));
}

/// From a reference system's coordinates to pixels.
void invert(PlacesInPicture& places, const std::array<double, 6>& t) {
    const double area = t[1] * t[5] - t[2] * t[4];
    for (std::size_t i = 0; i < places.all_x().size(); ++i) {
        const double east = places.all_x()[i] - t[0];
        const double north = places.all_y()[i] - t[3];
        places.all_x()[i] = (east * t[5] - north * t[2]) / area;
        places.all_y()[i] = (north * t[1] - east * t[4]) / area;
    }
}

PlacesInPicture places_over(const PictureSource& picture, const BedCells& bed) {
    PlacesInPicture places;
    const bool placed = picture.place() && bed.place;
    for (int row = 0; row < nodes; ++row) {
        for (int column = 0; column < nodes; ++column) {
            const double east = static_cast<double>(column) / (nodes - 1);
            const double north = static_cast<double>(row) / (nodes - 1);
            places.x(column, row) =
                placed ? bed.place->west + bed.place->dx * bed.nx * east : picture.width() * east;
            places.y(column, row) = placed ? bed.place->south + bed.place->dy * bed.ny * north
                                           : picture.height() * (1.0 - north);
        }
    }
    if (!placed) return places;
    const std::string from = system_of(*bed.place);
    const std::string& to = picture.place()->crs;
    if (!from.empty() && !to.empty() && from != to) transform(places, from, to);
    invert(places, picture.place()->transform);
    return places;
}

/// The pixels that the bed reaches and one more on each side; none where the picture lies beside.
PixelWindow window_of(PlacesInPicture& places, const PictureSource& picture) {
    const auto reach = [](const std::vector<double>& values, int count) {
        const auto [low, high] = std::ranges::minmax(values);
        const int first =
            static_cast<int>(std::floor(std::clamp(low - 1.0, 0.0, static_cast<double>(count))));
        const int end =
            static_cast<int>(std::ceil(std::clamp(high + 1.0, 0.0, static_cast<double>(count))));
        const bool meets = high > 0.0 && low < count;
        return std::array{first, meets ? end - first : 0};
    };
    const auto [left, width] = reach(places.all_x(), picture.width());
    const auto [top, height] = reach(places.all_y(), picture.height());
    return {left, top, width, height};
}

/// The nearest of two pixels and how far the other counts, of `parts`.
struct Nearest {
    int low = 0;
    int high = 0;
    std::uint64_t share = 0;  ///< of the higher one
};

/// `place`: in pixels of a block, from its edge.
Nearest nearest(double place, int count) {
    const auto rounded = static_cast<std::int64_t>(std::floor((place - 0.5) * parts + 0.5));
    const std::int64_t cell = rounded >= 0 ? rounded / parts : -((-rounded + parts - 1) / parts);
    const auto within = [count](std::int64_t pixel) {
        return static_cast<int>(std::clamp<std::int64_t>(pixel, 0, count - 1));
    };
    return {within(cell), within(cell + 1), static_cast<std::uint64_t>(rounded - cell * parts)};
}

/// Writes what lies between four pixels.
void blend(const PixelBlock& block, const Nearest& x, const Nearest& y, std::uint8_t* texel) {
    const auto pixel = [&](int column, int row) {
        return block.rgba.data() + 4 * (static_cast<std::ptrdiff_t>(row) * block.width + column);
    };
    const std::array<const std::uint8_t*, 4> corners{pixel(x.low, y.low), pixel(x.high, y.low),
                                                     pixel(x.low, y.high), pixel(x.high, y.high)};
    const std::array<std::uint64_t, 4> weights{(parts - x.share) * (parts - y.share),
                                               x.share * (parts - y.share),
                                               (parts - x.share) * y.share, x.share * y.share};
    std::array<std::uint64_t, 4> sums{};
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const std::uint64_t opacity = weights[corner] * corners[corner][3];
        for (std::size_t channel = 0; channel < 3; ++channel)
            sums[channel] += opacity * corners[corner][channel];
        sums[3] += opacity;
    }
    constexpr std::uint64_t all = static_cast<std::uint64_t>(parts) * parts;
    for (std::size_t channel = 0; channel < 3; ++channel)
        texel[channel] =
            static_cast<std::uint8_t>(sums[3] == 0 ? 0 : (sums[channel] + sums[3] / 2) / sums[3]);
    texel[3] = static_cast<std::uint8_t>((sums[3] + all / 2) / all);
}

/// Pixels of a drape along both sides: as the picture has, even fractions of these where they are
/// too many.
std::array<int, 2> size_of(const PlacesInPicture& places) {
    double width = std::max(1.0, std::round(places.length(true)));
    double height = std::max(1.0, std::round(places.length(false)));
    while (width > longest_side || height > longest_side ||
           width * height > static_cast<double>(most_drape_pixels)) {
        width = std::max(1.0, std::ceil(0.5 * width));
        height = std::max(1.0, std::ceil(0.5 * height));
    }
    return {static_cast<int>(width), static_cast<int>(height)};
}

}  // namespace

std::string system_of(const GeoReference& place) {
    return place.crs.empty() && place.degrees ? "EPSG:4326" : place.crs;
}

Drape placed_drape(const PictureSource& picture, const BedCells& bed) {
    PlacesInPicture places = places_over(picture, bed);
    const PixelWindow window = window_of(places, picture);
    if (window.width == 0 || window.height == 0) {
        throw InputError(
            "lies beside the bed; name a picture of the bed's place, or take its georeference "
            "away to fit it to the bed");
    }
    const auto [width, height] = size_of(places);
    const int reduction = std::max(
        1, static_cast<int>(std::min(places.length(true) / width, places.length(false) / height)));
    const PixelBlock block = picture.reduced(window, reduction);
    Drape drape{width, height, {}};
    drape.texels.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    constexpr double rounding = 1e-6;  // of a pixel
    const double right = picture.width() + rounding;
    const double bottom = picture.height() + rounding;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const auto [x, y] = places.place((column + 0.5) / width, (row + 0.5) / height);
            if (x < -rounding || y < -rounding || x > right || y > bottom) continue;
            blend(block, nearest((x - window.left) / reduction, block.width),
                  nearest((y - window.top) / reduction, block.height),
                  drape.texels.data() + 4 * (static_cast<std::ptrdiff_t>(row) * width + column));
        }
    }
    return drape;
}

Drape fitted_drape(Image image) {
    return placed_drape(*picture_of(std::move(image)), {});
}

}  // namespace fumon
