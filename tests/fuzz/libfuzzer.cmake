# What the targets are made of where libFuzzer drives them.

add_custom_target(fumon_fuzzers)

# A third less to compile; all else goes without, so that what a file needs is what it includes.
foreach(room IN ITEMS base keys numerics models_water models_air files files_netcdf files_terrain scene)
    target_precompile_headers(fumon_${room} PRIVATE <algorithm> <cmath> <filesystem> <fmt/format.h> <functional> <map>
                              <memory> <optional> <span> <string> <vector>)
endforeach()
