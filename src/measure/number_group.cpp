#include "measure/number_group.h"

#include <string>
#include <utility>

#include "base/find_named.h"
#include "base/snapshot_lookup.h"

namespace fumon {

MeasureGroup number_group(const Snapshot& first, std::span<const MeasureColumn> taken) {
    using Found = const Snapshot*;
    std::vector<Measure<Found>> measures;
    for (const SnapshotNumber& number : first.numbers) {
        if (find_named(taken, number.name) != nullptr) continue;
        measures.push_back({number.name, number.unit == "1" ? "" : number.unit,
                            "kept by the model itself", [name = number.name](Found snapshot) {
                                return number_of(*snapshot, name).value_or(undefined);
                            }});
    }
    return group_of<Found>([](const Snapshot& snapshot) { return &snapshot; }, std::move(measures));
}

}  // namespace fumon
