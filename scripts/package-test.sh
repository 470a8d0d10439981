#!/bin/bash
# Tests packages on systems that have never had gsim or its build tools: the Debian packages in an empty root of this
# Debian, the archive in this one and in a newer one, in a folder with an odd name. The roots are made from the mirror of
# this system's apt. Closes with "N passed, N failed".
# Usage: scripts/package-test.sh PACKAGES
set -uo pipefail

packages=$(realpath "$1")
cd "$(dirname "$0")/.." || exit
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
readonly packages scratch
readonly results=$scratch/results
readonly odd="an odd \"földer\"/of \$gsim"
touch "$results"
export LC_ALL=C.UTF-8

# Prints the output of a command and stores it for the count; a command that fails without output is a failure, too.
counted() {
    local code
    "$@" 2>&1 | tee -a "$results"
    code=${PIPESTATUS[0]}
    ((code == 0)) || echo "FAILED $1: status $code" | tee -a "$results"
}

unpack_archive() {
    mkdir -p "$1/$odd" && tar -xzf "$packages"/gsim-*.tar.gz --strip-components=1 -C "$1/$odd"
}

# Prints the highest version that the archive requires of a library, such as GLIBC.
asked_version() {
    objdump -T "$scratch/$odd"/bin/gsim "$scratch/$odd"/bin/gsim-batch "$scratch/$odd"/libexec/gsim/gsim-serve "$scratch/$odd"/libexec/gsim/gsim-rcs-host "$scratch/$odd"/lib/gsim/*.so* | grep -o "\b$1_[0-9.]*" | sort -uV | tail -n 1
}

# at_most NAME VERSION: compares with the version of Debian 12; those of Ubuntu 24.04 and Debian 13 are newer.
at_most() {
    local asked
    asked=$(asked_version "$1")
    if [[ $(printf '%s\n' "$asked" "$1_$2" | sort -V | tail -n 1) == "$1_$2" ]]; then
        echo "ok the archive asks for $asked, Debian 12 has $1_$2"
    else
        echo "FAILED the archive asks for $asked, Debian 12 has $1_$2"
    fi
}

# Checks that the archive contains all its libraries, except those that each system has.
own_libraries() {
    local foreign
    foreign=$(ldd "$scratch/$odd"/bin/gsim "$scratch/$odd"/bin/gsim-batch "$scratch/$odd"/libexec/gsim/gsim-serve "$scratch/$odd"/libexec/gsim/gsim-rcs-host "$scratch/$odd"/lib/gsim/*.so* | awk '$2 == "=>" { print $1, $0 }' |
        grep -Ev '^(libc|libm|libstdc\+\+|libgcc_s)\.so' | grep -vF "$scratch/$odd/")
    if [[ -z $foreign ]]; then echo 'ok the archive brings its libraries'; else echo "FAILED not from the archive: $foreign"; fi
}

archive_here() {
    unpack_archive "$scratch" && own_libraries && at_most GLIBC 2.36 && at_most GLIBCXX 3.4.30 && at_most CXXABI 1.3.13 &&
        tests/install/check.sh "$scratch/$odd"
}

# Prints the address from which apt gets the packages of this Debian.
mirror() {
    # shellcheck disable=SC2016  # apt's own fields
    apt-get indextargets --format '$(ORIGIN) $(CODENAME) $(COMPONENT) $(REPO_URI)' 'Created-By: Packages' 2>/dev/null |
        sed -n "s|^Debian $1 main \(.*[^/]\)/*$|\1|p" | head -n 1
}

has_release() {
    /usr/lib/apt/apt-helper download-file "$1/dists/$2/InRelease" "$scratch/InRelease" >/dev/null 2>&1
}

# in_root RELEASE MIRROR FOLDER COMMAND: makes a root of the release, puts the folder into it and runs the command there.
in_root() {
    mmdebstrap --quiet --variant=apt --format=null --customize-hook="copy-in '$3' /opt" \
        --customize-hook="chroot \"\$1\" $4" "$1" /dev/null "$2"
}

no_roots() {
    if ((EUID != 0)); then
        echo 'it takes root'
    elif ! command -v mmdebstrap >/dev/null; then
        echo 'there is no mmdebstrap; scripts/setup.sh package installs it'
    elif [[ -z $(mirror "$release") ]]; then
        echo 'apt names no mirror of a Debian'
    else
        return 1
    fi
}

echo 'the archive here:'
counted archive_here

release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
if why=$(no_roots); then
    echo "skipped: no empty roots, since $why"
else
    mkdir "$scratch/gsim-packages"
    cp tests/install/check.sh tests/install/engine.sh tests/install/packages.sh "$packages"/*.deb "$scratch/gsim-packages"
    echo "the Debian packages in an empty root ($release):"
    counted in_root "$release" "$(mirror "$release")" "$scratch/gsim-packages" \
        '/opt/gsim-packages/packages.sh /opt/gsim-packages'

    mkdir "$scratch/archive"
    unpack_archive "$scratch/archive"
    cp tests/install/check.sh "$scratch/archive"
    command="/opt/archive/check.sh $(printf '%q' "/opt/archive/$odd")"
    for other in "$release" trixie; do
        if has_release "$(mirror "$release")" "$other"; then
            echo "the archive in an empty root ($other):"
            counted in_root "$other" "$(mirror "$release")" "$scratch/archive" "$command"
        else
            echo "skipped: the mirror has no $other"
        fi
    done
fi

passed=$(grep -c '^ok' "$results")
failed=$(grep -c '^FAILED' "$results")
echo "$passed passed, $failed failed"
((failed == 0))
