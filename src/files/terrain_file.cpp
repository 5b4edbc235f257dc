#include "files/terrain_file.h"

#include <fmt/format.h>

#include "files/esri_ascii.h"
#include "files/input_file.h"
#include "files/png_heights.h"
#include "files/png_reader.h"
#include "support/error.h"

namespace fumon {

Terrain read_terrain(const std::filesystem::path& file, const std::vector<double>& png_heights) {
    const std::string bytes = read_input_file(file);
    if (is_png(bytes)) return parse_png_heights(bytes, file.string(), png_heights);
    Terrain terrain = parse_esri_ascii({file.string(), bytes});
    if (!png_heights.empty())
        throw InputError(
            fmt::format("{}: a height range was given for an ESRI ASCII grid, which holds its own "
                        "heights; leave bed.heights or --heights out",
                        file.string()));
    return terrain;
}

}  // namespace fumon
