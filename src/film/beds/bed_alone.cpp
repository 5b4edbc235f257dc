#include "film/beds/bed_alone.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "base/snapshot_lookup.h"
#include "render/colour/colouring.h"
#include "render/life/plant_layer.h"

namespace fumon {

namespace {

bool rock_wears(const Snapshot& snapshot) {
    return number_of(snapshot, "rock_worn").has_value();
}

}  // namespace

std::string_view missing_besides_beds(const Snapshot& first, const View& view) {
    if (first.section) return "their air";
    if (first.landform == Landform::water) return "their water";
    const Marking mark = view.look.mark;
    if (mark == Marking::last_avalanche) return "their avalanches";
    if (colours_field(view.look.colour_by)) return "that field";
    const bool marked_plants =
        mark == Marking::ground && find_named(first.fields, "cover") != nullptr;
    const bool flux_of_fields = find_named(first.fields, "moving_sand") != nullptr;
    if (view.streamers.strength > 0.0 && flux_of_fields) return "their moving sand";
    if (marked_plants || draws_plants(view, first)) return "their plants";
    return mark == Marking::ground && rock_wears(first) ? "their worn rock" : "";
}

void keep_fields_of_bed(Snapshot& snapshot) {
    std::vector<SnapshotField> kept_fields;
    const SnapshotField* rock = find_named(snapshot.fields, "rock");
    const SnapshotField* sand = find_named(snapshot.fields, "sand");
    if (rock != nullptr && sand != nullptr && !rock_wears(snapshot)) {
        kept_fields = {*sand, *rock};
        std::ranges::transform(snapshot.bed.values(), rock->values.values(),
                               kept_fields.front().values.values().begin(), std::minus<>());
    }
    snapshot.fields = std::move(kept_fields);
    snapshot.numbers.clear();
    snapshot.section.reset();
}

}  // namespace fumon
