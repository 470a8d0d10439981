#!/bin/bash
# Fetches the other sources for WebAssembly, Debian's sources of Lua and pugixml, into build-wasm-sources/. They come from the mirror of
# this system's apt, signed and with Debian's patches. The system itself is not changed.
# Usage: scripts/wasm-sources.sh
set -euo pipefail

cd "$(dirname "$0")/.."
readonly target=$PWD/build-wasm-sources
[[ -d $target/lua5.4/src && -d $target/pugixml/src ]] && exit 0

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/lists/partial" "$work/cache/archives/partial" "$work/parts"
for file in /etc/apt/sources.list.d/*.sources; do
    [[ -e $file ]] && sed -E 's/^Types:.*/Types: deb-src/' "$file" >"$work/parts/${file##*/}"
done
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [[ -e $file ]] && sed -nE 's/^deb( .*debian.org.*)/deb-src\1/p' "$file" >"$work/parts/$(basename "$file" .list).list"
done
apt() {
    apt-get -q -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$work/parts" -o Dir::State::Lists="$work/lists" \
        -o Dir::Cache="$work/cache" "$@"
}
cd "$work"
# Other package lists may have no sources: only the requested sources must exist.
apt update >"$work/log" 2>&1 || true
for package in lua5.4 pugixml; do
    apt source --download-only "$package" >>"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
    dpkg-source -x "$package"_*.dsc "$package" >>"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
done
mkdir -p "$target"
rm -rf "${target:?}/lua5.4" "$target/pugixml"
mv lua5.4 pugixml "$target"
