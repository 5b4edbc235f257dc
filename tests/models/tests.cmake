# The tests of the models and of the loops that they are made of.
fumon_tests(models fumon_scene FOLDERS vectors models models/sand models/pile models/water models/air models/avalanche models/sediment models/dunes)
target_link_libraries(fumon_models_tests PRIVATE fumon_examination fumon_measure fumon_vectors PkgConfig::highway Eigen3::Eigen)  # which solves equations another way
set(loops $<TARGET_FILE:fumon_models_sand> $<TARGET_FILE:fumon_models_water> $<TARGET_FILE:fumon_models_water_kernels> $<TARGET_FILE:fumon_models_sediment> $<TARGET_FILE:fumon_models_air>
          $<TARGET_FILE:fumon_models_shared> $<TARGET_FILE:fumon_numerics>)
if(TARGET fumon_render)
    list(APPEND loops $<TARGET_FILE:fumon_render_view> $<TARGET_FILE:fumon_render_edges> $<TARGET_FILE:fumon_render_light> $<TARGET_FILE:fumon_render_ground> $<TARGET_FILE:fumon_render_samples>)
    target_compile_definitions(fumon_models_tests PRIVATE FUMON_HAS_PICTURES)
    add_dependencies(fumon_models_tests fumon_render)
endif()
target_compile_definitions(fumon_models_tests PRIVATE FUMON_LIBRARIES_OF_LOOPS="$<JOIN:${loops}, >")
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/../vectors/functions_test.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
