#include "files/snapshot_outline.h"

#include <memory>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/limits.h"
#include "files/json_text.h"

namespace fumon {

namespace {

nlohmann::ordered_json scale_json(const WorldScale& scale) {
    nlohmann::ordered_json json{{"dx", scale.dx},
                                {"dy", scale.dy},
                                {"height_unit", scale.height_unit},
                                {"in_metres", scale.in_metres}};
    if (const auto& place = scale.place) {
        json["place"] = {{"west", place->west}, {"south", place->south},     {"dx", place->dx},
                         {"dy", place->dy},     {"degrees", place->degrees}, {"crs", place->crs}};
    }
    return json;
}

/// Outlines of earlier versions have no place.
WorldScale read_scale(const nlohmann::ordered_json& json) {
    WorldScale scale{json.at("dx"), json.at("dy"), json.at("height_unit"), json.at("in_metres")};
    if (json.contains("place")) {
        const auto& place = json.at("place");
        scale.place = {place.at("west"), place.at("south"),   place.at("dx"),
                       place.at("dy"),   place.at("degrees"), place.at("crs")};
    }
    return scale;
}

/// Fields and curves alike.
template <class Named>
nlohmann::ordered_json names_json(const std::vector<Named>& list) {
    auto json = nlohmann::ordered_json::array();
    for (const Named& one : list)
        json.push_back({{"name", one.name}, {"long_name", one.long_name}, {"unit", one.unit}});
    return json;
}

template <class Named>
std::vector<Named> read_names(const nlohmann::ordered_json& json) {
    std::vector<Named> list;
    for (const auto& one : json)
        list.push_back({one.at("name"), one.at("long_name"), one.at("unit"), {}});
    return list;
}

std::shared_ptr<const SnapshotSection> read_section_outline(const nlohmann::ordered_json& json) {
    return std::make_shared<const SnapshotSection>(
        SnapshotSection{json.at("dx"),
                        json.at("dz"),
                        read_names<SnapshotField>(json.at("fields")),
                        read_names<SectionCurve>(json.at("curves")),
                        {}});
}

}  // namespace

nlohmann::ordered_json outline_json(const Snapshot& snapshot) {
    nlohmann::ordered_json json;
    json["time_unit"] = snapshot.time_unit;
    json["nx"] = snapshot.bed.nx();
    json["ny"] = snapshot.bed.ny();
    json["masked"] = !snapshot.nodata.empty();
    json["scale"] = scale_json(snapshot.scale);
    json["highest_expected"] = snapshot.highest_expected;
    json["periodic"] = snapshot.periodic;
    json["fields"] = names_json(snapshot.fields);
    json["numbers"] = nlohmann::ordered_json::array();
    for (const SnapshotNumber& number : snapshot.numbers)
        json["numbers"].push_back({{"name", number.name}, {"unit", number.unit}});
    for (const SnapshotWind& wind : snapshot.winds)
        json["winds"].push_back({{"x", wind.x}, {"y", wind.y}, {"drift", wind.drift}});
    if (const SnapshotSection* section = snapshot.section.get()) {
        json["section"] = {{"dx", section->dx},
                           {"dz", section->dz},
                           {"fields", names_json(section->fields)},
                           {"curves", names_json(section->curves)}};
    }
    return json;
}

Snapshot read_outline(const nlohmann::ordered_json& json) {
    Snapshot snapshot;
    snapshot.time_unit = json.at("time_unit");
    const std::int64_t nx = whole_number(json.at("nx"));
    const std::int64_t ny = whole_number(json.at("ny"));
    if (nx < 1 || ny < 1 || nx > largest_grid_cells / ny)
        throw InputError("no bed has that many cells");
    snapshot.bed = Grid(static_cast<int>(nx), static_cast<int>(ny));
    if (json.at("masked")) snapshot.nodata = Mask(snapshot.bed.nx(), snapshot.bed.ny());
    snapshot.scale = read_scale(json.at("scale"));
    snapshot.highest_expected = json.at("highest_expected");
    snapshot.periodic = json.at("periodic");
    snapshot.fields = read_names<SnapshotField>(json.at("fields"));
    for (const auto& number : json.at("numbers"))
        snapshot.numbers.push_back({number.at("name"), number.at("unit"), 0.0});
    if (json.contains("winds")) {
        for (const auto& wind : json.at("winds"))
            snapshot.winds.push_back({wind.at("x"), wind.at("y"), wind.at("drift")});
    }
    if (json.contains("section")) snapshot.section = read_section_outline(json.at("section"));
    return snapshot;
}

}  // namespace fumon
