#!/usr/bin/env bash
# tests/bench/run.sh MACHINE [TARGET]: builds the benchmarks, runs every row that has a plain loop beside it, and writes the rows into
# results/MACHINE.csv and README.md's tables: fumon on all processors, the plain loop on one, their ratio; what records cost
# goes into results/records/MACHINE.csv. TARGET (plain, sse4,
# avx2, avx512, neon; default: the best that the processor has) is what fumon's loops for vectors take; the plain loops are
# compiled for a processor that has no more. BUILD (build/bench) is where it builds, FILTER (a regular expression) which
# benchmarks it runs. Run it on a machine with nothing else to do.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${BUILD:-build/bench}
filter=${FILTER:-.}
machine=${1:?"usage: tests/bench/run.sh MACHINE [TARGET], as in tests/bench/run.sh epyc-zen5-2-processors avx2"}
target=${2:-}
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
cmake --build "$build" --target "${benches[@]}" records_bench > /dev/null

taken=$("$build/tests/bench/sand_bench" --benchmark_list_tests | sed -n 's/^vector target: //p')
processor=$(sed -n 's/^model name\s*: //p' /proc/cpuinfo | head -n 1)
rows=$(for bench in "${benches[@]}"; do
    "$build/tests/bench/$bench" --benchmark_filter="$filter" --benchmark_format=json 2> /dev/null | python3 -c '
import csv, json, sys
text = sys.stdin.read()
out = csv.writer(sys.stdout, lineterminator="\n")
units = {"million_cell_steps_per_second": "M cell-steps/s", "million_node_steps_per_second": "M node-steps/s", "million_pixels_per_second": "M pixels/s"}
for row in json.loads(text[text.index("{"):])["benchmarks"] if "{" in text else []:
    name = row["name"].removesuffix("/manual_time")
    for rate, unit in units.items():
        for key in sorted(row if rate in row else []):
            if key.startswith("ratio_to_"):
                loop = key.removeprefix("ratio_to_")
                label = name if loop == "plain" else name + ", " + loop.replace("_", " ")
                out.writerow([sys.argv[1], label, unit, "%.3g" % row[rate], "%.3g" % row[loop], "%.1f" % row[key]])
' "$taken"
done)
said="${processor:-$(uname -m)}, $(nproc) processors; plain loops: $(c++ --version | head -n 1) -O3 ${flags//;/ }; $(date -u +%F); $(git describe --always --dirty)"
printf '%s\n' "$rows" | python3 tests/bench/table.py --add "tests/bench/results/$machine.csv" "$taken" "$said"
python3 tests/bench/table.py
"$build/tests/bench/records_bench" --benchmark_filter="$filter" --benchmark_format=json 2> /dev/null |
    python3 tests/bench/records.py "tests/bench/results/records/$machine.csv" "$taken" "$said"
printf '%s\n' "$rows"
