#!/usr/bin/env bash
# `fumon view` in headless Chromium, driven through its debugging pipe by node: the camera is moved, a key changed, time
# scrubbed, a still, scene and film saved, at desktop and phone width; a run is watched to its end; the grid of a sweep leads to
# its runs; a scene is computed with another model, and dropped terrain filmed by the keyboard alone. Without chromium or node it says so and ends with status
# 77, which CTest counts as skipped. FUMON_VIEW_SCREENSHOTS names a folder for screenshots.
#
#     tests/reach/view.sh build/release/fumon
set -euo pipefail
FUMON=$(realpath "$1")
HERE=$(dirname "$(realpath "$0")")
browser=$(command -v chromium || command -v google-chrome || true)
if [ -z "$browser" ] || ! command -v node > /dev/null; then
    echo "skipped: chromium or node is not installed"
    exit 77
fi
place=$(mktemp -d)
server=""
finish() {
    [ -z "$server" ] || kill -INT "$server" 2> /dev/null || true
    rm -rf "$place"
}
trap finish EXIT
cd "$place"
"$FUMON" run terada-barchans -o run -q --set grid.nx=64 --set grid.ny=48 --set run.steps=40 --set output.fields_every=10 \
    --set output.frames=false --set output.movie=false --set image.width=640 --set image.height=360
serve() {  # COMMAND…: starts it, and waits for its address
    rm -f address
    "$FUMON" "$@" > address &
    server=$!
    for _ in $(seq 300); do
        [ -s address ] && break
        sleep 0.1
    done
}
use() {  # WHAT, as view.js has it
    node "$HERE/view.js" "$browser" "$1" "$(head -1 address)" "${FUMON_VIEW_SCREENSHOTS:-}"
}
end() {
    kill -INT "$server"
    wait "$server"
    server=""
}
serve view run --save saved
use run

# What the page saved is what the commands make and take.
head -3 saved/scene.toml
"$FUMON" check saved/scene.toml
"$FUMON" check saved/film.toml --run run
mapfile -t settings < settings.txt
"$FUMON" still run --step 20 -o still.png -q "${settings[@]}"
cmp still.png saved/still.png
end

serve run terada-barchans -o watched -q --view --set grid.nx=256 --set grid.ny=256 --set run.steps=6000 --set frames.every=400 \
    --set image.width=640 --set image.height=360
use watch
wait "$server"
server=""
test -s watched/movie.mp4

"$FUMON" sweep terada-barchans -o swept -q --over model.creep_rate=0.1,0.2 --over model.amount=0.1,0.3 --set grid.nx=48 --set grid.ny=32 \
    --set run.steps=20 --set output.fields_every=10
sed -i 's/"steps"/"failed": true, "message": "the bed is not finite", "steps"/' swept/runs/0003.json
serve view swept
use sweep
end

serve sweep terada-barchans -o watched-sweep -q --view --over model.creep_rate=0.1,0.2,0.3 --set grid.nx=128 --set grid.ny=128 \
    --set run.steps=30000 --set output.fields_every=15000
use watch-sweep
wait "$server"
server=""

cp "$HERE/../../assets/terrain/west_bijou_gully.asc" dem.asc
serve view terada-barchans --save filmed --set grid.nx=64 --set grid.ny=48 --set run.steps=60 --set image.width=640 --set image.height=360
use scene
end
test "$(grep -c '^\[\[shot\]\]' filmed/film.toml)" = 3
"$FUMON" run dem.asc -o terrain -q --set output.fields_every=1
"$FUMON" check filmed/film.toml --run terrain
