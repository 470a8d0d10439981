#!/bin/bash
# Runs the numbered examples of samples/engine and compares each output with NAME.out next to its source.
# Usage: run_examples.sh FOLDER-OF-EXECUTABLES [--renew]
set -uo pipefail

programs=$(realpath "$1")
cd "$(dirname "$0")/../../../samples" || exit
failed=0

# Arguments of the examples that need a file.
arguments() {
    case $1 in
    *_axis_limits) echo machines/router3.toml ;;
    *_pose) echo machines/mill-table-table.toml ;;
    *_drawing_to_gcode) echo plate.svg ;;
    esac
}

for source in engine/[0-9]*.cpp; do
    name=$(basename "$source" .cpp)
    # shellcheck disable=SC2046  # no argument if there is none
    output=$("$programs/example_$name" $(arguments "$name") 2>&1) || { echo "FAILED $name: status $?"; failed=1; }
    if [[ ${2:-} == --renew ]]; then
        echo "$output" >"engine/$name.out"
    elif ! diff <(echo "$output") "engine/$name.out"; then
        echo "FAILED $name: the output differs from engine/$name.out"
        failed=1
    fi
done
exit "$failed"
