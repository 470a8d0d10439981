#!/bin/bash
# Installs a build into an empty folder and runs it there. The build folder is hidden if the system permits it.
# Usage: tests/install/install_test.sh BUILD [paths]; paths: no installed file may contain the path of the build folder
set -euo pipefail

build=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
readonly build here scratch prefix=$scratch/installed

# Installs by components, because a full installation would overwrite the manifest that an uninstallation may need.
install_into() {
    local component
    for component in programs studio development solid docs licence; do
        cmake --install "$build" --component "$component" --prefix "$1" >>"$scratch/log" || return
        # Without OpenCASCADE the component solid is empty, and its manifest is missing or empty.
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

# If the system permits it, the programs see an empty build folder.
hidden=()
if unshare --user --map-root-user --mount mount -t tmpfs none "$build" 2>/dev/null; then
    # shellcheck disable=SC2016  # the inner shell's
    hidden=(unshare --user --map-root-user --mount bash -c 'mount -t tmpfs none "$0" && exec "$@"' "$build")
fi
"${hidden[@]}" "$here/check.sh" "$prefix"
if ((${#hidden[@]})); then echo 'ok with the build folder hidden'; else echo 'the build folder could not be hidden here'; fi

# The manifest has the names of both installations without DESTDIR; other files stay.
: >"$scratch/installed/bin/of-others"
"$here/../../scripts/uninstall.sh" "$scratch/manifest" >/dev/null
[[ $(find "$prefix" -type f -o -type l) == "$prefix/bin/of-others" ]] || fail 'uninstall left files'
[[ -z $(find "$prefix" -name gsim) ]] || fail 'uninstall left folders'
echo 'ok uninstall'
