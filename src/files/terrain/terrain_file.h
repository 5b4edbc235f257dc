#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/grid.h"
#include "files/terrain/terrain_window.h"

namespace fumon {

/// Heights as a file holds them: metres, row 0 southernmost, with the cells that hold no data.
struct Terrain {
    Grid heights;     ///< metres; 0 in no-data cells
    Mask nodata;      ///< empty when every cell has data
    double dx = 0.0;  ///< metres; 0 when the file does not say (PNG, NetCDF in sites)
    double dy = 0.0;
    double metres_per_number = 1.0;  ///< of the file's own numbers; negative for depths
    std::string
        note;  ///< what was converted and the user should hear ("degrees to metres at …"); or empty
    std::optional<GeoReference> place{};  ///< where it lies; none where the file does not say
};

/// Adds a remark to a terrain's note, after "; "; nothing where it is empty.
void add_note(Terrain& terrain, const std::string& remark);

/// Whether a file's numbers are heights or depths; automatic: as the file says.
enum class HeightSign { automatic, up, down };

/// What a scene says of how its terrain file is to be read.
struct TerrainQuery {
    std::vector<double> png_heights{};  ///< metres of black and of white of a PNG; else empty
    std::string variable{};  ///< of a NetCDF file or a container; empty for what it suggests itself
    std::int64_t band = 0;   ///< of a raster, from 1; 0 for its only or first one
    std::int64_t record = 0;        ///< of a NetCDF variable over time, from 1; 0 for its last one
    bool must_name_record = false;  ///< where it has several
    std::optional<TerrainWindow> window{};  ///< the part to read; none for all
    std::string height_unit{};              ///< instead of the unit that the file names
    double height_factor = 1.0;             ///< by which heights are multiplied besides
    HeightSign height_sign = HeightSign::automatic;
    bool any_unit = false;  ///< the numbers are no heights
    std::string
        wanted_unit{};    ///< of such numbers ("mm/h"), see conversion_for(); empty: as they are
    bool trusted = true;  ///< its user named it; else its format may name no other file
};

/// Reads a terrain file of any of the formats in terrain_format.h, told by its first bytes: the
/// whole of it, or a window.
/// Heights become metres: by the unit that the file names, or by height_unit, height_factor and
/// height_sign, for every format. Cell sizes in degrees are recognised (see geographic.h for the
/// rule) and converted at the mid-latitude of what is read (dx ≠ dy), which `note` says. At most
/// 2^27 cells are read. Throws InputError "file:line: what is wrong; what would be right" for every
/// malformed file ("file: …" where there are no lines), and for a query that the format has no use
/// for.
Terrain read_terrain(const std::filesystem::path& file, const TerrainQuery& query = {});

/// Fills no-data cells smoothly from their rim: the discrete Laplace equation on the holes, with no
/// slope across the grid's edge; the other cells stay as they are. Exact for up to 300,000 hole
/// cells; beyond, an iteration that starts from the filling of a grid half as fine stops within
/// about 0.1 % of the relief. Throws InputError when all is hole.
Grid fill_nodata(const Grid& heights, const Mask& nodata);

}  // namespace fumon
