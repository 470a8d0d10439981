#!/bin/bash
# Runs the checks of the project, stage by stage. The stages depend only on the tier and on the commit: not on the time, the machine, or
# earlier runs. Closes with the tier, each stage with its seconds, what the tier leaves out, and "N passed, N failed".
# Usage: scripts/check.sh fast      before a merge: all stages; those that check changes check those since the commit in .ci/accepted
#        scripts/check.sh full      everything, whatever has changed
#        scripts/check.sh touched   the stages of `fast` that uncommitted and unpushed changes touch, cheapest first; stops at the first failure
set -uo pipefail

cd "$(dirname "$0")/.." || exit
readonly tier=${1:-}
passed=0
failed=0
report=()
failures=()
# The output of failures is repeated at the end, because a viewer of this log may cut its middle.
evidence=$(mktemp)
readonly evidence
trap 'rm -f "$evidence"' EXIT

# Prints the commit since which changes are checked, or `all` if that commit is not known here.
base_commit() {
    local base
    case $tier in
    full) base=all ;;
    touched) base=$(git merge-base HEAD '@{upstream}' 2>/dev/null) || base=$(<.ci/accepted) ;;
    *) base=$(<.ci/accepted) ;;
    esac
    git merge-base --is-ancestor "$base" HEAD 2>/dev/null && echo "$base" || echo all
}

count() {
    passed=$((passed + $1))
    failed=$((failed + $2))
}

# Prints the output of each failed test in the log of a command, of GoogleTest and of our own scripts.
failed_tests() {
    {
        awk '/^\[ RUN      \]/ { kept = "" }
             { kept = substr(kept $0 "\n", length(kept) > 4000 ? length($0) : 1) }
             /^\[  FAILED  \].* ms\)$/ { printf "%s", kept; kept = "" }' "$1"
        grep -A 12 '^FAILED ' "$1"
        grep -F '***' "$1" | grep -vF '***Skipped'
    } | tail -n 150
}

# Runs a command and counts its closing "N passed, N failed"; without that line the command counts as one check.
run() {
    local log code closing='^([0-9]+) passed, ([0-9]+) failed$'
    log=$(mktemp)
    "$@" 2>&1 | tee "$log"
    code=${PIPESTATUS[0]}
    if [[ $(grep -E "$closing" "$log" | tail -n 1) =~ $closing ]]; then
        count "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}"
        ((code != 0 && BASH_REMATCH[2] == 0)) && count 0 1
    elif ((code == 0)); then
        count 1 0
    else
        count 0 1
    fi
    ((code != 0)) && { echo "of: $*"; failed_tests "$log"; } >>"$evidence"
    rm -f "$log"
    return "$code"
}

is_touched() {
    [[ $tier != touched ]] || grep -qE "$1" <<<"$changed"
}

# stage NAME FILES COMMAND...: runs a stage; its command repeats it. FILES: a pattern of the names of the files that touch it.
stage() {
    local name=$1 files=$2 began_s=$SECONDS result=passed
    shift 2
    is_touched "$files" || return 0
    echo
    echo "== $name: $*"
    run "$@" || result="FAILED; again: $*"
    report+=("$(printf '%6d s  %-34s %s' $((SECONDS - began_s)) "$name" "$result")")
    [[ $result == passed ]] && return
    failures+=("$name: $*")
    [[ $tier != touched ]] || finish
}

# Some of the tools below are not available on every system.
install_tools() {
    scripts/setup.sh test lint || return
    scripts/setup.sh calibrate || echo "no Ceres here, so none of the tests of gsim-calibrate"
    scripts/setup.sh step || echo "no OpenCASCADE here, so none of the tests with STEP and IGES files"
    scripts/setup.sh slurm
    export SLURM_NEEDED=1 # its test fails here if there is no Slurm
}

left_out() {
    case $tier in
    full) echo "nothing" ;;
    fast) echo "clang-tidy, compilation by itself, sanitizers and fuzzing of what has not changed; packages built twice and compared; what is installed without its build (FULL=1 .ci/run)" ;;
    touched) echo "stages that the changes do not touch (.ci/run), and what that leaves out" ;;
    esac
}

finish() {
    echo
    echo "== end"
    cat "$evidence"
    echo "tier $tier, changes since $since"
    printf '%s\n' "${report[@]:-nothing was touched}"
    echo "left out: $(left_out)"
    ((${#failures[@]} > 0)) && printf 'FAILED: %s\n' "${failures[@]}"
    echo "$passed passed, $failed failed"
    ((failed == 0))
    exit
}

case $tier in
fast | full | touched) ;;
*)
    echo "usage: $0 fast | full | touched" >&2
    exit 2
    ;;
esac
install_tools || { echo "0 passed, 1 failed"; exit 1; }
since=$(base_commit)
readonly since
changed=$(scripts/affected.py files "$since") || exit
readonly changed
product="^($(python3 -B scripts/modules.py --folders)|cmake|samples)/|^CMake" || exit
readonly cpp='\.(cpp|h|def|l|y)$' product

stage "format" "$cpp|^\.clang-format$|^scripts/lint" scripts/lint.sh format
stage "site" '\.md$|^docs/|^mkdocs|^scripts/site' make site
stage "each changed source by itself" "$cpp" scripts/lint.sh alone "$since"
stage "clang-tidy" "$cpp|^\.clang-tidy$" scripts/lint.sh tidy "$since"
stage "first result" "$product|^Makefile|^scripts/(setup|run-wheel)" make run
stage "tests" . make test
stage "WebAssembly" "$product|^scripts/wasm" make wasm
stage "page in Chromium" "$product|^scripts/studio" env LANES=2 make studio-test
stage "sanitizers" "$cpp" scripts/sanitized-tests.sh "$since"
stage "fuzzing of changed readers" "$cpp" scripts/fuzz-changed.sh "$since"
if [[ $tier == full ]]; then
    # The second build is made from a fresh copy, which is installed from afterwards and deleted.
    copy=$(mktemp -d)/copy
    stage "packages, built twice" . scripts/reproducible.sh "$copy"
    stage "installed without the build" . scripts/install-test.sh "$copy"
else
    stage "packages" "$product|^debian|^scripts/package" make package
fi
stage "packages in empty roots" "$product|^debian|^scripts/package" scripts/package-test.sh build/packages
finish
