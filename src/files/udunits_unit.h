#pragma once

#include <string>
#include <string_view>

namespace fumon {

/// A unit of a field or a key as UDUNITS reads it, with powers as exponents ("kg/(m^2 s)" is
/// "kg m-2 s-1"; "per mm" is "mm-1"). "1" for none, for what fumon counts (sites, heights, steps,
/// shares of them), and for a power that is no whole number ("s/m^(1/3)" of Manning's n), which
/// UDUNITS cannot write. "m or sites" is "m" where the scene is in metres.
std::string udunits_unit(std::string_view unit, bool in_metres);

}  // namespace fumon
