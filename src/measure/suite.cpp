#include "measure/suite.h"

#include <array>
#include <string_view>

#include "base/snapshot_lookup.h"
#include "measure/air/air_groups.h"
#include "measure/bed/bed_groups.h"
#include "measure/number_group.h"
#include "measure/pile/pile_groups.h"
#include "measure/water/water_groups.h"

namespace fumon {

namespace {

struct WorldUnit {
    std::string_view unit;
    std::string_view in_metres;
    double (*factor)(const WorldScale& scale);
};

constexpr std::array world_units{
    WorldUnit{"sites", "m", [](const WorldScale& s) { return s.dx; }},
    WorldUnit{"heights", "m", [](const WorldScale& s) { return s.height_unit; }},
    WorldUnit{"cells", "m2", [](const WorldScale& s) { return s.dx * s.dy; }},
    WorldUnit{"heights x cells", "m3",
              [](const WorldScale& s) { return s.height_unit * s.dx * s.dy; }},
    WorldUnit{"heights/site", "", [](const WorldScale& s) { return s.height_unit / s.dx; }},
    WorldUnit{"sites/step", "m/step", [](const WorldScale& s) { return s.dx; }},
    WorldUnit{"1/cell", "1/m2", [](const WorldScale& s) { return 1.0 / (s.dx * s.dy); }},
    WorldUnit{"1/site", "1/m", [](const WorldScale& s) { return 1.0 / s.dx; }},
};

}  // namespace

Landform landform_of(const Snapshot& snapshot) {
    if (number_of(snapshot, "dropped_grains")) return Landform::pile;
    if (field_of(snapshot.fields, "water_depth") != nullptr) return Landform::water;
    if (snapshot.section) return Landform::air;
    return snapshot.bed.ny() == 1 ? Landform::profile : Landform::bed;
}

MeasuredValue in_world_units(const MeasuredValue& measured, const WorldScale& scale) {
    if (!scale.in_metres) return measured;
    MeasuredValue result = measured;
    for (const WorldUnit& one : world_units) {
        if (one.unit != measured.column.unit) continue;
        result.column.unit = one.in_metres;
        result.value *= one.factor(scale);
        break;
    }
    return result;
}

class MeasureSuite::Parts {
  public:
    std::vector<MeasureGroup> groups;
    std::vector<MeasureColumn> columns;
};

namespace {

std::vector<MeasureGroup> groups_of(Landform landform, const Snapshot& first) {
    std::vector<MeasureGroup> groups;
    groups.push_back(statistics_group());
    switch (landform) {
        case Landform::bed:
        case Landform::profile:
            groups.push_back(wave_group());
            groups.push_back(celerity_group());
            groups.push_back(slope_group());
            if (landform == Landform::profile) break;
            groups.push_back(crest_group());
            groups.push_back(dune_group());
            break;
        case Landform::pile:
            groups.push_back(pile_group());
            groups.push_back(avalanche_group());
            break;
        case Landform::water:
            groups.push_back(channel_group());
            groups.push_back(water_relief_group());
            groups.push_back(water_flow_group());
            break;
        case Landform::air:
            groups.push_back(stress_group());
            groups.push_back(air_group());
            groups.push_back(flight_group(first));
            break;
    }
    return groups;
}

void append(std::vector<MeasureColumn>& columns, const MeasureGroup& group) {
    columns.insert(columns.end(), group.columns.begin(), group.columns.end());
}

}  // namespace

MeasureSuite::MeasureSuite(Landform landform, const Snapshot& first)
    : parts_(std::make_unique<Parts>()) {
    std::vector<MeasureColumn>& columns = parts_->columns;
    parts_->groups = groups_of(landform, first);
    for (const MeasureGroup& group : parts_->groups) append(columns, group);
    if (landform == Landform::water || landform == Landform::air) {
        parts_->groups.push_back(number_group(first, columns));
        append(columns, parts_->groups.back());
    }
}

MeasureSuite::~MeasureSuite() = default;

const std::vector<MeasureColumn>& MeasureSuite::columns() const {
    return parts_->columns;
}

void MeasureSuite::note(std::span<const Avalanche> avalanches) {
    for (const MeasureGroup& group : parts_->groups) {
        if (group.note) group.note(avalanches);
    }
}

void MeasureSuite::carry(StateCarrier& carrier) {
    for (const MeasureGroup& group : parts_->groups) {
        if (group.carry) group.carry(carrier);
    }
}

std::vector<double> MeasureSuite::row(const Snapshot& snapshot) {
    std::vector<double> values;
    values.reserve(parts_->columns.size());
    for (const MeasureGroup& group : parts_->groups) {
        const std::vector<double> some = group.values(snapshot);
        values.insert(values.end(), some.begin(), some.end());
    }
    return values;
}

}  // namespace fumon
