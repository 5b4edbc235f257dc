#!/usr/bin/env bash
# `fumon view` in headless Chromium, driven through its debugging pipe by node: the camera is moved, a key changed, time
# scrubbed, a still, scene and film saved, at desktop and phone width. Without chromium or node it says so and ends with status
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
"$FUMON" view run --save saved > address &
server=$!
for _ in $(seq 100); do
    [ -s address ] && break
    sleep 0.1
done
node "$HERE/view.js" "$browser" "$(head -1 address)" "${FUMON_VIEW_SCREENSHOTS:-}"

# What the page saved is what the commands make and take.
head -3 saved/scene.toml
"$FUMON" check saved/scene.toml
"$FUMON" check saved/film.toml --run run
mapfile -t settings < settings.txt
"$FUMON" still run --step 20 -o still.png -q "${settings[@]}"
cmp still.png saved/still.png
kill -INT "$server"
wait "$server"
server=""
