#!/bin/bash
# The first example: translates the sample program, shows the Lua, simulates it.
# Usage: scripts/run-wheel.sh BUILD-FOLDER
set -euo pipefail

build=$1
readonly machine=samples/machines/af5-measured.toml
readonly shown=25

echo
echo "$ $build/bin/gcode2lua samples/wheel.nc -o $build/wheel.lua"
"$build/bin/gcode2lua" samples/wheel.nc -o "$build/wheel.lua"

echo
echo "$ head -n $shown $build/wheel.lua"
head -n "$shown" "$build/wheel.lua"

echo
echo "$ $build/bin/gsim-run --machine $machine $build/wheel.lua"
"$build/bin/gsim-run" --machine "$machine" "$build/wheel.lua"
