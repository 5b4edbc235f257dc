#!/usr/bin/env bash
# The guide's page on notebooks from its own lines: what they install, an environment, the module, a kernel that knows fumon, the
# notebook opened, and the notebook run to a page with its pictures.
#
#     tests/reach/notebook.sh SOURCES BUILD
#     FUMON_BARE_SYSTEMS="bookworm trixie" tests/reach/notebook.sh SOURCES
#
# On this system, where its packages are installed already: all but the line that installs them, with the module of a build folder.
# With FUMON_BARE_SYSTEMS: every line on releases of Debian with nothing installed, see bare_systems; the module is compiled there
# (10 minutes to an hour), or taken from FUMON_BARE_BUILD, a build folder of that release. Ends with status 77, which CTest counts as skipped, where neither is to be had.
set -euo pipefail
sources=$(realpath "$1")
page=$sources/assets/guide/notebook.md

# The lines of all blocks of shell under "## Run it".
lines() { awk '/^## /{here = ($0 == "## Run it")} !here {next} /^```sh$/{inside = 1; next} /^```/{inside = 0} inside' "$page"; }

# The lines as a script that stops at the first that fails. The server is ended once it has said where it listens.
script() {
    echo "set -euo pipefail"
    while read -r line; do
        echo "echo '-- $line'"
        case $line in
            *" -m notebook "*)
                echo "$line --no-browser --allow-root > server.log 2>&1 & server=\$!"
                echo "for second in \$(seq 60); do grep -q 'http://' server.log && break; kill -0 \$server || break; sleep 1; done"
                echo "kill \$server; wait \$server || true; grep -q 'http://' server.log || { cat server.log; exit 1; }"
                ;;
            *) echo "$line" ;;
        esac
    done
}
[ "$(lines | wc -l)" -ge 6 ] || { echo "$page has no lines to run under \"## Run it\""; exit 1; }

# Whether a page has the picture that the notebook draws, and no error.
check() {
    grep -q 'data:image/png;base64' "$1" || { echo "$1 has no picture"; return 1; }
    ! grep -q 'Traceback\|ModuleNotFoundError' "$1" || { echo "$1 has an error"; return 1; }
}

if [ -z "${FUMON_BARE_SYSTEMS:-}" ]; then
    skip() { echo "skipped: $*"; exit 77; }
    /usr/bin/python3 -c "import nbconvert, ipykernel, matplotlib, notebook, venv, xarray" 2> /dev/null ||
        skip "not all of what \`sh .ci/install notebook\` installs is here"
    build=$(realpath "$2")
    compgen -G "$build/python/fumon/_core.*.so" > /dev/null || skip "$build has no Python module"
    home=$(mktemp -d)
    trap 'rm -rf "$home"' EXIT
    mkdir "$home/sources"
    git -C "$sources" ls-files -z -- CMakeLists.txt LICENSE src/python shaders assets scenes ':!scenes/pictures' |
        (cd "$sources" && xargs -0 cp --parents -t "$home/sources")
    lines | sed '/^sh .ci/d' | script > "$home/script"
    cd "$home/sources"
    env -u PYTHONPATH HOME="$home" FUMON_BUILD="$build" PATH="/usr/bin:$PATH" bash "$home/script" 2>&1
    check "$home/sources/phase-diagram.html"
    exit
fi

. "$(dirname "$0")/bare_systems"
failed=""
for release in $FUMON_BARE_SYSTEMS; do
    tree=$place/$release
    echo "== $release"
    [ -x "$tree/bin/sh" ] || make_system "$release" "$tree"
    rm -rf "$tree/fumon" "$tree/root/fumon"
    git clone -q "file://$sources" "$tree/fumon"
    lines | script > "$tree/script"
    given=()
    if [ -n "${FUMON_BARE_BUILD:-}" ]; then
        mkdir -p "$tree/build/python/fumon"
        cp "$FUMON_BARE_BUILD"/python/fumon/_core.*.so "$tree/build/python/fumon/"
        given=(env FUMON_BUILD=/build)
    fi
    if in_system "$tree" "${given[@]}" bash -c "cd /fumon && bash /script" > "$place/$release.notebook.log" 2>&1 && check "$tree/fumon/phase-diagram.html"; then
        echo "== $release: passed"
    else
        tail -n 40 "$place/$release.notebook.log"
        failed="$failed $release"
    fi
done
[ -z "$failed" ] || { echo "failed:$failed"; exit 1; }
