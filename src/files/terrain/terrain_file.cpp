#include "files/terrain/terrain_file.h"

#include <fmt/format.h>

#include "base/error.h"
#include "files/input_file.h"
#include "files/netcdf/netcdf_input.h"
#include "files/png_reader.h"
#include "files/terrain/esri_ascii.h"
#include "files/terrain/netcdf_bed.h"
#include "files/terrain/png_heights.h"

namespace fumon {

namespace {

void refuse_heights(const std::filesystem::path& file, std::string_view kind) {
    throw InputError(
        fmt::format("{}: a height range was given for {}, which holds its own heights; leave "
                    "bed.heights or --heights out",
                    file.string(), kind));
}

void refuse_variable(const std::filesystem::path& file, std::string_view kind) {
    throw InputError(
        fmt::format("{}: a variable was named for {}, which has none; leave "
                    "bed.variable out",
                    file.string(), kind));
}

}  // namespace

Terrain read_terrain(const std::filesystem::path& file, const std::vector<double>& png_heights,
                     const std::string& variable) {
    if (is_netcdf(start_of_input_file(file, netcdf_signature_length))) {
        if (!png_heights.empty()) refuse_heights(file, "a NetCDF file");
        return read_netcdf_bed(file, variable);
    }
    if (const auto extension = file.extension(); extension == ".nc" || extension == ".nc4")
        throw InputError(
            fmt::format("{}: is not a NetCDF file; such a file starts with \"CDF\" or "
                        "\"HDF\", so it may be damaged or bear a wrong name",
                        file.string()));
    const std::string bytes = read_input_file(file);
    if (is_png(bytes)) {
        if (!variable.empty()) refuse_variable(file, "a PNG image");
        return parse_png_heights(bytes, file.string(), png_heights);
    }
    Terrain terrain = parse_esri_ascii({file.string(), bytes});
    if (!png_heights.empty()) refuse_heights(file, "an ESRI ASCII grid");
    if (!variable.empty()) refuse_variable(file, "an ESRI ASCII grid");
    return terrain;
}

}  // namespace fumon
