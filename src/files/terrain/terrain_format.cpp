#include "files/terrain/terrain_format.h"

#include <algorithm>
#include <array>
#include <utility>

#include "files/terrain/esri_ascii.h"
#include "files/terrain/geotiff.h"
#include "files/terrain/netcdf_bed.h"
#include "files/terrain/png_heights.h"
#include "files/terrain/raster.h"

namespace fumon {

std::span<const TerrainFormat> terrain_formats() {
    static const std::array formats{netcdf_format(),        geotiff_format(),
                                    cloud_geotiff_format(), png_heights_format(),
                                    other_raster_format(),  esri_ascii_format()};
    return formats;
}

std::string terrain_titles() {
    std::string text;
    const auto formats = terrain_formats();
    for (std::size_t k = 0; k < formats.size(); ++k) {
        if (formats[k].name == cloud_geotiff_name) continue;  // a GeoTIFF as any other
        if (k > 0) text += k + 1 == formats.size() ? " or " : ", ";
        text += formats[k].title;
    }
    return text;
}

std::string written_terrain_formats() {
    std::string text;
    for (const TerrainFormat& format : terrain_formats()) {
        if (format.write == nullptr) continue;
        if (!text.empty()) text += ", ";
        text += format.name;
    }
    return text;
}

const TerrainFormat* find_written_format(std::string_view name) {
    const auto formats = terrain_formats();
    const auto found = std::ranges::find_if(formats, [&](const TerrainFormat& format) {
        return format.name == name && format.write != nullptr;
    });
    return found == formats.end() ? nullptr : &*found;
}

std::vector<TerrainBytes> bed_files(const Snapshot& snapshot, std::span<const std::string> names) {
    Grid heights = snapshot.bed;
    for (double& height : heights.values()) height *= snapshot.scale.height_unit;
    std::vector<TerrainBytes> files;
    for (const std::string& name : names) {
        for (TerrainBytes& file :
             find_written_format(name)->write({heights, snapshot.nodata, snapshot.scale}))
            files.push_back(std::move(file));
    }
    return files;
}

}  // namespace fumon
