#!/bin/bash
# Builds the packages twice, in different folders, with another umask, time zone, language and home folder, and compares them
# byte by byte. The second build is made from a fresh copy of the project, so two compilations are needed unless build/ is up to date.
# Usage: scripts/reproducible.sh [FOLDER]; the second copy and its build stay in FOLDER
set -euo pipefail

if (($# > 0)); then
    copy=$(realpath --canonicalize-missing "$1")
else
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    copy=$scratch/gsim-again
fi
cd "$(dirname "$0")/.."

# Prints the names of the files that differ in two packages.
show_difference() {
    local folder
    folder=$(mktemp -d)
    mkdir "$folder/first" "$folder/second"
    if [[ $1 == *.deb ]]; then
        dpkg-deb --raw-extract "$1" "$folder/first/files"
        dpkg-deb --raw-extract "$2" "$folder/second/files"
    else
        tar -xzf "$1" -C "$folder/first"
        tar -xzf "$2" -C "$folder/second"
    fi
    (cd "$folder"; diff --recursive --brief --no-dereference first second || true)
    rm -rf "$folder"
}

make package
scripts/fresh-copy.sh "$copy"
(
    umask 077
    unset SOURCE_DATE_EPOCH
    mkdir -p "$copy/build/home"
    HOME=$copy/build/home TZ=Pacific/Kiritimati LANG=C LC_ALL=C make -C "$copy" package
)

passed=0
failed=0
for first in build/packages/*; do
    second=$copy/$first
    if cmp "$first" "$second"; then
        echo "ok ${first##*/}: twice the same bytes"
        passed=$((passed + 1))
    else
        show_difference "$first" "$second"
        echo "FAILED ${first##*/}: built twice, it differs"
        failed=$((failed + 1))
    fi
done
echo "$passed passed, $failed failed"
((failed == 0))
