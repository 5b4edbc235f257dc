#!/usr/bin/env bash
# Pages of `fumon export RUN -o page.html` in headless Chromium, which draws WebGL by SwiftShader: opened from a file, driven by node,
# their heights compared with those of the run; without WebGL the poster stands and one line. Without chromium or node it says so and
# ends with status 77, which CTest counts as skipped. FUMON_PAGE_SCREENSHOTS names a folder for screenshots.
#
#     tests/reach/page.sh build/release/fumon
set -euo pipefail
FUMON=$(realpath "$1")
HERE=$(dirname "$(realpath "$0")")
browser=$(command -v chromium || command -v google-chrome || true)
if [ -z "$browser" ] || ! command -v node > /dev/null; then
    echo "skipped: chromium or node is not installed"
    exit 77
fi
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place"
"$FUMON" run terada-barchans -o run -q --set grid.nx=64 --set grid.ny=48 --set run.steps=40 --set output.fields_every=10 \
    --set output.frames=false --set output.movie=false --set 'title="</script><script>globalThis.harmed = 1</script>"'
"$FUMON" export run -o page.html
mkdir beds
for step in 0 10 20 30 40; do "$FUMON" export run -o beds/$step.asc -q --step $step; done
node "$HERE/page.js" "$browser" page.html beds "${FUMON_PAGE_SCREENSHOTS:-}"
node "$HERE/page_without.js" "$browser" page.html
