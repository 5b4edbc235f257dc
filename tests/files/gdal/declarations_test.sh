#!/bin/sh
# Compares fumon's declarations of GDAL's C interface with the headers of libgdal-dev, which are unpacked from its package
# and not installed. declarations_test.sh COMPILER SOURCE_FOLDER. Exit status 77: the package is not to be had.
set -eu
compiler=$1
source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
headers=/usr/include/gdal
if [ ! -e $headers/gdal.h ]; then
    (cd "$folder" && apt-get download -qq libgdal-dev > /dev/null 2>&1) || { echo "libgdal-dev is not to be had"; exit 77; }
    dpkg-deb -x "$folder"/libgdal-dev*.deb "$folder/unpacked"
    headers=$folder/unpacked/usr/include/gdal
fi
"$compiler" -std=c++20 -fsyntax-only -isystem "$headers" -I"$source/src" "$source/tests/files/gdal/declarations.cpp"
# The check can fail: another type of one function is an error.
sed 's/int GDALGetRasterCount/double GDALGetRasterCount/' "$source/src/files/gdal/gdal_declarations.h" > "$folder/wrong.h"
sed 's#files/gdal/gdal_declarations.h#wrong.h#' "$source/tests/files/gdal/declarations.cpp" > "$folder/wrong.cpp"
if "$compiler" -std=c++20 -fsyntax-only -isystem "$headers" -I"$folder" -I"$source/src" "$folder/wrong.cpp" 2> /dev/null; then
    echo "a wrong declaration was not found" >&2
    exit 1
fi
