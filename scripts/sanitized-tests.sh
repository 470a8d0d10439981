#!/bin/bash
# Runs tests under the address and undefined-behaviour sanitizers: those of the folders that changed since a commit, and of the folders
# that include them (scripts/affected.py). Closes with "N passed, N failed".
# Usage: scripts/sanitized-tests.sh SINCE | all
set -uo pipefail

since=${1:?since which commit, or all}
cd "$(dirname "$0")/.." || exit

# Only this one of CMake's makefiles has a target for all of a folder.
build_folder() {
    make -C build-sanitize -f CMakeFiles/Makefile2 -j "$(scripts/jobs.sh)" "$1/all" >"build-sanitize/$1.log" 2>&1 || {
        cat "build-sanitize/$1.log"
        return 1
    }
}

folders=$(scripts/affected.py tests "$since") || exit
names=""
scripts/setup.sh test clang && cmake --preset sanitize >/dev/null || exit
for folder in $folders; do
    [[ -d build-sanitize/$folder ]] || continue
    echo "under sanitizers: $folder (after $SECONDS s)"
    build_folder "$folder" || exit
    names+=$(ctest --test-dir "build-sanitize/$folder" -N | sed -n 's/^ *Test *#[0-9]*: //p' | sed 's/$/|/' | tr -d '\n')
done
if [[ -z $names ]]; then
    echo "nothing that changed has tests"
    echo "0 passed, 0 failed"
    exit
fi
# Fewer random programs, because they take ten times as long under sanitizers.
GSIM_ROUNDTRIP_PROGRAMS=30 GSIM_ROUND_TRIP_PROGRAMS=4 scripts/test.sh build-sanitize --parallel "$(scripts/jobs.sh)" -R "^(${names%|})\$"
