#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_variable.h"
#include "files/unit_conversion.h"
#include "foreign/quantity.h"
#include "foreign/variable_names.h"

namespace fumon {

/// What the values of a map belong to: cells over two sides, or parts of a mesh.
enum class MapPlace { cells, nodes, faces };

/// A map that a file holds.
struct ForeignMap {
    BedVariable variable;
    MapPlace place = MapPlace::cells;
    std::string known_as;  ///< its name in the table of models
    std::string side{};    ///< of a mesh: the dimension of its nodes or faces
    std::string standard_name;
    std::string unit;
    std::string positive{};  ///< "down" where heights grow downward; empty where the file says none
    std::string dimensions;  ///< "time, n, m"
    bool over_time = false;  ///< along the run's dimension of records
};

/// A map that was chosen for a quantity.
struct ChosenMap {
    Quantity quantity = Quantity::bed;
    ForeignMap map;
    std::string reason;
    bool grows_downward = false;  ///< by the table of models
};

/// The maps that may be fields of a run with these records (−1: none): those along them or along no
/// records.
std::vector<ForeignMap> maps_of(const NetcdfInput& input, int records);

/// The dimension of a run's records: that of most maps, of a time where there is one; −1 where no
/// map has records.
int dimension_of_records(const NetcdfInput& input);

/// The words of a file's attributes by which its model may be known.
std::string words_of_file(const NetcdfInput& input);

/// The model that wrote a file: by such words, else that of which most names fit; null where none
/// does.
const ForeignModel* model_of_maps(const std::string& words, const std::vector<ForeignMap>& maps);

/// Which map is which quantity. `named`: by the user. Throws InputError, with the candidates, for a
/// name that the file has not, where two maps fit one quantity, and where none is the bed, unless
/// `has_bed` of another file.
std::vector<ChosenMap> choose_maps(const std::string& file, const std::vector<ForeignMap>& maps,
                                   const ForeignModel* model,
                                   const std::map<Quantity, std::string>& named, bool has_bed);

/// From a map's numbers to fumon's: by its unit, of beds downward by its attributes and the table
/// of models. Throws InputError for a unit that measures something else.
UnitConversion conversion_of(const std::string& file, const ChosenMap& chosen);

}  // namespace fumon
