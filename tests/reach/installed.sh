#!/bin/bash
# What `cmake --install` leaves, in a folder of its own: the program runs from / with the data that was installed, and no link of
# the installed guide leads nowhere. The target "uninstall" takes all of it away again, and nothing else.
# installed.sh CMAKE BUILD_FOLDER
set -euo pipefail
cmake=$1 build=$2
root=$(mktemp -d)
for list in "$build"/install_manifest*.txt; do [ ! -e "$list" ] || cp -p "$list" "$root/"; done  # of what somebody installed
ended() {
    rm -f "$build"/install_manifest*.txt
    for list in "$root"/install_manifest*.txt; do [ ! -e "$list" ] || cp -p "$list" "$build/"; done
    rm -rf "$root"
}
trap ended EXIT
rm -f "$build"/install_manifest*.txt
DESTDIR=$root "$cmake" --install "$build" --prefix /opt/fumon > "$root/log" || { cat "$root/log"; exit 1; }
here=$root/opt/fumon
cd /
"$here/bin/fumon" scenes > "$root/scenes"
grep -q '^terada-barchans ' "$root/scenes"
"$here/bin/fumon" still terada-barchans --step 0 -o "$root/first.png" --quiet \
    --set grid.nx=32 --set grid.ny=32 --set image.width=64 --set image.height=64
[ "$(head -c 4 "$root/first.png" | tail -c 3)" = PNG ]
# Where the system has no units, those beside the program count, as in an archive.
terrain=$here/share/fumon/assets/terrain/west_bijou_gully.asc
in_feet() { UDUNITS2_XML_PATH=/nowhere.xml "$here/bin/fumon" measure "$terrain" --set bed.height_unit=ft > "$root/feet" 2>&1; }
if in_feet; then echo "units were read from nowhere"; exit 1; fi
grep -q 'UDUNITS2_XML_PATH' "$root/feet"
cp -r /usr/share/xml/udunits "$here/share/fumon/udunits"
in_feet || { cat "$root/feet"; exit 1; }
rm -r "$here/share/fumon/udunits"
for file in share/man/man1/fumon-run.1 share/bash-completion/completions/fumon share/metainfo/org.example.fumon.metainfo.xml \
    share/icons/hicolor/256x256/apps/fumon.png share/doc/fumon/assets/guide/CHANGELOG.md share/doc/fumon/assets/guide/CITATION.cff \
    share/fumon/assets/copyright share/doc/fumon/LICENSE; do
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

# The parts: a document that names program, files of others and libraries, each once.
parts=$here/share/doc/fumon/fumon.spdx.json
if [ -x /usr/bin/python3 ]; then
    /usr/bin/python3 - "$parts" << 'END' || broken=1
import json, sys
parts = json.load(open(sys.argv[1]))
names = [one["SPDXID"] for one in parts["packages"]]
assert parts["spdxVersion"] == "SPDX-2.3" and len(names) == len(set(names))
licences = {one["name"]: one["licenseDeclared"] for one in parts["packages"]}
assert licences["fumon"] == "MIT" and licences["assets/palettes/vik.txt"] == "MIT", licences
assert licences["assets/palettes/cividis.txt"] == "LicenseRef-Battelle" and licences["assets/fonts/dejavu-sans.txt"] == "Bitstream-Vera"
assert "libpng16.so.16" in licences or "libpng16.so" in str(licences)
assert {one["relatedSpdxElement"] for one in parts["relationships"]} == set(names)
END
fi

# The data that packages share, without the pictures of the scenes' page.
DESTDIR=$root/data "$cmake" --install "$build" --prefix /usr --component data > "$root/log" || { cat "$root/log"; exit 1; }
size=$(du -sk --apparent-size "$root/data" | cut -f1)
[ "$size" -le 10000 ] || { echo "the data take $size kB"; broken=1; }

# Taken away again, from under a folder and a prefix with blanks.
rm -f "$build"/install_manifest*.txt
export DESTDIR="$root/a folder; [with] signs"
"$cmake" --install "$build" --prefix "/opt/my programs" > "$root/log" || { cat "$root/log"; exit 1; }
[ -x "$DESTDIR/opt/my programs/bin/fumon" ]
echo mine > "$DESTDIR/opt/my programs/share/fumon/scenes/mine.toml"
"$cmake" --build "$build" --target uninstall > "$root/log" || { cat "$root/log"; exit 1; }
left=$(cd "$DESTDIR" && find . ! -type d; find . -type d -path '*/doc/fumon')
[ "$left" = "./opt/my programs/share/fumon/scenes/mine.toml" ] || { echo "uninstall left: $left"; broken=1; }
exit $broken
