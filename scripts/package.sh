#!/bin/bash
# Makes the packages of a release build, in its folder packages: Debian packages, and an archive that runs in any folder.
# The same sources give the same bytes at any time and in any folder (scripts/reproducible.sh).
# Usage: scripts/package.sh BUILD
set -euo pipefail

build=$(realpath "$1")
cd "$(dirname "$0")/.."
export LC_ALL=C.UTF-8 TZ=UTC
umask 022
readonly build work=$build/package-work packages=$build/packages
version=$(sed -n 's/^project(gsim VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
name=gsim-$version-linux-$(uname -m)
readonly version name
SOURCE_DATE_EPOCH=$(dpkg-parsechangelog --show-field Timestamp)
export SOURCE_DATE_EPOCH

# Runs a command without its output; prints all of it if the command fails.
quietly() {
    local log=$work/log
    "$@" >"$log" 2>&1 || {
        cat "$log" >&2
        return 1
    }
}

# The packages are made in a copy of debian/, so that debhelper's temporary files stay below build/.
debian_packages() {
    local profiles=()
    [[ -e $build/bin/gsim-solid ]] || profiles+=(pkg.gsim.nosolid)
    [[ -e $build/bin/gsim-calibrate ]] || profiles+=(pkg.gsim.nocalibrate)
    mkdir "$work/gsim-$version"
    cp -r debian "$work/gsim-$version"
    cd "$work/gsim-$version"
    GSIM_BUILD=$build quietly dpkg-buildpackage --build=binary --no-sign --build-profiles="$(IFS=, && echo "${profiles[*]}")"
    cd - >/dev/null
    mv "$work"/*.deb "$packages"
    TMPDIR=$work quietly lintian --fail-on error,warning "$packages"/*.deb
}

# Prints the shared libraries of a program that a system may lack: all except those of the compiler and of the C library.
libraries() {
    ldd "$@" | awk '$2 == "=>" { print $3 }' | sort -u | grep -Ev '/(libc|libm|libstdc\+\+|libgcc_s)\.so\.'
}

# Prints the name of the package of a file.
package_of() {
    dpkg --search "*/${1##*/}" | sed -n '1s/:.*//p'
}

# The archive has the licences of the code of others in it: the shared libraries, and those that are only headers.
licences() {
    local package
    mkdir "$1"
    {
        for library in "${@:2}"; do package_of "$library"; done
        # The name of the package has its version.
        dpkg --search /usr/include/boost/version.hpp | sed 's/:.*//'
        printf '%s\n' libcli11-dev libeigen3-dev libexpected-dev libfast-float-dev libtomlplusplus-dev nlohmann-json3-dev
    } | sort -u | while read -r package; do
        install -m 644 "/usr/share/doc/$package/copyright" "$1/$package"
    done
}

archive() {
    local root=$work/$name component library libraries
    for component in programs studio development docs licence; do
        quietly cmake --install "$build" --prefix "$root" --component $component --strip
    done
    mapfile -t libraries < <(libraries "$root/bin/gsim" "$root/bin/gsim-batch" "$root/libexec/gsim/gsim-serve" "$root/libexec/gsim/gsim-rcs-host" "$root/lib/gsim/libgsim_rcs_default.so")
    for library in "${libraries[@]}"; do
        install -m 644 "$library" "$root/lib/gsim"
    done
    # shellcheck disable=SC2016  # the loader replaces $ORIGIN
    patchelf --set-rpath '$ORIGIN/../lib/gsim' "$root/bin/gsim" "$root/bin/gsim-batch"
    # shellcheck disable=SC2016
    patchelf --set-rpath '$ORIGIN/../../lib/gsim' "$root/libexec/gsim/gsim-serve" "$root/libexec/gsim/gsim-rcs-host"
    # shellcheck disable=SC2016
    patchelf --set-rpath '$ORIGIN' "$root"/lib/gsim/*.so*
    licences "$root/share/doc/gsim/licences" "${libraries[@]}"
    sed "s/@VERSION@/$version/" scripts/archive-readme.txt >"$root/README"
    tar --create --directory="$work" --format=gnu --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner \
        --mode=u+rw,go=rX "$name" | gzip -9 --no-name >"$packages/$name.tar.gz"
}

if [[ $(dpkg-parsechangelog --show-field Version) != "$version" ]]; then
    echo "package: debian/changelog has another version than CMakeLists.txt ($version)" >&2
    exit 1
fi
rm -rf "$work" "$packages"
mkdir -p "$work" "$packages"
debian_packages
archive
rm -rf "$work"
cd "$packages"
echo "$packages:"
du --apparent-size --block-size=1K -- *
