#!/usr/bin/env bash
# Models and measures on AArch64: compiled by Debian's cross compiler against the libraries of the machine's own release, which apt
# brings into a folder (100 MB; nothing of the machine changes), and run under qemu-user: the records of tests/run/state_hashes.txt, and
# the tests of base, vectors, numerics, wind, measures and models. It takes half an hour on two cores, so it runs where FUMON_ARM64
# names a folder for libraries and build, which are kept; it ends with status 77, which CTest counts as skipped, where it names none.
#
#     FUMON_ARM64=/var/tmp/arm64 tests/reach/arm64.sh .
#
# FUMON_ARM64_TESTS chooses tests as --gtest_filter does; by default all but one that limits memory, which the emulator does not.
set -euo pipefail
sources=$(realpath "$1")

skip() { echo "skipped: $*"; exit 77; }
[ -n "${FUMON_ARM64:-}" ] || skip "FUMON_ARM64 names no folder"
for tool in aarch64-linux-gnu-g++ qemu-aarch64 apt-get dpkg; do
    command -v "$tool" > /dev/null || skip "$tool is not installed (apt-get install g++-aarch64-linux-gnu qemu-user)"
done
place=$(realpath -m "$FUMON_ARM64")
export FUMON_ARM64_ROOT=$place/root

# Of the machine's sources, but with lists, cache and a state of their own, in which nothing is installed.
arm64_apt() {
    apt-get -q -o APT::Architecture=arm64 -o APT::Architectures::=arm64 -o APT::Sandbox::User="$(id -un)" -o Dir::State="$place/apt" \
        -o Dir::State::status=/dev/null -o Dir::Cache="$place/apt/cache" "$@"
}

# What packages' own scripts would do: one folder of libraries, links that hold inside the folder, the one HDF5 as "hdf5".
unpack() {
    mkdir -p "$FUMON_ARM64_ROOT"/usr/{bin,lib,sbin}
    local folder package link
    for folder in bin lib sbin; do ln -sfn usr/$folder "$FUMON_ARM64_ROOT/$folder"; done
    for package in "$place"/apt/cache/archives/*.deb; do
        dpkg-deb --fsys-tarfile "$package" | tar -x --keep-directory-symlink --no-same-owner -C "$FUMON_ARM64_ROOT"
    done
    find "$FUMON_ARM64_ROOT" -type l -lname '/*' | while read -r link; do
        ln -sfnr "$FUMON_ARM64_ROOT$(readlink "$link")" "$link"
    done
    ln -sf hdf5-serial.pc "$FUMON_ARM64_ROOT/usr/lib/aarch64-linux-gnu/pkgconfig/hdf5.pc"
}

if [ ! -e "$place/unpacked" ]; then
    echo "== libraries"
    mkdir -p "$place/apt/lists/partial" "$place/apt/cache/archives/partial"
    compiler=$(aarch64-linux-gnu-g++ -dumpversion)
    arm64_apt update > "$place/apt.log"
    arm64_apt install -y --download-only --no-install-recommends libc6-dev "libstdc++-${compiler%%.*}-dev" libfmt-dev libhwy-dev libssl-dev \
        libpng-dev libnetcdf-dev libhdf5-dev libudunits2-dev libtomlplusplus-dev nlohmann-json3-dev libeigen3-dev libglm-dev \
        libgtest-dev >> "$place/apt.log" ||
        { tail -n 20 "$place/apt.log"; exit 1; }
    unpack
    touch "$place/unpacked"
fi

echo "== build"
cmake -S "$sources" -B "$place/build" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$sources/tests/states/arm64.cmake" -DFUMON_PICTURES=OFF \
    -DFUMON_WARNINGS_AS_ERRORS=OFF -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 > "$place/configure.log" ||
    { tail -n 20 "$place/configure.log"; exit 1; }
cmake --build "$place/build" --target fumon_states fumon_numbers_tests fumon_models_tests

emulate() { qemu-aarch64 -L "$FUMON_ARM64_ROOT" "$@"; }
tests=$place/build/tests/states

failed=""
echo "== records of states"
emulate "$tests/fumon_states" "$sources/tests/run/state_hashes.txt" "$sources/assets/terrain/west_bijou_gully.asc" | tee "$place/states.txt" || true
differ=$(grep -c DIFFERS "$place/states.txt" || true)
only=$(grep DIFFERS "$place/states.txt" | grep -vc '^air-' || true)
# The air's are known to: Eigen multiplies by fused instructions there.
if [ "$only" != 0 ] || ! grep -q ' of .* met$' "$place/states.txt" || grep -vqE 'as recorded$|DIFFERS|of .* met$' "$place/states.txt"; then
    failed="records"
fi
echo "$differ differ, $only of them not the air's"

for group in numbers models; do
    echo "== tests of $group"
    emulate "$tests/fumon_${group}_tests" --gtest_brief=1 --gtest_filter="${FUMON_ARM64_TESTS:--WorkerPool.ThatCannotStartAllItsThreadsSaysSoAndEnds}" || failed="$failed $group"
done
[ -z "$failed" ] || { echo "FAILED: $failed"; exit 1; }
