#!/bin/bash
# Measures which lines and branches of the product the tests run, by module. Runs the tests of a folder that the preset `coverage`
# built and reads their counts. Prints a table, writes BUILD-FOLDER/report/index.html, and fails below 95 % of lines.
# Usage: scripts/coverage.sh test BUILD-FOLDER [ctest options]   deletes earlier counts, then runs the tests
#        scripts/coverage.sh report BUILD-FOLDER                 prints the table of all runs since then
set -euo pipefail

cd "$(dirname "$0")/.."
readonly least_percent=95
# The engine, the studio, batches and calibration are not counted.
readonly modules='base|geometry|lexer|grammar|codegen|controller|motion|machine|collision|toolpath|runtime|analysis|cam|cli|apps'

# Recordings that are not part of the project are left out: they would run lines that its own tests do not run.
run_tests() {
    local build=$1
    shift
    find "$build" -name '*.gcda' -delete
    rm -f "$build/lua_lines"
    env -u GSIM_CORPUS -u GSIM_REFERENCE GSIM_LUA_LINES="$PWD/$build/lua_lines" LD_PRELOAD="$PWD/$build/lib/libgsim_lua_lines.so" \
        scripts/test.sh "$build" "$@"
}

# Generated code counts by the lines of gcode.l and gcode.y in it; embedded files do not count.
report() {
    local build=$1
    mkdir -p "$build/report"
    gcovr --root . --filter "($modules)/" --exclude '.*/batches/' --exclude-throw-branches --exclude-unreachable-branches \
        -j "$(scripts/jobs.sh)" --json-summary "$build/coverage.json" --txt "$build/report/files.txt" --html-details "$build/report/index.html" "$build" >"$build/gcovr.log" 2>&1 ||
        { cat "$build/gcovr.log" >&2; return 1; }
    python3 scripts/coverage_table.py --least "$least_percent" "$build/coverage.json" "$build/lua_lines"
}

case ${1:-} in
test) run_tests "${2:?which build folder}" "${@:3}" ;;
report) report "${2:?which build folder}" ;;
*)
    echo "usage: $0 test | report BUILD-FOLDER" >&2
    exit 2
    ;;
esac
