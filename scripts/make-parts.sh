#!/bin/sh
# Writes the STEP files of samples/parts again, by OpenCASCADE, from the models in tests/cam/solid. Usage: scripts/make-parts.sh [BUILD]
set -eu
cd "$(dirname "$0")/.."
build=${1:-build}
cmake --build "$build" --target write_parts
mkdir -p samples/parts
"$build/bin/write_parts" samples/parts samples/wheel.path.json
# The time of writing is replaced by a fixed one, because it would differ each time.
sed -i "s/'[0-9-]*T[0-9:]*'/'2026-11-25T00:00:00'/" samples/parts/*.step
