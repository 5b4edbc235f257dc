#!/usr/bin/env bash
# The README's two commands on systems on which nothing is installed. debootstrap makes each in a folder, as small as it comes
# (minbase), and the commands run there on a copy of the committed sources. It takes an hour a system and 5 GB, so it runs where
# FUMON_BARE_SYSTEMS names systems; it ends with status 77, which CTest counts as skipped, where that names none.
#
#     FUMON_BARE_SYSTEMS="trixie bookworm/user trixie/egl" tests/reach/bare_system.sh .
#
# A system is a release of Debian. /user: the commands are a user's, with sudo. /egl: there is no OSMesa, EGL draws.
set -euo pipefail
sources=$(realpath "$1")
. "$(dirname "$0")/bare_systems"

# The first block of code after a mark in the README.
command_after() {
    awk -v mark="$1" 'index($0, mark) {found = 1; next} found && /^```/ {if (inside) exit; inside = 1; next} inside' "$sources/README.md"
}

failed=""
for system in $FUMON_BARE_SYSTEMS; do
    release=${system%%/*} how=${system#"$release"}
    tree=$place/${system//\//-}
    echo "== $system: debootstrap"
    make_system "$release" "$tree"
    git clone -q "file://$sources" "$tree/fumon"
    case $how in
        *egl*) printf 'Package: libosmesa6\nPin: release *\nPin-Priority: -1\n' > "$tree/etc/apt/preferences.d/no-osmesa" ;;
    esac
    as_user=()
    case $how in
        *user*)
            in_system "$tree" sh -c 'apt-get update -q && apt-get install -q -y --no-install-recommends sudo adduser &&
                adduser --disabled-password --gecos "" someone && echo "someone ALL=(ALL) NOPASSWD: ALL" > /etc/sudoers.d/someone &&
                chown -R someone: /fumon' > "$place/user.log"
            as_user=(sudo -u someone -H)
            ;;
    esac
    for mark in "following command" "test command -->"; do
        line=$(command_after "$mark")
        [ -n "$line" ] || { echo "README.md has no command after \"$mark\""; exit 1; }
        echo "== $system: $line"
        began=$SECONDS
        if in_system "$tree" "${as_user[@]}" bash -euo pipefail -c "cd /fumon && $line" > "$tree/log" 2>&1; then
            echo "== $system: passed in $((SECONDS - began)) s"
        else
            tail -n 60 "$tree/log"
            echo "== $system: failed after $((SECONDS - began)) s"
            failed="$failed $system"
        fi
    done
    [ -s "$tree/fumon/out/showpiece/movie.mp4" ] || failed="$failed $system"
    if [ -n "$(git -c safe.directory='*' -C "$tree/fumon" status --porcelain)" ]; then echo "== $system: files stand in the source folder"; failed="$failed $system"; fi
done
[ -z "$failed" ] || { echo "failed:$failed"; exit 1; }
