#include "foreign/time_series.h"

#include <fmt/format.h>

#include <optional>

#include "base/error.h"
#include "files/netcdf/netcdf_calls.h"
#include "files/netcdf/netcdf_input.h"
#include "foreign/netcdf_times.h"

namespace fumon {

std::vector<TimeSeries> time_series(const ForeignRun& run) {
    std::vector<TimeSeries> all;
    if (run.files.size() != 1) return all;
    const NetcdfLock lock;
    try {
        const NetcdfInput input(run.files.front());
        for (int variable = 0; variable < input.variables(); ++variable) {
            const std::vector<int> over = input.dimensions(variable);
            if (over.size() != 1 || !input.is_numeric(variable)) continue;
            const bool is_along = input.dimension_length(over[0]) == run.times.times.size();
            const std::string name = input.variable_name(variable);
            const std::optional<int> times = time_variable(input, over[0]);
            const bool is_coordinate = name == input.dimension_name(over[0]) || times == variable ||
                                       is_time(input, variable);
            if (!is_along || is_coordinate || !times) continue;
            all.push_back({name, input.text(variable, "units").value_or(""),
                           values_along(input, variable, over[0])});
        }
    } catch (const NetcdfFault& fault) {
        throw InputError(fmt::format("{}: cannot be read as NetCDF: {}", run.name, fault.what()));
    }
    return all;
}

}  // namespace fumon
