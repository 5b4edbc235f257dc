#!/usr/bin/env bash
# The pages of `fumon verify` and `fumon gallery` before judges: the Nu Html Checker, and axe in Chromium at three widths in light
# and dark, where nothing may be wider than the page. FUMON_VNU_JAR names vnu.jar (else vnu on the path is taken), FUMON_AXE a
# folder whose node_modules holds axe-core and puppeteer-core. Without any it says so and ends with status 77, which CTest counts
# as skipped.
#
#     tests/reach/pages.sh build/release/fumon
set -euo pipefail
FUMON=$(realpath "$1")
HERE=$(dirname "$(realpath "$0")")
vnu=()
if [ -f "${FUMON_VNU_JAR:-}" ] && command -v java > /dev/null; then vnu=(java -jar "$FUMON_VNU_JAR")
elif command -v vnu > /dev/null; then vnu=(vnu); fi
browser=$(command -v chromium || command -v google-chrome || true)
axe=""
[ -d "${FUMON_AXE:-}/node_modules/axe-core" ] && [ -n "$browser" ] && command -v node > /dev/null && axe="$FUMON_AXE"
[ ${#vnu[@]} -gt 0 ] || [ -n "$axe" ] ||
    { echo "skipped: neither vnu (FUMON_VNU_JAR) nor axe (FUMON_AXE, chromium, node) is there"; exit 77; }
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place"

small=(--set grid.nx=48 --set grid.ny=32 --set image.width=160 --set image.height=90 --set run.steps=40)
"$FUMON" run terada-ripples -o out/run -q "${small[@]}"
"$FUMON" still terada-ripples --step 20 -o out/still.png "${small[@]}"
printf '[grid]\nnx = 48\nny = 32\n[figure]\ndots_per_inch = 60\n[[figure.panel]]\nkind = "map"\n' > figure.toml
"$FUMON" figure figure.toml -o out/figures -q
"$FUMON" gallery out -o gallery
cases() { printf 'scene = "figure.toml"\n%s[cases]\nkept = {picture = true}\nthumbnail = {}\n%s' "$1" "$2" > cases.toml; }
cases "" ""
"$FUMON" verify cases.toml --update --pinned -q > /dev/null
cases $'settings = ["sun.azimuth=320"]\n' $'new = {}\nbroken = {step = 999}\n'
"$FUMON" verify cases.toml -o verify -q > /dev/null && { echo "a picture should differ"; exit 1; }
[ -f verify/index.html ]

if [ ${#vnu[@]} -gt 0 ]; then
    "${vnu[@]}" --also-check-css gallery/index.html gallery/gallery.css verify/index.html
    echo "vnu: no finding"
fi
if [ -n "$axe" ]; then
    NODE_PATH="$axe/node_modules" node "$HERE/pages.js" "$browser" gallery/index.html gallery/index.html#run \
        gallery/index.html#figure gallery/index.html#still verify/index.html
fi
