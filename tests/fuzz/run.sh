#!/usr/bin/env bash
# tests/fuzz/run.sh SECONDS [TARGET…]: runs the fuzz targets (all, or those named), two at a time: first every input of the
# corpus, then new ones for so many seconds. Prints a line each. Stops at the first crash, leak, hang or use of too much
# memory, and says where the input lies that did it. BUILD (build/fuzz) holds the targets, FOUND (BUILD/found) keeps what
# new they find, so that the next run goes on from there; MINIMISE=1 puts what of it reaches more into the corpus.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:?"usage: tests/fuzz/run.sh SECONDS [TARGET…]"}
shift
build=$(realpath "${BUILD:-build/fuzz}")
found=${FOUND:-$build/found}
at_once=2
slowest=${SLOWEST:-10}  # seconds of one input, by the clock: a busy machine takes more
most_memory=1024  # MB in all
most_at_once=512  # MB of one allocation
longest=1048576   # bytes of an input
longest_kept=8192 # bytes of an input of the corpus
most_of_seed=20000
minimise=${MINIMISE:-0}
seed=${SEED:-}

targets=("$@")
[ ${#targets[@]} -gt 0 ] || mapfile -t targets < <(sed -n 's/^fumon_fuzzer(\([a-z0-9_]*\) .*/\1/p' tests/fuzz/CMakeLists.txt)
export LSAN_OPTIONS="suppressions=$PWD/tests/sanitizers/leaks.txt:print_suppressions=0"  # NetCDF keeps some of damaged files
mkdir -p "$found"

# The names of all keys, models and choices, for whatever reads scenes; those of its own files for whatever reads JSON.
{ grep -rhoE '"[a-z][a-z0-9_.-]+"' src/scene src/models src/film/script | sort -u; cat tests/fuzz/numbers.dict; } > "$found/scene.dict"
grep -rhoE '"[a-z][a-z0-9_]+"' src/run/run_files.cpp src/sweep/sweep_manifest.cpp src/files/snapshot_outline.cpp \
    src/paper/figure_origin.cpp | sort -u | sed 's/"\(.*\)"/"\\"\1\\":"/' | cat - tests/fuzz/numbers.dict > "$found/json.dict"

# The corpus of a target; what stands in scenes/ joins that of the targets of scenes, which share one.
seeds_of() {
    case $1 in
        scene | scene_*)
            mkdir -p "$found/scenes"
            cp scenes/*.toml "$found/scenes"
            echo "tests/fuzz/corpus/scene $found/scenes"
            ;;
        *) echo "tests/fuzz/corpus/$1" ;;
    esac
}

fuzz() {
    local target=$1 log=$found/$1.log seeds=() options=() most=()
    local program=$build/tests/fuzz/fuzz_$target kept=$found/$1
    read -ra seeds <<< "$(seeds_of "$target")"
    case $target in
        scene* | film | settings | picture_text | sweep_axis | figure_curve) options=("-dict=$found/scene.dict") ;;
        csv_table | wind_table | sweep_table | avalanche_table | esri_ascii | terrain_drawn | palette | baseline)
            options=(-dict=tests/fuzz/numbers.dict) ;;
        run_json | sweep_json | snapshot_outline | figure_metadata) options=("-dict=$found/json.dict") ;;
    esac
    options+=(-timeout=$slowest -rss_limit_mb=$most_memory -malloc_limit_mb=$most_at_once -max_len=$longest
              -print_funcs=0 -print_final_stats=1 "-artifact_prefix=$found/$target-")
    if [ -n "$seed" ]; then
        kept=$found/$target-of-seed
        rm -rf "$kept"
        find "${seeds[@]}" -type f | sort | paste -sd, > "$found/$target.inputs"
        most=("-runs=$most_of_seed")
        seeds=("-seed=$seed" -reload=0 "-seed_inputs=@$found/$target.inputs")
    fi
    mkdir -p "$kept"
    if ! "$program" "${options[@]}" -runs=0 "${seeds[@]}" > "$log" 2>&1 ||
        ! "$program" "${options[@]}" -max_total_time="$seconds" "${most[@]}" "${seeds[@]}" "$kept" >> "$log" 2>&1; then
        grep -vE '^#[0-9]+\s+(NEW|REDUCE|pulse|RELOAD)' "$log" | tail -n 60
        printf '%-16s FAILED; see %s\n' "$target" "$log"
        return 1
    fi
    if [ "$minimise" = 1 ] && [ -d "tests/fuzz/corpus/$target" ]; then
        "$program" "${options[@]}" -max_len=$longest_kept -merge=1 -use_counters=0 "tests/fuzz/corpus/$target" "$kept" >> "$log" 2>&1
    fi
    printf '%-16s %9d executions, %6d a second, %5d edges reached, %4d MB\n' "$target" \
        "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -n 1)" \
        "$(sed -n 's/^stat::average_exec_per_sec: *//p' "$log" | tail -n 1)" \
        "$(grep -oE 'cov: [0-9]+' "$log" | tail -n 1 | cut -c 6-)" \
        "$(sed -n 's/^stat::peak_rss_mb: *//p' "$log" | tail -n 1)"
}
export -f fuzz seeds_of
export seconds build found slowest most_memory most_at_once longest longest_kept minimise seed most_of_seed
printf '%s\n' "${targets[@]}" | xargs -P $at_once -I '{}' bash -c 'fuzz {} || exit 255'
