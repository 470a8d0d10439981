#!/bin/bash
# Runs the tests of a build folder and closes with one line of plain numbers: "N passed, N failed".
# Usage: scripts/test.sh BUILD-FOLDER [ctest options]
set -uo pipefail

build=$1
shift
junit=$(mktemp)
trap 'rm -f "$junit"' EXIT

ctest --test-dir "$build" --output-on-failure --no-tests=error --output-junit "$junit" "$@"
code=$?

count() { grep -o "<testcase [^>]*status=\"$1\"" "$junit" | wc -l; }
passed=$(count run)
failed=$(($(count fail) + $(count notrun)))
((code != 0 && failed == 0)) && failed=1
echo "$passed passed, $failed failed"
exit "$code"
