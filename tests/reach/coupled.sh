#!/bin/bash
# The guide's example of coupling, built from another folder against the installed libfumonbmi: by find_package and by
# pkg-config. The library finds the scenes and palettes that lie beside it. coupled.sh CMAKE BUILD_FOLDER SOURCE_FOLDER
set -euo pipefail
cmake=$1 build=$2 source=$3
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
for component in bmi data; do
    "$cmake" --install "$build" --prefix "$root/first" --component $component > "$root/log" || { cat "$root/log"; exit 1; }
done
mv "$root/first" "$root/moved"
here=$root/moved
cp -r "$source/assets/guide/coupled" "$root/example"
unset FUMON_DATA_DIR LD_LIBRARY_PATH
# What is nowhere but here.
printf '[model]\nname = "sand"\n[grid]\nnx = 48\nny = 32\n[run]\nsteps = 6\n[look]\npalette = "only-here"\n' > "$here/share/fumon/scenes/only-here.toml"
cp "$here/share/fumon/assets/palettes/viridis.txt" "$here/share/fumon/assets/palettes/only-here.txt"
cd /

"$cmake" -S "$root/example" -B "$root/example/build" -G Ninja -DCMAKE_PREFIX_PATH="$here" > "$root/log" 2>&1 || { cat "$root/log"; exit 1; }
"$cmake" --build "$root/example/build" > "$root/log" 2>&1 || { cat "$root/log"; exit 1; }
[ "$("$root/example/build/coupled" only-here)" = "fumon sand: 1536 cells at time 5 1" ]
"$root/example/build/coupled" terada-ripplez 2> "$root/said" && { echo "an unknown scene was taken"; exit 1; }
grep -q 'did you mean "terada-ripples"' "$root/said"

library=$(find "$here" -name 'libfumonbmi.so')
if [ -n "$( (readelf -d "$library" && readelf -Ws "$library") | grep -iE 'libpython|pybind')" ]; then echo "libfumonbmi needs Python"; exit 1; fi

pc=$(find "$here" -name fumonbmi.pc)
flags=$(PKG_CONFIG_PATH=$(dirname "$pc") pkg-config --cflags --libs fumonbmi)
sed -e '/<fumon.bmi.h>/d' -e 's#<fumon/bmi_library.h>#<bmi.hxx>\nextern "C" bmi::Bmi* bmi_model_create();\nextern "C" void bmi_model_destroy(bmi::Bmi*);#' \
    "$root/example/coupled.cpp" > "$root/example/by_pc.cpp"
for file in coupled by_pc; do
    # shellcheck disable=SC2086
    c++ -std=c++17 "$root/example/$file.cpp" $flags -o "$root/$file"
    [ "$(LD_LIBRARY_PATH=$(dirname "$(dirname "$pc")") "$root/$file" only-here)" = "fumon sand: 1536 cells at time 5 1" ]
done
