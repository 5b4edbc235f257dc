#include "measure/number_group.h"

#include <limits>
#include <string>
#include <utility>

#include "base/find_named.h"
#include "base/snapshot_lookup.h"

namespace fumon {

MeasureGroup number_group(const Snapshot& first, std::span<const MeasureColumn> taken) {
    std::vector<MeasureColumn> columns;
    std::vector<std::string> names;
    for (const SnapshotNumber& number : first.numbers) {
        if (find_named(taken, number.name) != nullptr) continue;
        names.push_back(number.name);
        columns.push_back(
            {number.name, number.unit == "1" ? "" : number.unit, "as the model itself keeps it"});
    }
    return {
        std::move(columns), [names = std::move(names)](const Snapshot& snapshot) {
            std::vector<double> values;
            values.reserve(names.size());
            for (const std::string& name : names)
                values.push_back(
                    number_of(snapshot, name).value_or(std::numeric_limits<double>::quiet_NaN()));
            return values;
        }};
}

}  // namespace fumon
