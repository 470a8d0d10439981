#!/bin/bash
# Looks at our own sources without running them.
# Usage: scripts/lint.sh format          is everything formatted as .clang-format says?
#        scripts/lint.sh tidy BUILD      clang-tidy (.clang-tidy) over the programs' sources; BUILD holds a finished build,
#                                        since the generated parser's headers are read
set -euo pipefail

cd "$(dirname "$0")/.."
readonly rooms='text|lexer|grammar|codegen|runtime|geometry|drawing|solid|cutting|lua_lib|apps|bench'

format() {
    local file code=0
    while read -r file; do
        clang-format --dry-run -Werror "$file" 2>/dev/null || {
            echo "$file: not formatted; make format" >&2
            code=1
        }
    done < <(scripts/sources.sh)
    return $code
}

# The rooms are anchored at this folder, so that what flex and bison wrote below BUILD stays out.
tidy() {
    local log own="^$PWD/($rooms)/"
    log=$(mktemp)
    if run-clang-tidy -quiet -j "$(scripts/jobs.sh)" -p "$1" -header-filter="$own" "$own.*\.cpp$" >"$log" 2>&1; then
        rm -f "$log"
        return
    fi
    grep -v -e '^[^ ]*clang-tidy' -e '^[0-9]* warnings\? ' "$log" >&2
    rm -f "$log"
    return 1
}

case ${1:-} in
format) format ;;
tidy) tidy "${2:?the build folder}" ;;
*)
    echo "usage: $0 format | tidy BUILD" >&2
    exit 2
    ;;
esac
