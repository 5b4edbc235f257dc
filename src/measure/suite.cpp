#include "measure/suite.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <string_view>
#include <type_traits>
#include <utility>

#include "base/snapshot_lookup.h"
#include "base/worker_pool.h"
#include "measure/air/air_groups.h"
#include "measure/bed/bed_findings.h"
#include "measure/bed/bed_groups.h"
#include "measure/network/network_groups.h"
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
    return Landform::terrain;
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
    struct Part {
        std::string_view name;
        MeasureGroup group;
        std::vector<bool> wanted;  ///< of its columns
        bool any_wanted = false;
    };
    std::vector<Part> parts;
    std::vector<MeasureColumn> measured;  ///< as the groups have them
    std::vector<MeasureColumn> columns;   ///< as they are told
    bool in_metres = false;
    SharedFindings findings = std::make_shared<BedFindings>();
};

namespace {

/// What a group is made from.
struct GroupRequest {
    Landform landform;
    const Snapshot& first;
    std::span<const MeasureColumn> taken;  ///< the columns before its own
    const MeasureChoice& choice;
    SharedFindings findings;  ///< of the snapshot that is measured
};

using MakeGroup = MeasureGroup (*)(const GroupRequest& request);

/// A group and the landforms that have it.
struct SuiteGroup {
    std::string_view name;
    MakeGroup make;
    unsigned landforms;  ///< bits
};

constexpr unsigned bit(Landform landform) {
    return 1U << static_cast<unsigned>(landform);
}

constexpr unsigned on_beds = bit(Landform::bed) | bit(Landform::terrain);
constexpr unsigned on_beds_and_profiles = on_beds | bit(Landform::profile);
constexpr unsigned on_piles = bit(Landform::pile);
constexpr unsigned on_water = bit(Landform::water);
constexpr unsigned of_air = bit(Landform::air);
constexpr unsigned everywhere = on_beds_and_profiles | on_piles | on_water | of_air;

/// Groups take what they need: nothing, the first snapshot, what measures share, the columns before
/// theirs, or all.
template <auto group>
constexpr SuiteGroup entry(std::string_view name, unsigned landforms) {
    return {name,
            [](const GroupRequest& request) -> MeasureGroup {
                if constexpr (std::is_invocable_v<decltype(group)>) {
                    return group();
                } else if constexpr (std::is_invocable_v<decltype(group), const Snapshot&>) {
                    return group(request.first);
                } else if constexpr (std::is_invocable_v<decltype(group), const Snapshot&,
                                                         const SharedFindings&>) {
                    return group(request.first, request.findings);
                } else if constexpr (std::is_invocable_v<decltype(group), const GroupRequest&>) {
                    return group(request);
                } else {
                    return group(request.first, request.taken);
                }
            },
            landforms};
}

/// Channels by the area that drains through them, where they are asked for.
MeasureGroup chosen_network_group(const GroupRequest& request) {
    const bool of_land =
        request.landform == Landform::water || request.first.landform == Landform::terrain;
    if (!of_land || !(request.choice.channel_area > 0.0)) {
        return {{},
                [](const Snapshot&, const std::vector<bool>&) { return std::vector<double>{}; }};
    }
    return network_group(request.first, request.choice.channel_area);
}

/// Every group, in the order of its columns. A new group is a line here.
constexpr std::array suite_groups{
    entry<statistics_group>("statistics", everywhere),
    entry<wave_group>("waves", on_beds_and_profiles),
    entry<celerity_group>("migration", on_beds_and_profiles),
    entry<slope_group>("slopes", on_beds_and_profiles),
    entry<slip_face_group>("slip_faces", on_beds_and_profiles),
    entry<crest_group>("crests", on_beds),
    entry<dune_group>("dunes", on_beds),
    entry<isolated_dune_group>("lone_dunes", on_beds),
    entry<crest_direction_group>("crest_directions", on_beds),
    entry<drift_group>("drift", on_beds_and_profiles),
    entry<pile_group>("pile", on_piles),
    entry<avalanche_group>("avalanche_sizes", on_piles),
    entry<channel_group>("channels", on_water),
    entry<water_relief_group>("relief", on_water),
    entry<water_flow_group>("flow", on_water),
    entry<chosen_network_group>("network", on_beds | on_water),
    entry<stress_group>("stress", of_air),
    entry<air_group>("air", of_air),
    entry<flight_group>("flights", of_air),
    entry<number_group>("numbers", on_beds_and_profiles | on_water | of_air),
};

}  // namespace

