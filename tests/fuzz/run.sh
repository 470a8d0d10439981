#!/bin/bash
# Fuzzes the targets, one or all of them; what breaks a promise is left in tests/fuzz/findings/TARGET, where fuzz_regressions looks too.
# Usage: tests/fuzz/run.sh BUILD-FOLDER SECONDS [TARGET]
# In the environment: JOBS (how many targets at once), RECORD=1 (adds the figures of the run to tests/fuzz/RESULTS.md), SEED (that of
# the mutations: 0, the default, is another one each time).
# A run goes on with the inputs that the ones before have left in BUILD-FOLDER/fuzz-corpus.
set -uo pipefail

build=$(cd "$1" && pwd)
seconds=$2
wanted=${3:-}
here=$(cd "$(dirname "$0")" && pwd)
jobs=${JOBS:-1}

# A target by many names of one program. New inputs go to the first folder only: the seeds stay as they were written.
fuzz_one() {
    local target=$1 family=$2
    local inputs="$build/fuzz-corpus/$target" findings="$here/findings/$target" log="$build/fuzz-$target.log" status
    mkdir -p "$inputs" "$findings" "$build/bin/fuzz"
    ln -sf ../gsim-fuzz "$build/bin/fuzz/$target"
    local TIMEFORMAT='cpu_s %U %S'
    { time "$build/bin/fuzz/$target" "$inputs" "$here/corpus/$family" "$findings" -dict="$here/dictionaries/$family.dict" \
        -seed="${SEED:-0}" -max_len=4096 -timeout=10 -rss_limit_mb=2048 -max_total_time="$seconds" -print_final_stats=1 -print_funcs=0 -close_fd_mask=1 \
        -artifact_prefix="$findings/" >"$log" 2>&1; } 2>>"$log.time"
    status=$?
    cat "$log.time" >>"$log"
    rm -f "$log.time"
    "$here/count.py" "$log" "$target" "$here" "${RECORD:-}" || status=1
    # What libFuzzer tells of a finding; else its progress says nothing to people.
    ((status == 0)) || grep -v -E '^#[0-9]+\s+(NEW|REDUCE|RELOAD|pulse|INITED) ' "$log" | tail -n 60
    rmdir "$findings" 2>/dev/null
    return "$status"
}

if [[ ${4:-} ]]; then
    fuzz_one "$wanted" "$4"
    exit
fi

list=$("$build/bin/gsim-fuzz")
[[ $wanted ]] && list=$(grep "^$wanted " <<<"$list")
if [[ ! $list ]]; then
    echo "tests/fuzz/run.sh: there is no target '$wanted'; there are:" "$("$build/bin/gsim-fuzz" | cut -d ' ' -f 1 | tr '\n' ' ')"
    exit 2
fi
xargs -P "$jobs" -L 1 "$0" "$build" "$seconds" <<<"$list"
