#!/bin/bash
# Fuzzes one or all targets. Inputs that break a promise are stored in tests/fuzz/findings/TARGET, which fuzz_regressions also reads.
# Usage: tests/fuzz/run.sh BUILD-FOLDER SECONDS [TARGETS]
# In the environment: JOBS (how many targets at once), RECORD=1 (adds the results of the run to tests/fuzz/RESULTS.md), SEED (that of
# the mutations: 0, the default, is a new one each time).
# A run continues with the inputs of earlier runs in BUILD-FOLDER/fuzz-corpus.
set -uo pipefail

build=$(cd "$1" && pwd)
seconds=$2
wanted=${3:-}
here=$(cd "$(dirname "$0")" && pwd)
jobs=${JOBS:-1}

# Prints libFuzzer's report of a finding without its progress lines. In CI it also prints the input, because the machine may be deleted.
tell() {
    local target=$1 log=$2 findings=$3 found
    echo "FAILED: $target"
    grep -v -E '^(#[0-9]+\s|INFO:|stat::)' "$log" | head -n 50
    found=$(find "$findings" -type f -newer "$log.began" | head -n 1)
    [[ $found && ${CI:-} ]] && { echo "$found, by base64 -d | gunzip:"; gzip -9 -c "$found" | base64; }
}

# The name of the program selects the target. New inputs go only to the first folder, so the seeds do not change.
fuzz_one() {
    local target=$1 family=$2
    local inputs="$build/fuzz-corpus/$target" findings="$here/findings/$target" log="$build/fuzz-$target.log" status
    mkdir -p "$inputs" "$findings" "$build/bin/fuzz"
    ln -sf ../gsim-fuzz "$build/bin/fuzz/$target"
    touch "$log.began"
    local TIMEFORMAT='cpu_s %U %S'
    { time "$build/bin/fuzz/$target" "$inputs" "$here/corpus/$family" "$findings" -dict="$here/dictionaries/$family.dict" \
        -seed="${SEED:-0}" -max_len=4096 -timeout=10 -rss_limit_mb=2048 -max_total_time="$seconds" -print_final_stats=1 -print_funcs=0 -close_fd_mask=1 \
        -artifact_prefix="$findings/" >"$log" 2>&1; } 2>>"$log.time"
    status=$?
    cat "$log.time" >>"$log"
    rm -f "$log.time"
    "$here/count.py" "$log" "$target" "$here" "${RECORD:-}" || status=1
    ((status == 0)) || tell "$target" "$log" "$findings" >"$log.failed"
    rmdir "$findings" 2>/dev/null
    return "$status"
}

if [[ ${4:-} ]]; then
    fuzz_one "$wanted" "$4"
    exit
fi

list=$("$build/bin/gsim-fuzz")
all=$list
if [[ $wanted ]]; then
    list=""
    for name in $wanted; do
        list+=$(grep "^$name " <<<"$all")$'\n' || {
            echo "tests/fuzz/run.sh: there is no target '$name'; there are:" "$(cut -d ' ' -f 1 <<<"$all" | tr '\n' ' ')"
            exit 2
        }
    done
    list=${list%$'\n'}
fi
rm -f "$build"/fuzz-*.log.failed
xargs -P "$jobs" -L 1 "$0" "$build" "$seconds" <<<"$list"
status=$?
# Failures come last, so that nobody has to search for them.
cat "$build"/fuzz-*.log.failed 2>/dev/null
exit "$status"
