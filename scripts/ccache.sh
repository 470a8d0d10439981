#!/bin/sh
# Calls a compiler through ccache, such that a clone in another folder finds what the first one has compiled.
# Usage: scripts/ccache.sh PROJECT-FOLDER COMPILER ARGUMENTS...
set -eu

project=$1
shift
# Builders of packages have no home: where nothing can be kept, ccache would refuse to compile.
cache=${CCACHE_DIR:-${XDG_CACHE_HOME:-${HOME:-}/.cache}/ccache}
[ -w "$cache" ] || mkdir -p "$cache" 2>/dev/null || exec "$@"

# Paths below the project's folder are taken as relative; in messages they are whole again.
export CCACHE_BASEDIR="$project" CCACHE_ABSSTDERR=1 CCACHE_NOHASHDIR=1
# What a unit includes is read from the compiler's list of dependencies, so nothing is preprocessed twice.
export CCACHE_DEPEND=1
# Precompiled headers are known by what is in them, not by when they were written.
export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
# The list that sanitizers get is known by its contents, not by where it lies.
export CCACHE_IGNOREOPTIONS='-fsanitize-ignorelist=*' CCACHE_EXTRAFILES="$project/cmake/sanitize-ignore.txt"
case $1 in
*em++ | *emcc) export CCACHE_COMPILERTYPE=clang ;;  # ccache knows emscripten by no name
esac

# A precompiled header of before would be taken for one that the new one includes, whose bytes no other clone has.
is_output=''
for argument in "$@"; do
    if [ -n "$is_output" ]; then
        case $argument in *.gch | *.pch) rm -f "$argument" ;; esac
    fi
    if [ "$argument" = -o ]; then is_output=1; else is_output=''; fi
done
exec ccache "$@"
