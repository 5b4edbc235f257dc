#include "measure/measured_rows.h"

#include <algorithm>
#include <cstddef>

#include "base/find_named.h"
#include "base/state_archive.h"

namespace fumon {

const MeasuredColumn* MeasuredRows::find(std::string_view name) const {
    const auto name_of = [](const MeasuredColumn& one) -> const std::string& {
        return one.column.name;
    };
    return find_by(columns, name_of, name);
}

RowGatherer::RowGatherer(const std::vector<std::string>& names,
                         const std::vector<MeasureColumn>& suite, const Snapshot& first) {
    const std::vector<MeasureColumn> all = measured_columns(suite, first);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (std::find(names.begin(), names.end(), all[i].name) == names.end()) continue;
        rows_.columns.push_back({all[i], {}});
        places_.push_back(i == 0 ? step_column : i == 1 ? time_column : static_cast<int>(i) - 2);
        factors_.push_back(i < 2 ? 1.0 : in_world_units({suite[i - 2], 1.0}, first.scale).value);
    }
}

void RowGatherer::take(const Snapshot& snapshot, const std::vector<double>& row) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        MeasuredValues& values = rows_.columns[i].values;
        if (places_[i] == step_column) {
            values.push_back(static_cast<double>(snapshot.step));
        } else if (places_[i] == time_column) {
            values.push_back(snapshot.time);
        } else {
            values.push_back(factors_[i] * row[static_cast<std::size_t>(places_[i])]);
        }
    }
}

void RowGatherer::serialise(StateArchive& archive) {
    for (MeasuredColumn& one : rows_.columns) {
        std::vector<double> values = one.values.copied();
        archive.list("plotted " + one.column.name, values);
        one.values = MeasuredValues(values);
    }
}

std::vector<MeasureColumn> measured_columns(const std::vector<MeasureColumn>& suite,
                                            const Snapshot& first) {
    std::vector<MeasureColumn> columns{{"step", "", "of the model"},
                                       {"time", first.time_unit, "of the model"}};
    for (const MeasureColumn& column : suite)
        columns.push_back(in_world_units({column, 0.0}, first.scale).column);
    return columns;
}

}  // namespace fumon
