#!/bin/bash
# Makes the page of the studio out of studio/src, with the engine of build-wasm, into share/gsim/studio of a build folder, where gsim-run
# --view and an installation have it: studio.html, and view.html, into which a finished run goes.
# Usage: scripts/studio.sh BUILD
set -euo pipefail

cd "$(dirname "$0")/.."
output=$(realpath "$1")/share/gsim/studio
readonly output stamp=studio/node_modules/.gsim-lock

# The lock file says which packages, and their sums; npm has them from wherever this system's npm does.
if ! cmp --silent studio/package-lock.json "$stamp"; then
    npm --prefix studio ci --silent
    cp studio/package-lock.json "$stamp"
fi
(cd studio && npx --no-install tsc --project .)
node studio/build.mjs build-wasm/bin samples "$output"
