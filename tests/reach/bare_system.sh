#!/usr/bin/env bash
# The README's two commands on systems on which nothing is installed. debootstrap makes each in a folder, as small as it comes
# (minbase), and the commands run there on a copy of the committed sources. It takes an hour a system and 5 GB, so it runs where
# FUMON_BARE_SYSTEMS names systems; it ends with status 77, which CTest counts as skipped, where that names none.
#
#     FUMON_BARE_SYSTEMS="trixie bookworm/user trixie/egl" tests/reach/bare_system.sh .
#
# A system is a release of Debian. /user: the commands are a user's, with sudo. /egl: there is no OSMesa, EGL draws.
# FUMON_BARE_MIRROR is where packages come from; FUMON_BARE_FOLDER is where the systems are made (a temporary folder, which goes).
set -euo pipefail
sources=$(realpath "$1")
mirror=${FUMON_BARE_MIRROR:-http://deb.debian.org/debian}

skip() { echo "skipped: $*"; exit 77; }
[ -n "${FUMON_BARE_SYSTEMS:-}" ] || skip "FUMON_BARE_SYSTEMS names no system"
[ "$(id -u)" -eq 0 ] || skip "only root makes systems in folders"
command -v debootstrap > /dev/null || skip "debootstrap is not installed"

place=${FUMON_BARE_FOLDER:-$(mktemp -d)}
[ -n "${FUMON_BARE_FOLDER:-}" ] || trap 'rm -rf "$place"' EXIT

# The first block of code after a mark in the README.
command_after() {
    awk -v mark="$1" 'index($0, mark) {found = 1; next} found && /^```/ {if (inside) exit; inside = 1; next} inside' "$sources/README.md"
}

# in_system TREE COMMAND...: with /proc and /dev, which go with the last process.
in_system() {
    local tree=$1
    shift
    unshare --mount --fork --pid --kill-child sh -c '
        tree=$1; shift
        mount --make-rprivate / && mount -t proc proc "$tree/proc" && mount --bind /dev "$tree/dev" && exec chroot "$tree" "$@"' \
        sh "$tree" env -i HOME=/root TERM=dumb PATH=/usr/sbin:/usr/bin:/sbin:/bin CI="${CI:-}" "$@"
}

failed=""
for system in $FUMON_BARE_SYSTEMS; do
    release=${system%%/*} how=${system#"$release"}
    tree=$place/${system//\//-}
    echo "== $system: debootstrap"
    debootstrap --variant=minbase "$release" "$tree" "$mirror" > "$place/debootstrap.log" || { cat "$place/debootstrap.log"; exit 1; }
    cp /etc/resolv.conf "$tree/etc/"
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
