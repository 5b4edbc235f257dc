#!/usr/bin/env bash
# tests/fuzz/coverage.sh [FOLDER]: how many of each reader's lines the corpus reaches (and, with a FOLDER of inputs of
# run.sh, build/fuzz/found, those too), as the table in README.md. Builds the targets once more, with Clang's coverage,
# into BUILD (build/fuzz-coverage). Functions that only write, or only open a file, are left out by the names below.
set -euo pipefail
cd "$(dirname "$0")/../.."
found=${1:-}
build=${BUILD:-build/fuzz-coverage}
writers='Writer|make_corpus|Checkpointer|CheckpointClock|planned_files|files_json|files_called|add_names|outline_json|scale_json|names_json'
writers+='|run_record_text|sweep_manifest.abi|axes_json|pdf_metadata|[ :]figure_metadata[[(]|[ :]picture_text[[(]|movie_text[[(]|resolved_scene|inputs_text'
writers+='|read_palette|baseline_text|[ :]esri_ascii.abi|open_checkpoint|AvalancheFile|read_avalanches|little_endian|view_of|picture_of|read_scene'
writers+='|read_netcdf_format|netcdf_format'

# The sources that each target is there for.
readers() {
    case $1 in
        scene) echo scene/read scene/faults keys/assign ;;
        settings) echo keys/override ;;
        scene_written) echo scene/write scene/schedule ;;
        sweep_axis) echo sweep/sweep_axis ;;
        toml_nesting) echo keys/toml_text ;;
        palette) echo render/colour/palette ;;
        esri_ascii) echo files/terrain/esri_ascii ;;
        netcdf_bed) echo files/terrain/netcdf_bed files/netcdf/netcdf_record files/netcdf/netcdf_input ;;
        png_heights) echo files/terrain/png_heights files/png_reader ;;
        avalanche_table) echo files/avalanche_table ;;
        csv_table) echo files/csv_table ;;
        figure_curve) echo paper/figure_curve ;;
        sweep_table) echo sweep/sweep_table ;;
        wind_table) echo wind/wind_rose ;;
        checkpoint) echo files/checkpoint run/run_checkpoint ;;
        run_json) echo run/run_files files/json_text ;;
        sweep_json) echo sweep/sweep_manifest ;;
        snapshot_outline) echo files/snapshot_outline ;;
        baseline) echo picture/baseline ;;
        picture_text) echo run/picture_text ;;
        figure_metadata) echo figure/canvas/figure_metadata paper/figure_origin ;;
        movie_texts) echo picture/movie_texts ;;
        own_file) echo outputs/own_file ;;
    esac
}

cmake --preset fuzz -B "$build" -DFUMON_SANITIZE=fuzzer-no-link -DCMAKE_CXX_FLAGS="-fprofile-instr-generate -fcoverage-mapping" \
    > /dev/null
cmake --build "$build" --target fumon_fuzzers > "$build/build.log"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/scenes"
cp scenes/*.toml "$scratch/scenes"

for target in $(sed -n 's/^fumon_fuzzer(\([a-z0-9_]*\) .*/\1/p' tests/fuzz/CMakeLists.txt); do
    seeds=("tests/fuzz/corpus/$target")
    case $target in scene | scene_*) seeds=(tests/fuzz/corpus/scene "$scratch/scenes") ;; esac
    if [ -n "$found" ] && [ -d "$found/$target" ]; then seeds+=("$found/$target"); fi
    LLVM_PROFILE_FILE=$scratch/$target.profraw "$build/tests/fuzz/fuzz_$target" -runs=0 -max_len=1048576 "${seeds[@]}" \
        > "$scratch/log" 2>&1
done
llvm-profdata-14 merge -sparse "$scratch"/*.profraw -o "$scratch/all.profdata"

# The readers of a program from the profile of all: settings reach what scenes do not.
printf '| reader | lines | reached |\n|---|---|---|\n'
for target in $(sed -n 's/^fumon_fuzzer(\([a-z0-9_]*\) .*/\1/p' tests/fuzz/CMakeLists.txt); do
    for reader in $(readers "$target"); do
        llvm-cov-14 report "$build/tests/fuzz/fuzz_$target" -instr-profile="$scratch/all.profdata" -show-functions \
            "$PWD/src/$reader.cpp" 2> "$scratch/warnings" | c++filt |
            awk -v name="$reader" -v writers="$writers" '
                /%/ && !/^TOTAL/ && $0 !~ writers { lines += $(NF - 5); missed += $(NF - 4) }
                END { printf "| %s.cpp | %d | %.0f %% |\n", name, lines, lines ? 100 * (lines - missed) / lines : 0 }'
    done
done