MeasureSuite::MeasureSuite(Landform landform, const Snapshot& first, const MeasureChoice& choice)
    : parts_(std::make_unique<Parts>()) {
    const auto is_chosen = [&](std::string_view name) {
        return std::ranges::find(choice.columns, name) != choice.columns.end();
    };
    std::vector<MeasureColumn> all;
    for (const SuiteGroup& group : suite_groups) {
        if ((group.landforms & bit(landform)) == 0) continue;
        Parts::Part part{
            group.name, group.make({landform, first, all, choice, parts_->findings}), {}};
        const bool whole = choice.columns.empty() || is_chosen(group.name);
        for (const MeasureColumn& column : part.group.columns) {
            part.wanted.push_back(whole || is_chosen(column.name));
            if (!part.wanted.back()) continue;
            part.any_wanted = true;
            parts_->measured.push_back(column);
        }
        all.insert(all.end(), part.group.columns.begin(), part.group.columns.end());
        parts_->parts.push_back(std::move(part));
    }
    parts_->in_metres = choice.in_metres;
    parts_->columns = parts_->measured;
    if (!choice.in_metres) return;
    for (MeasureColumn& column : parts_->columns)
        column = in_world_units({column, 0.0}, first.scale).column;
}

MeasureSuite::~MeasureSuite() = default;

const std::vector<MeasureColumn>& MeasureSuite::columns() const {
    return parts_->columns;
}

std::vector<std::string> MeasureSuite::names() const {
    std::vector<std::string> names;
    for (const Parts::Part& part : parts_->parts) {
        if (!part.group.columns.empty()) names.emplace_back(part.name);
    }
    for (const Parts::Part& part : parts_->parts) {
        for (const MeasureColumn& column : part.group.columns) names.push_back(column.name);
    }
    return names;
}

void MeasureSuite::note(std::span<const Avalanche> avalanches) {
    for (const Parts::Part& part : parts_->parts) {
        if (part.group.note) part.group.note(avalanches);
    }
}

void MeasureSuite::serialise(StateArchive& archive) {
    for (const Parts::Part& part : parts_->parts) {
        if (part.group.serialise) part.group.serialise(archive);
    }
}

int MeasureSuite::most_threads() const {
    const auto groups = std::ranges::count_if(parts_->parts, &Parts::Part::any_wanted);
    return std::max(1, static_cast<int>(groups));
}

std::vector<double> MeasureSuite::row(const Snapshot& snapshot, WorkerPool* pool) {
    constexpr std::size_t least_cells = 4096;  // that are worth waking threads for
    const std::vector<Parts::Part>& parts = parts_->parts;
    parts_->findings->begin(snapshot);
    std::vector<std::vector<double>> of_parts(parts.size());
    std::atomic<std::size_t> left = parts.size();  // the last groups are the longest
    const auto measure = [&](int /*begin*/, int /*end*/) {
        for (std::size_t n = left--; n > 0 && n <= parts.size(); n = left--) {
            const Parts::Part& part = parts[n - 1];
            if (part.any_wanted) of_parts[n - 1] = part.group.values(snapshot, part.wanted);
        }
    };
    if (pool != nullptr && pool->size() > 1 && snapshot.bed.size() >= least_cells) {
        pool->for_ranges(pool->size(), measure);
    } else {
        measure(0, 1);
    }
    std::vector<double> values;
    values.reserve(parts_->columns.size());
    for (std::size_t n = 0; n < parts.size(); ++n) {
        for (std::size_t k = 0; k < of_parts[n].size(); ++k) {
            if (parts[n].wanted[k]) values.push_back(of_parts[n][k]);
        }
    }
    if (!parts_->in_metres) return values;
    for (std::size_t k = 0; k < values.size(); ++k)
        values[k] = in_world_units({parts_->measured[k], values[k]}, snapshot.scale).value;
    return values;
}

}  // namespace fumon
