# What the targets are made of where libFuzzer drives them.

add_custom_target(fumon_fuzzers)

# A third less to compile; all else goes without, so that what a file needs is what it includes.
foreach(room IN ITEMS base keys numerics models_water models_air files files_netcdf files_terrain scene)
    target_precompile_headers(fumon_${room} PRIVATE <algorithm> <cmath> <filesystem> <fmt/format.h> <functional> <map>
                              <memory> <optional> <span> <string> <vector>)
endforeach()

# Readers in rooms of which so little is needed that the whole of them would take minutes to compile.
set(parts run/run_checkpoint run/recorder run/written_outputs run/run_folder run/run_files run/frame_list run/picture_text
          outputs/output_claims outputs/own_file figure/canvas/figure_metadata figure/canvas/eps_metadata
          figure/canvas/pdf_metadata figure/canvas/pdf_strings figure/canvas/packed_text figure/words/words paper/figure_origin
          paper/store/figure_sources paper/figure_curve paper/curve_rows
          film/film_read film/film_texts film/timeline film/script/film_keys film/script/film_check film/script/film_sizes
          sweep/sweep_axis sweep/sweep_manifest sweep/sweep_table)
foreach(part IN LISTS parts)
    get_filename_component(room ${part} DIRECTORY)
    list(APPEND part_sources ${CMAKE_SOURCE_DIR}/src/${part}.cpp)
    set_source_files_properties(${CMAKE_SOURCE_DIR}/src/${part}.cpp PROPERTIES UNITY_GROUP ${room})
endforeach()
add_library(fumon_parts STATIC ${part_sources})
set_target_properties(fumon_parts PROPERTIES UNITY_BUILD_MODE GROUP)
target_link_libraries(fumon_parts PUBLIC fumon_scene fumon_measure fumon_picture fumon_picture_stills fumon_build_identity
                      PRIVATE nlohmann_json::nlohmann_json glm::glm PkgConfig::libdeflate PkgConfig::tomlplusplus)

