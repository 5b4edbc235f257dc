#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "files/terrain/terrain_file.h"
#include "files/unit_conversion.h"

namespace fumon {

/// From the unit that a file names ("" where it names none) to what a query asks for: metres of
/// heights, whose unit TerrainQuery::height_unit may say instead; else TerrainQuery::wanted_unit,
/// in which numbers without a unit are taken to be. Rates and amounts of water may be masses over
/// an area, at 1000 kg/m³. Units with fractional powers, which UDUNITS cannot read (s/m^(1/3)),
/// have to be the same, however they are written. Nothing where the unit measures something else.
std::optional<UnitConversion> conversion_for(const TerrainQuery& query, std::string_view file_unit);

/// "heights are in a unit of length …" or "… becomes mm/h": what would be right, with a remedy.
std::string wanted_units(const TerrainQuery& query, std::string_view remedy);

/// What the user should hear of a conversion; empty where numbers stay as they are.
std::string conversion_note(const TerrainQuery& query, std::string_view file_unit,
                            const UnitConversion& conversion);

/// Whether numbers grow downward, as depths below the sea do, by CF's attributes of a variable:
/// `positive` where it has one, else its standard name.
bool grows_downward(const std::string& positive, const std::string& standard_name);

}  // namespace fumon
