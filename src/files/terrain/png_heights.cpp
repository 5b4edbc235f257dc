#include "files/terrain/png_heights.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/error.h"
#include "base/limits.h"
#include "files/input_file.h"
#include "files/png_reader.h"

namespace fumon {

namespace {

[[noreturn]] void refuse(const std::string& name, std::string_view what, std::string_view remedy) {
    throw InputError(fmt::format("{}: {}; {}", name, what, remedy));
}

void check_range(const std::string& name, const std::vector<double>& range) {
    constexpr std::string_view how =
        "write bed.heights = [low, high] in the scene or --heights low:high, the metres of black "
        "and "
        "of white";
    if (range.empty()) refuse(name, "a PNG image has no height scale", how);
    if (range.size() != 2 || !std::isfinite(range[0]) || !std::isfinite(range[1]) ||
        range[0] == range[1])
        refuse(name, "the height range of the PNG image is not two different finite numbers", how);
}

void check_picture(const std::string& name, const PngInfo& info) {
    constexpr std::string_view remedy = "save it as a 16-bit grey PNG without alpha";
    switch (info.colour) {
        case PngColour::grey:
            break;
        case PngColour::grey_alpha:
            refuse(name, "is a grey image with alpha", remedy);
        case PngColour::palette:
            refuse(name, "is a palette image", remedy);
        case PngColour::rgb:
            refuse(name, "is a colour image", remedy);
        case PngColour::rgb_alpha:
            refuse(name, "is a colour image with alpha", remedy);
    }
    if (info.transparent_colour) refuse(name, "has a transparent grey value", remedy);
    if (info.bit_depth < 8)
        refuse(name, fmt::format("has {}-bit grey values", info.bit_depth), remedy);
    const long long cells = static_cast<long long>(info.width) * info.height;
    if (cells > largest_grid_cells)
        refuse(name, fmt::format("has {} × {} = {} pixels", info.width, info.height, cells),
               fmt::format("at most {} are read; cut out or coarsen the part you need",
                           largest_grid_cells));
}

}  // namespace

Terrain parse_png_heights(std::string_view bytes, const std::string& name,
                          const std::vector<double>& range) {
    PngReader reader(bytes, name);
    const PngInfo info = reader.info();
    check_picture(name, info);
    check_range(name, range);
    const std::vector<std::uint8_t> samples = reader.samples();

    Terrain terrain;
    terrain.heights = Grid(info.width, info.height);
    const bool two_bytes = info.bit_depth == 16;
    const double white = two_bytes ? 65535.0 : 255.0;
    std::size_t next = 0;
    for (int y = info.height - 1; y >= 0; --y) {
        for (double& height : terrain.heights.row(y)) {
            unsigned value = samples[next++];
            if (two_bytes) value = 256U * value + samples[next++];
            const double share = value / white;
            height = range[0] * (1.0 - share) + range[1] * share;
        }
    }
    if (!two_bytes)
        terrain.note = fmt::format(
            "8-bit grey values: heights come in 256 levels, {:.4g} m apart; a 16-bit PNG is "
            "smoother",
            std::abs(range[1] - range[0]) / white);
    return terrain;
}

TerrainFormat png_heights_format() {
    return {.name = "png",
            .title = "a PNG image",
            .is_one = [](const std::filesystem::path&,
                         std::string_view start) { return is_png(start); },
            .read =
                [](const std::filesystem::path& file, const TerrainQuery& query) {
                    Terrain terrain =
                        parse_png_heights(read_input_file(file), file.string(), query.png_heights);
                    crop(terrain, query.window, file.string());
                    return terrain;
                },
            .has_heights = false};
}

}  // namespace fumon
