#!/usr/bin/env bash
# tests/fuzz/run.sh SECONDS [TARGET…]: runs the fuzz targets (all, or those named), each for so many seconds, two at a
# time, and prints a line each. Stops at the first crash, leak, hang or use of too much memory, and says where the
# input lies that did it. BUILD (build/fuzz) holds the targets, FOUND (BUILD/found) keeps what new they find, so that
# the next run goes on from there.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:?"usage: tests/fuzz/run.sh SECONDS [TARGET…]"}
shift
build=$(realpath "${BUILD:-build/fuzz}")
found=${FOUND:-$build/found}
at_once=2
slowest=10        # seconds of one input
most_memory=1024  # MB in all
most_at_once=512  # MB of one allocation
longest=16384     # bytes of an input

targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
    for folder in tests/fuzz/corpus/*/; do targets+=("$(basename "$folder")"); done
fi
export LSAN_OPTIONS="suppressions=$PWD/tests/sanitizers/leaks.txt:print_suppressions=0"  # NetCDF keeps some of damaged files
mkdir -p "$found"

# The names of all keys, models and choices, for whatever reads scenes.
grep -rhoE '"[a-z][a-z0-9_.-]+"' src/scene src/models | sort -u > "$found/scene.dict"

fuzz() {
    local target=$1 log=$found/$1.log seeds=("tests/fuzz/corpus/$1") words=()
    mkdir -p "$found/$target"
    case $target in
        scene | settings | picture_text | sweep_axis) words=("-dict=$found/scene.dict") ;;
    esac
    if [ "$target" = scene ]; then
        mkdir -p "$found/scenes"
        cp scenes/*.toml "$found/scenes"
        seeds+=("$found/scenes")
    fi
    if ! "$build/tests/fuzz/fuzz_$target" "${words[@]}" -max_total_time="$seconds" -timeout=$slowest \
        -rss_limit_mb=$most_memory -malloc_limit_mb=$most_at_once -max_len=$longest -print_final_stats=1 \
        -artifact_prefix="$found/$target-" "$found/$target" "${seeds[@]}" > "$log" 2>&1; then
        grep -vE '^#[0-9]+\s+(NEW|REDUCE|pulse|RELOAD)' "$log" | tail -n 60
        printf '%-16s FAILED; see %s\n' "$target" "$log"
        return 1
    fi
    printf '%-16s %9d executions, %6d a second, %5d edges reached, %4d MB\n' "$target" \
        "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")" \
        "$(sed -n 's/^stat::average_exec_per_sec: *//p' "$log")" \
        "$(grep -oE 'cov: [0-9]+' "$log" | tail -n 1 | cut -c 6-)" \
        "$(sed -n 's/^stat::peak_rss_mb: *//p' "$log")"
}
export -f fuzz
export seconds build found slowest most_memory most_at_once longest
printf '%s\n' "${targets[@]}" | xargs -P $at_once -I '{}' bash -c 'fuzz {} || exit 255'
