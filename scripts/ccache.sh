#!/bin/sh
# Calls a compiler through ccache, so that a clone in another folder finds the objects of the first one.
# Usage: scripts/ccache.sh PROJECT-FOLDER COMPILER ARGUMENTS...
set -eu

project=$1
shift
# Builders of packages have no home folder, and ccache does not compile if it cannot write its cache.
cache=${CCACHE_DIR:-${XDG_CACHE_HOME:-${HOME:-}/.cache}/ccache}
[ -w "$cache" ] || mkdir -p "$cache" 2>/dev/null || exec "$@"

# Paths below the project's folder are relative; in messages they are absolute again.
export CCACHE_BASEDIR="$project" CCACHE_ABSSTDERR=1 CCACHE_NOHASHDIR=1
# ccache reads the included files from the compiler's list of dependencies, so nothing is preprocessed twice.
export CCACHE_DEPEND=1
# Precompiled headers are identified by their contents, not by their time.
export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
# The ignore list of the sanitizers is identified by its contents, not by its path.
export CCACHE_IGNOREOPTIONS='-fsanitize-ignorelist=*' CCACHE_EXTRAFILES="$project/cmake/sanitize-ignore.txt"
case $1 in
*em++ | *emcc) export CCACHE_COMPILERTYPE=clang ;;  # ccache does not recognize emscripten by its name
esac

# ccache would read an old precompiled header as an input of the new one, and no other clone has the same bytes.
is_output=''
for argument in "$@"; do
    if [ -n "$is_output" ]; then
        case $argument in *.gch | *.pch) rm -f "$argument" ;; esac
    fi
    if [ "$argument" = -o ]; then is_output=1; else is_output=''; fi
done
exec ccache "$@"
