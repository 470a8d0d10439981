#!/bin/bash
# Makes the page of the studio from studio/src, with the engine of build-wasm, in share/gsim/studio of a build folder, for gsim-run
# --view and for installations: studio.html, and view.html, to which a finished run is added.
# Usage: scripts/studio.sh BUILD
set -euo pipefail

cd "$(dirname "$0")/.."
output=$(realpath "$1")/share/gsim/studio
readonly output stamp=studio/node_modules/.gsim-lock

# The lock file has the packages and their checksums; npm gets them from the registry that is set on this system.
if ! cmp --silent studio/package-lock.json "$stamp"; then
    npm --prefix studio ci --silent
    cp studio/package-lock.json "$stamp"
fi
(cd studio && npx --no-install tsc --project .)
node studio/build.mjs build-wasm/bin samples "$output"
