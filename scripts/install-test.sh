#!/bin/bash
# In a fresh copy of the project: make run, make install into an empty folder, delete the copy with its build, and run the
# installed programs. Closes with "N passed, N failed".
# Usage: scripts/install-test.sh [COPY]; COPY is a copy that is already built (scripts/reproducible.sh COPY); it is deleted
set -uo pipefail

copy=${1:-}
[[ -z $copy ]] || copy=$(realpath "$copy")
cd "$(dirname "$0")/.." || exit
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
readonly scratch results=$scratch/results installed=$scratch/root/usr/local
touch "$results"

step() {
    local what=$1
    shift
    if "$@" >"$scratch/log" 2>&1; then
        echo "ok $what" | tee -a "$results"
    else
        cat "$scratch/log"
        echo "FAILED $what" | tee -a "$results"
    fi
}

if [[ -z $copy ]]; then
    copy=$scratch/copy
    scripts/fresh-copy.sh "$copy" || exit
elif [[ $copy -ef . ]]; then
    echo "install-test: this would delete the project itself; name a copy of it" >&2
    exit 2
fi

step 'make run' make -C "$copy" run
step 'make install' make -C "$copy" DESTDIR="$scratch/root" install
step 'make uninstall' make -C "$copy" DESTDIR="$scratch/root" uninstall
step 'nothing is left of it' test -z "$(find "$scratch/root" -type f -o -type l -o -name gsim)"
step 'make install again' make -C "$copy" DESTDIR="$scratch/root" install
rm -rf "$copy"
tests/install/check.sh "$installed" 2>&1 | tee -a "$results"

passed=$(grep -c '^ok' "$results")
failed=$(grep -c '^FAILED' "$results")
echo "$passed passed, $failed failed"
((passed > 0 && failed == 0))
