#!/usr/bin/env bash
# The archive for any Linux (.ci/archive) on systems with nothing but Mesa: it is unpacked in a folder with a blank in its name, and
# draws a picture with letters, makes a movie and a figure's page, reads units, and, where GDAL is installed, a GeoTIFF. It runs
# where FUMON_BARE_SYSTEMS names releases of Debian and FUMON_ARCHIVE an archive that .ci/archive made; else it ends with status
# 77, which CTest counts as skipped.
#
#     FUMON_ARCHIVE=build/package/out/fumon-0.3.0-x86_64.tar.xz FUMON_BARE_SYSTEMS="bookworm trixie/gdal" tests/reach/archive.sh
#
# Systems that lie in FUMON_BARE_FOLDER are used; bare_systems says more.
set -euo pipefail
. "$(dirname "$0")/bare_systems"
[ -n "${FUMON_ARCHIVE:-}" ] || skip "FUMON_ARCHIVE names no archive"
archive=$(realpath "$FUMON_ARCHIVE")

failed="" first=""
for system in $FUMON_BARE_SYSTEMS; do
    release=${system%%/*}
    tree=$place/$release
    if [ ! -x "$tree/bin/sh" ]; then
        make_system "$release" "$tree"
    fi
    packages="libosmesa6"
    case $system in */gdal) packages="$packages ^libgdal3[0-9]$" ;; esac
    # shellcheck disable=SC2086
    in_system "$tree" sh -c "export DEBIAN_FRONTEND=noninteractive; apt-get update -q && apt-get install -q -y --no-install-recommends $packages" > "$place/apt.log" 2>&1 ||
        { tail "$place/apt.log"; exit 1; }
    folder="$tree/opt/any place"
    rm -rf "$folder"
    mkdir -p "$folder"
    tar -C "$folder" -xf "$archive"
    mv "$folder"/fumon-* "$folder/moved"
    # shellcheck disable=SC2016
    if in_system "$tree" bash -euo pipefail -c '
        cd "/opt/any place" && PATH="$PWD/moved/bin:$PATH"
        small="--quiet --set grid.nx=48 --set grid.ny=32 --set image.width=160 --set image.height=120"
        fumon --version
        fumon still terada-barchans --step 20 -o still.png --pinned $small --set overlay.0.kind=title --set overlay.0.text=fumon
        fumon run terada-barchans -o run $small --set run.steps=20 --set output.movie=true --set frames.every=5
        [ -s run/movie.mp4 ]
        moved="moved/share/fumon/assets/terrain/west_bijou_gully.asc"
        fumon measure "$moved" --set bed.height_unit=ft > /dev/null
        fumon export "$moved" -o bed.nc --quiet
        fumon still bed.nc -o from-netcdf.png --quiet --set image.width=160 --set image.height=120
        [ "$1" != /gdal ] || { fumon export "$moved" -o bed.tif --quiet; fumon measure bed.tif > /dev/null; }
        sha256sum still.png
        ' bash "${system#"$release"}" > "$place/said" 2>&1; then
        cat "$place/said"
        pixels=$(sha256sum < "$folder/still.png")
        [ "${first:-$pixels}" = "$pixels" ] || echo "== $system: other pixels, as Mesa is another"
        first=${first:-$pixels}
        echo "== $system: passed"
    else
        cat "$place/said"
        failed="$failed $system"
    fi
done
[ -z "$failed" ] || { echo "failed:$failed"; exit 1; }
