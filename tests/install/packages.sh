#!/bin/bash
# Installs the packages of gsim with apt in a root that has only a Debian, runs the installed programs, and removes them
# again. scripts/package-test.sh calls it there.
# Usage: tests/install/packages.sh FOLDER, which has the packages
set -uo pipefail

readonly packages=$1
here=$(realpath "$(dirname "$0")")
readonly here
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
failed=0

quietly() {
    local log
    log=$(mktemp)
    if "$@" >"$log" 2>&1; then
        echo "ok $*"
    else
        cat "$log"
        echo "FAILED $*"
        failed=1
    fi
    rm -f "$log"
}

# The folder of the packages, and apt's lists and logs, are not part of the installation.
left_behind() {
    find / -xdev -path /proc -prune -o -path /var/lib/apt -prune -o -path /var/cache -prune -o -path /var/log -prune -o \
        -path "$here" -prune -o -path "$packages" -prune -o -name '*gsim*' ! -name '*trigsimp*' -print
}

cd / || exit
[[ -z $(left_behind) ]] || echo 'FAILED: this root has a gsim already'
quietly apt-get -q -y --no-install-recommends install "$packages"/gsim_*.deb
"$here/check.sh" /usr || failed=1
mapfile -t others < <(ls "$packages"/gsim-*.deb "$packages"/libgsim0_*.deb "$packages"/python3-gsim_*.deb)
quietly apt-get -q -y --no-install-recommends install "${others[@]}"
"$here/check.sh" /usr || failed=1
# The tools of users of the library, and the packages that its static form needs.
quietly apt-get -q -y --no-install-recommends install g++ cmake make pkgconf python3-matplotlib libfmt-dev liblua5.4-dev libpugixml-dev
"$here/engine.sh" /usr || failed=1
quietly apt-get -q -y purge 'gsim*' libgsim0 python3-gsim
left=$(left_behind)
if [[ -z $left ]]; then
    echo 'ok nothing is left after purging'
else
    echo "FAILED left after purging: $left"
    failed=1
fi
exit "$failed"
