#!/bin/bash
# Installs a build into an empty folder and runs it from there, as far from the build folder as can be without deleting it.
# Usage: tests/install/install_test.sh BUILD [paths]; paths: no installed file may tell the build folder
set -euo pipefail

build=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
readonly build here scratch prefix=$scratch/installed

# In components: a whole installation would overwrite the manifest of one that somebody may want to take back.
install_into() {
    local component
    for component in programs studio development solid docs licence; do
        cmake --install "$build" --component "$component" --prefix "$1" >>"$scratch/log" || return
        # Without OpenCASCADE there is nothing of solid, and no manifest of it or an empty one.
        [[ ! -s $build/install_manifest_$component.txt ]] || grep . "$build/install_manifest_$component.txt" >>"$scratch/manifest"
    done
}

fail() {
    echo "FAILED $*"
    exit 1
}

install_into "$prefix"
DESTDIR=$scratch/root install_into /usr
diff -r --no-dereference "$prefix" "$scratch/root/usr" || fail 'the installation depends on the prefix'
echo 'ok DESTDIR'

if [[ ${2:-} == paths ]]; then
    ! grep -rlF "$build" "$prefix" || fail "the files above tell the build folder $build"
    echo 'ok no file tells the build folder'
fi

# Where the system lets us, the build folder is empty for the programs.
hidden=()
if unshare --user --map-root-user --mount mount -t tmpfs none "$build" 2>/dev/null; then
    # shellcheck disable=SC2016  # the inner shell's
    hidden=(unshare --user --map-root-user --mount bash -c 'mount -t tmpfs none "$0" && exec "$@"' "$build")
fi
"${hidden[@]}" "$here/check.sh" "$prefix"
if ((${#hidden[@]})); then echo 'ok with the build folder hidden'; else echo 'the build folder could not be hidden here'; fi

# The manifest has names without DESTDIR, of both installations; what is below neither stays.
: >"$scratch/installed/bin/of-others"
"$here/../../scripts/uninstall.sh" "$scratch/manifest" >/dev/null
[[ $(find "$prefix" -type f -o -type l) == "$prefix/bin/of-others" ]] || fail 'uninstall left files'
[[ -z $(find "$prefix" -name gsim) ]] || fail 'uninstall left folders'
echo 'ok uninstall'
