#!/bin/bash
# Installs the Debian packages that are missing. Groups: build (programs; always), test, coverage, lint,
# clang (compiles for sanitizers and fuzzing), wasm (WebAssembly: 800 MB; an installed node of any origin is used), studio (the page:
# node and npm if there are none, because Debian's npm conflicts with a newer node), browser (Chromium, to test the page),
# step (OpenCASCADE reads STEP and IGES files; the programs can be built without it), calibrate (Ceres; only gsim-calibrate needs it),
# site (the documentation as pages), slurm (a cluster of one machine, to test gsim-batch), package (makes packages and tests them).
# Usage: scripts/setup.sh [test] [coverage] [lint] [clang] [step] [wasm] [studio] [browser] [calibrate] [site] [slurm] [package]
set -euo pipefail

declare -A packages=(
    [build]="ccache g++ cmake make bison flex pkg-config liblua5.4-dev libeigen3-dev libfmt-dev libcli11-dev nlohmann-json3-dev
             libtomlplusplus-dev libexpected-dev libfast-float-dev libpugixml-dev libcpp-httplib-dev zlib1g-dev
             libboost-dev libsqlite3-dev libssl-dev"
    [test]="libgtest-dev libgmock-dev libfcl-dev liborocos-kdl-dev libpolyclipping-dev lua5.4 gnuplot-nox python3 jq
            locales mold"
    [coverage]="gcovr"
    [lint]="clang-format clang-tidy"
    [clang]="clang libclang-rt-14-dev llvm"
    [step]="libocct-data-exchange-dev"
    [wasm]="emscripten python3 dpkg-dev"
    [studio]=""
    [browser]="chromium"
    [calibrate]="libceres-dev"
    [site]="mkdocs"
    [slurm]="slurmctld slurmd slurm-client munge python3"
    [package]="debhelper dpkg-dev lintian patchelf mmdebstrap"
)

command -v node >/dev/null && command -v npm >/dev/null || packages[studio]="nodejs npm"

wanted=""
for group in build "$@"; do
    if [[ -z ${packages[$group]+known} ]]; then
        echo "setup: no group of packages is called '$group'; there are: ${!packages[*]}" >&2
        exit 2
    fi
    wanted+=" ${packages[$group]}"
done
read -ra wanted <<<"${wanted//$'\n'/ }"

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "setup: this is not a Debian system; what it should have: ${wanted[*]}" >&2
    exit 0
fi

missing=()
for package in "${wanted[@]}"; do
    status=$(dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null || true)
    grep -qx installed <<<"$status" || missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
        echo "setup: these packages are missing: ${missing[*]}" >&2
        echo "setup: neither root nor sudo here; as root, run: apt-get install ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi

echo "setup: installing ${missing[*]}"
# Prints apt's output only if it fails.
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y "$@" >"$log" 2>&1 || { cat "$log" >&2; return 1; }; }
apt update
apt install --no-install-recommends "${missing[@]}"
