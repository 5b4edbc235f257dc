// Tables of winds.

#include <cmath>

#include "fuzz_input.h"
#include "wind/crest_directions.h"
#include "wind/sand_flux.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    fuzz::taken([&] {
        const WindTable table = read_wind_table({"rose.csv", fuzz::as_text(data, size)});
        const auto fluxes =
            table.rose.empty() ? table.fluxes : saturated_fluxes(table.rose, SandAndAir{});
        const Drift drift = drift_of(fluxes);
        if (!std::isfinite(drift.potential) || drift.resultant > drift.potential * 1.000001)
            fuzz::broken_promise("winds move no more together than each by itself", "");
    });
    return 0;
}
