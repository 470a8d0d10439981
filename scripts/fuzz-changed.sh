#!/bin/bash
# Fuzzes the readers that changed since a commit (scripts/affected.py), each for FUZZ_SECONDS (6), under sanitizers. The seed is fixed, so
# that a result depends only on the change; long runs by hand (make fuzz) search new inputs.
# Usage: scripts/fuzz-changed.sh SINCE | all
set -uo pipefail

since=${1:?since which commit, or all}
cd "$(dirname "$0")/.." || exit

has_fuzzer() {
    scripts/setup.sh clang && echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
        clang++ -fsanitize=fuzzer -x c++ - -o /dev/null 2>/dev/null
}

readers=$(scripts/affected.py readers "$since") || exit
if [[ -z $readers ]]; then
    echo "no reader has changed"
elif ! has_fuzzer; then
    echo "skipped: clang has no libFuzzer here"
else
    SEED=1 make fuzz FUZZ_SECONDS="${FUZZ_SECONDS:-6}" TARGET="${readers//$'\n'/ }"
fi
