#!/usr/bin/env bash
# tests/bench/run.sh [TARGET]: builds the benchmarks, runs every row that has a plain loop beside it, and prints a table: fumon on
# all processors, the plain loop on one, their ratio. TARGET (plain, sse4, avx2, avx512, neon; default: the best that the
# processor has) is what fumon's loops for vectors take; the plain loops are compiled for a processor that has no more. BUILD
# (build/bench) is where it builds, FILTER (a regular expression) which benchmarks it runs.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${BUILD:-build/bench}
filter=${FILTER:-.}
target=${1:-}
flags="-march=native"
case $target in
    avx2) flags+=";-mno-avx512f" ;;
    sse4) flags="-march=x86-64-v2" ;;
    plain) flags="-march=x86-64" ;;
    '' | avx512 | neon) ;;
    *)
        echo "tests/bench/run.sh: there is no target $target; there are plain, sse4, avx2, avx512 and neon" >&2
        exit 2
        ;;
esac
[ -z "$target" ] || export FUMON_VECTOR_TARGET=$target

benches=(sand_bench gully_bench finite_volume_bench airflow_bench verify_bench)
cmake --preset release -B "$build" -DFUMON_BENCHMARKS=ON "-DFUMON_PLAIN_FLAGS=$flags" > /dev/null
cmake --build "$build" --target "${benches[@]}" > /dev/null

taken=$("$build/tests/bench/sand_bench" --benchmark_list_tests | sed -n 's/^vector target: //p')
processor=$(sed -n 's/^model name\s*: //p' /proc/cpuinfo | head -n 1)
printf '%s, %d processors; vectors: %s; plain loops: g++ -O3 %s\n\n' "${processor:-$(uname -m)}" "$(nproc)" \
    "$taken" "${flags//;/ }"
printf '| row | fumon | plain | ratio |\n|---|---|---|---|\n'
for bench in "${benches[@]}"; do
    "$build/tests/bench/$bench" --benchmark_filter="$filter" --benchmark_format=json 2> /dev/null | python3 -c '
import json, sys
text = sys.stdin.read()
for row in json.loads(text[text.index("{"):])["benchmarks"] if "{" in text else []:
    name = row["name"].removesuffix("/manual_time")
    rate = row.get("million_cell_steps_per_second", row.get("million_node_steps_per_second", row.get("million_pixels_per_second")))
    for key in sorted(row):
        if key.startswith("ratio_to_"):
            loop = key.removeprefix("ratio_to_")
            label = name if loop == "plain" else name + ", " + loop.replace("_", " ")
            print("| %s | %.3g | %.3g | %.1f |" % (label, rate, row[loop], row[key]))
'
done
