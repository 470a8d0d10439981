#!/bin/bash
# Tests the page of the studio: its functions without a browser, its closed forms against gsim-run --trajectory, and the page itself in a
# headless browser. If there is no page, no node or no Chromium, it prints so and skips (status 77); with --required that is a failure.
# Closes with "N passed, N failed".
# Usage: scripts/studio-test.sh BUILD [--required]
set -uo pipefail

build=$(realpath "$1")
readonly build required=${2:-}
cd "$(dirname "$0")/.."

lacking() {
    [[ -s $build/share/gsim/studio/studio.html && -d studio/node_modules ]] || { echo "there is no page; make studio makes it"; return; }
    command -v node >/dev/null || { echo "there is no node"; return; }
    [[ -x ${CHROMIUM:-/usr/bin/chromium} ]] || echo "there is no Chromium; scripts/setup.sh browser installs it"
}

why=$(lacking)
if [[ -n $why ]]; then
    echo "studio: $why"
    [[ $required == --required ]] || exit 77
    echo "0 passed, 1 failed"
    exit 1
fi

passed=0
failed=0
for test in "units" "exact $build" "page $build"; do
    log=$(mktemp)
    read -r name arguments <<<"$test"
    node "studio/tests/$name.mjs" ${arguments:+"$arguments"} 2>&1 | tee "$log"
    if [[ $(tail -n 1 "$log") =~ ^([1-9][0-9]*)\ passed,\ ([0-9]+)\ failed$ ]]; then
        passed=$((passed + BASH_REMATCH[1]))
        failed=$((failed + BASH_REMATCH[2]))
    else
        echo "FAILED $name: it did not run to its end"
        failed=$((failed + 1))
    fi
    rm -f "$log"
done
echo "$passed passed, $failed failed"
((failed == 0))
