#!/bin/bash
# Removes what `make install` installed, and those of our folders that are empty then. DESTDIR has to be what it was.
# Usage: scripts/uninstall.sh MANIFEST, which lists the installed files
set -euo pipefail

readonly manifest=$1
if [[ ! -f $manifest ]]; then
    echo "uninstall: nothing was installed from here by make install ($manifest is missing)" >&2
    exit 1
fi

# CMake ends the last line without a newline.
mapfile -t files < <(grep . "$manifest")
for file in "${files[@]}"; do
    rm -f -- "${DESTDIR:-}$file"
done

# Ours are the folders called gsim and those below; bin, share/man and their like may be others', even if they are empty.
for file in "${files[@]}"; do
    folder=$(dirname "$file")
    while [[ $folder == */gsim || $folder == */gsim/* ]]; do
        echo "${DESTDIR:-}$folder"
        [[ ${folder##*/} == gsim ]] && break
        folder=$(dirname "$folder")
    done
done | sort -ru | while read -r folder; do
    [[ ! -d $folder ]] || rmdir --ignore-fail-on-non-empty -- "$folder"
done
rm -f -- "$manifest"
echo "uninstall: removed ${#files[@]} files"
