#include "measure/number_group.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "base/snapshot_lookup.h"

namespace fumon {

MeasureGroup number_group(const Snapshot& first, std::span<const MeasureColumn> taken) {
    std::vector<MeasureColumn> columns;
    std::vector<std::string> names;
    for (const SnapshotNumber& number : first.numbers) {
        const bool is_taken = std::ranges::any_of(
            taken, [&](const MeasureColumn& column) { return column.name == number.name; });
        if (is_taken) continue;
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
