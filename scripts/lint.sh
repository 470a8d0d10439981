#!/bin/bash
# Checks our sources without running them.
# Usage: scripts/lint.sh format         is everything formatted by .clang-format, are tests NamedLikeThis, does nothing call fmt::print()?
#        scripts/lint.sh tidy [SINCE]   clang-tidy (.clang-tidy) over all sources of the programs, in batches: most of the time goes into
#                                       headers, which are checked once for each batch. SINCE, a commit: over the batches with sources that
#                                       changed since, and one batch for each header that changed
#        scripts/lint.sh alone SINCE    does each source that changed since that commit compile by itself? Batches hide a missing #include
# SINCE `all` checks everything.
set -euo pipefail

cd "$(dirname "$0")/.."
modules=$(python3 -B scripts/modules.py --folders)'|bench'
readonly modules

format() {
    local code=0
    if ! scripts/sources.sh | xargs -d '\n' -P "$(scripts/jobs.sh)" -n 20 clang-format --dry-run -Werror 2>&1 |
        sed -nE 's/^([^: ]+):[0-9]+:[0-9]+: error: .*/\1: not formatted; make format/p' | sort -u >&2; then
        code=1
    fi
    test_names || code=1
    printing || code=1
    return $code
}

# GoogleTest reserves '_' in names of tests for its generated names.
test_names() {
    ! git grep -nE '^(TEST|TEST_F|TEST_P|TYPED_TEST)\(\w+, *(\w*_|[a-z])' -- '*.cpp' '*.h'
}

# fmt::print() throws if it cannot write, so a log on a full disk would end the program; apps::print() does not throw.
printing() {
    ! git grep -nF 'fmt::print(' -- '*.cpp' '*.h' ':!tests' ':!bench' ':!samples'
}

# Makes the generated headers, and compile_commands.json, in a folder. Usage: prepare FOLDER [options of cmake]
prepare() {
    cmake --preset lint -B "$@" >/dev/null
    cmake --build "$1" --target generated >/dev/null
}

# Prints the batches and sources with changes since a commit, as patterns of full names. A header is checked in one of them.
batches_since() {
    local source batches
    { scripts/affected.py changed "$1"; scripts/affected.py headers "$1"; } | sed -nE "\\#^($modules)/#p" | while read -r source; do
        batches=$(grep -rlF --include='*.cxx' "\"$source\"" build-lint) || true
        printf '%s\n' "${batches:-$source}"
    done | sort -u | sed -E 's#^build-lint/#'"$PWD"'/build-lint/#; s#^([^/].*)#'"$PWD"'/\1#; s/[.]/\\./g; s/^/^/; s/$/$/'
}

# Batches include sources. clang does not know the parameters of g++, so that warning is off.
tidy() {
    local since=${1:-} log own="^$PWD/($modules)/" files
    prepare build-lint
    files=("^$PWD/build-lint/($modules)/(.*/)?batches/" "$own.*\.cpp\$")
    if [[ -n $since && $since != all ]] && git diff --quiet "$since" -- .clang-tidy; then
        mapfile -t files < <(batches_since "$since")
        ((${#files[@]} > 0)) || return 0
    fi
    log=$(mktemp)
    if run-clang-tidy -quiet -j "$(scripts/jobs.sh)" -p build-lint -header-filter="$own" -extra-arg=-Wno-ignored-optimization-argument \
        "${files[@]}" >"$log" 2>&1; then
        rm -f "$log"
        return
    fi
    grep -v -e '^[^ ]*clang-tidy' -e '^[0-9]* warnings\? ' "$log" >&2
    rm -f "$log"
    return 1
}

alone() {
    prepare build-alone -DGSIM_BATCHES=OFF -DGSIM_TESTS=ON
    scripts/affected.py sources "$1" | sed -nE "\\#^($modules|tests)/#p" | python3 scripts/compile_alone.py build-alone "$(scripts/jobs.sh)"
}

case ${1:-} in
format) format ;;
tidy) tidy "${2:-}" ;;
alone) alone "${2:?since which commit}" ;;
*)
    echo "usage: $0 format | tidy [SINCE] | alone SINCE" >&2
    exit 2
    ;;
esac
