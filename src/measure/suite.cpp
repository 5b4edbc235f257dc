#include "measure/suite.h"

#include <array>
#include <string_view>
#include <type_traits>

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

Landform measured_landform(const Snapshot& snapshot) {
    if (snapshot.landform != Landform::bed && snapshot.landform != Landform::terrain)
        return snapshot.landform;
    return snapshot.bed.ny() == 1 ? Landform::profile : Landform::bed;
}

Landform guessed_landform(const Snapshot& snapshot) {
    if (number_of(snapshot, "dropped_grains")) return Landform::pile;
    if (field_of(snapshot.fields, "water_depth") != nullptr) return Landform::water;
    if (snapshot.section) return Landform::air;
    return Landform::bed;
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

using MakeGroup = MeasureGroup (*)(const Snapshot& first, std::span<const MeasureColumn> taken);

/// A group and the landforms that have it.
struct SuiteGroup {
    MakeGroup make;
    unsigned landforms;  ///< bits
};

constexpr unsigned bit(Landform landform) {
    return 1U << static_cast<unsigned>(landform);
}

constexpr unsigned beds = bit(Landform::bed) | bit(Landform::terrain);
constexpr unsigned beds_and_profiles = beds | bit(Landform::profile);
constexpr unsigned piles = bit(Landform::pile);
constexpr unsigned water = bit(Landform::water);
constexpr unsigned air = bit(Landform::air);
constexpr unsigned all = beds_and_profiles | piles | water | air;

/// Groups take what they need: nothing, the first snapshot, or also the columns before theirs.
template <auto group>
constexpr SuiteGroup of(unsigned landforms) {
    return {[](const Snapshot& first, std::span<const MeasureColumn> taken) -> MeasureGroup {
                if constexpr (std::is_invocable_v<decltype(group)>) {
                    return group();
                } else if constexpr (std::is_invocable_v<decltype(group), const Snapshot&>) {
                    return group(first);
                } else {
                    return group(first, taken);
                }
            },
            landforms};
}

/// Every group, in the order of its columns. A new measure is a line here.
constexpr std::array suite_groups{
    of<statistics_group>(all),
    of<wave_group>(beds_and_profiles),
    of<celerity_group>(beds_and_profiles),
    of<slope_group>(beds_and_profiles),
    of<crest_group>(beds),
    of<dune_group>(beds),
    of<pile_group>(piles),
    of<avalanche_group>(piles),
    of<channel_group>(water),
    of<water_relief_group>(water),
    of<water_flow_group>(water),
    of<stress_group>(air),
    of<air_group>(air),
    of<flight_group>(air),
    of<number_group>(water | air),
};

}  // namespace

MeasureSuite::MeasureSuite(Landform landform, const Snapshot& first)
    : parts_(std::make_unique<Parts>()) {
    std::vector<MeasureColumn>& columns = parts_->columns;
    for (const SuiteGroup& group : suite_groups) {
        if ((group.landforms & bit(landform)) == 0) continue;
        parts_->groups.push_back(group.make(first, columns));
        const std::vector<MeasureColumn>& own = parts_->groups.back().columns;
        columns.insert(columns.end(), own.begin(), own.end());
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
