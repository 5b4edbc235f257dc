#!/usr/bin/env bash
# Sweeps and frames under Open MPI's mpirun, with nothing else said: table, frames and movie are those of one program, also
# after a rank was killed and all are started again. Without mpirun it says so and ends with status 77, which CTest counts
# as skipped.
#
#     tests/reach/mpirun.sh build/release/fumon
set -euo pipefail
FUMON=$(realpath "$1")
command -v mpirun > /dev/null || { echo "skipped: mpirun is not installed (openmpi-bin)"; exit 77; }
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place"
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_btl=self,vader OMPI_MCA_plm_rsh_agent=false
ranks() { mpirun --allow-run-as-root -n "$1" --bind-to none "${@:2}"; }
sum() { sha256sum < "$1"; }
same() { [ "$(sum "$1")" = "$(sum "$2")" ] || { echo "$1 differs from $2"; exit 1; }; }

sweep=(sweep terada-ripples --seeds 5 --set run.steps=40 -o)
"$FUMON" "${sweep[@]}" one -q
for n in 1 2 3 7; do
    ranks $n "$FUMON" "${sweep[@]}" "ranks$n" 2> told || { cat told; exit 1; }
    same one/sweep.csv "ranks$n/sweep.csv"
done
grep -q '^mpirun has started 7 programs: ' told || { cat told; exit 1; }
rm killed -rf; cp -r ranks3 killed; rm killed/sweep.csv killed/runs/0002.json  # a rank that was killed
ranks 3 "$FUMON" "${sweep[@]}" killed -q
same one/sweep.csv killed/sweep.csv

small=(--set grid.nx=48 --set grid.ny=32 --set image.width=160 --set image.height=90 --set run.steps=40
       --set frames.every=10 --set output.fields_every=10)
"$FUMON" run terada-ripples -o run -q "${small[@]}"
ranks 3 "$FUMON" render run -o frames -q
same run/movie.mp4 frames/movie.mp4
for frame in run/frames/*.png; do same "$frame" "frames/frames/${frame##*/}"; done
echo "table, frames and movie are the same for all numbers of ranks"
