#!/bin/bash
# Fuzzes the translator; what it finds is left in tests/fuzz/findings, where fuzz_regressions looks too.
# Usage: tests/fuzz/run.sh BUILD-FOLDER SECONDS
set -euo pipefail

build=$1
seconds=$2
here=$(dirname "$0")
mkdir -p "$build/corpus"

# New inputs go to the first folder only: the seeds stay as they were written. libFuzzer's lines for each new or smaller
# input and the words it would add to the dictionary are left out.
"$build/bin/translate_fuzz" "$build/corpus" "$here/corpus" "$here/findings" -dict="$here/gcode.dict" -max_len=4096 \
    -timeout=10 -rss_limit_mb=2048 -max_total_time="$seconds" -print_final_stats=1 -print_funcs=0 \
    -artifact_prefix="$here/findings/" 2>&1 | grep -v -E '^#[0-9]+\s+(NEW|REDUCE|RELOAD) |^"|Recommended dictionary|recommended dictionary'
