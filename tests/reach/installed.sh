#!/bin/bash
# What `cmake --install` leaves, in a folder of its own: the program runs from / with the data that was installed, and no link of
# the installed guide leads nowhere. installed.sh CMAKE BUILD_FOLDER
set -euo pipefail
cmake=$1 build=$2
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
DESTDIR=$root "$cmake" --install "$build" --prefix /opt/fumon > "$root/log" || { cat "$root/log"; exit 1; }
here=$root/opt/fumon
cd /
"$here/bin/fumon" scenes > "$root/scenes"
grep -q '^terada-barchans ' "$root/scenes"
"$here/bin/fumon" still terada-barchans --step 0 -o "$root/first.png" --quiet \
    --set grid.nx=32 --set grid.ny=32 --set image.width=64 --set image.height=64
[ "$(head -c 4 "$root/first.png" | tail -c 3)" = PNG ]
for file in share/man/man1/fumon-run.1 share/bash-completion/completions/fumon share/metainfo/org.example.fumon.metainfo.xml \
    share/icons/hicolor/256x256/apps/fumon.png share/doc/fumon/assets/guide/CHANGELOG.md share/doc/fumon/assets/guide/CITATION.cff; do
    [ -s "$here/$file" ] || { echo "$file is not installed"; exit 1; }
done
[ ! -e "$here/share/fumon/assets/guide" ]
if grep -q '@' "$here"/share/metainfo/*.xml; then echo "the AppStream metadata are not filled in"; exit 1; fi
for packages in "$here"/lib/python3*/dist-packages; do  # none where the Python module is not built
    [ ! -d "$packages" ] || PYTHONPATH=$packages /usr/bin/python3 -B -c '
import importlib.metadata, fumon
assert importlib.metadata.version("fumon") == fumon.__version__
assert "fumon.pytest_plugin" in [entry.value for entry in importlib.metadata.entry_points(group="pytest11")]
fumon.Scene("terada-barchans")'
done
if grep -q 'For developers' "$here/share/doc/fumon/README.md"; then echo "the installed README speaks of the source folder"; exit 1; fi
tail -n 3 "$here/share/doc/fumon/README.md" | grep -q '^MIT licence'

broken=0
while IFS= read -r page; do
    while IFS= read -r link; do
        link=${link%%#*}
        [ -z "$link" ] || [ -e "$(dirname "$page")/$link" ] || { echo "${page#"$here"/}: $link is not installed"; broken=1; }
    done < <(grep -oE '\]\([^)[:space:]]+\)' "$page" | sed -E 's/^\]\((.*)\)$/\1/' | grep -v '://' || true)
done < <(find "$here/share/doc/fumon" -name '*.md')
exit $broken
