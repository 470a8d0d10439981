#!/bin/bash
# Looks at our own sources without running them.
# Usage: scripts/lint.sh format          is everything formatted as .clang-format says?
#        scripts/lint.sh tidy BUILD [COMMITS]
#                                        clang-tidy (.clang-tidy) over the programs' sources; BUILD holds a finished build,
#                                        since the generated parser's headers are read. COMMITS: only over what that many
#                                        of the last commits changed, and what includes a header that they changed
set -euo pipefail

cd "$(dirname "$0")/.."
readonly rooms='text|os|lexer|grammar|codegen|runtime|geometry|drawing|solid|cutting|lua_lib|apps|bench'

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

# The sources that the last commits changed, and those that include a header that they changed.
changed() {
    local base=$1 file
    git diff --name-only --diff-filter=d "$base" -- '*.cpp' '*.h' | while read -r file; do
        if [[ $file == *.h ]]; then git grep -l -F "#include \"$file\"" -- '*.cpp' || true; else echo "$file"; fi
    done | grep -E "^($rooms)/" | sort -u
}

# The rooms are anchored at this folder, so that what flex and bison wrote below BUILD stays out.
tidy() {
    local log base own="^$PWD/($rooms)/"
    local sources=("$own.*\.cpp$")
    if (($# > 1)) && base=$(git rev-parse --verify --quiet "HEAD~$2"); then
        mapfile -t sources < <(changed "$base" | sed -e 's/\./\\./g' -e "s|.*|^$PWD/&\$|")
        ((${#sources[@]})) || return 0
    fi
    log=$(mktemp)
    if run-clang-tidy -quiet -j "$(scripts/jobs.sh)" -p "$1" -header-filter="$own" "${sources[@]}" >"$log" 2>&1; then
        rm -f "$log"
        return
    fi
    grep -v -e '^[^ ]*clang-tidy' -e '^[0-9]* warnings\? ' "$log" >&2
    rm -f "$log"
    return 1
}

case ${1:-} in
format) format ;;
tidy) tidy "${2:?the build folder}" "${@:3}" ;;
*)
    echo "usage: $0 format | tidy BUILD [COMMITS]" >&2
    exit 2
    ;;
esac
