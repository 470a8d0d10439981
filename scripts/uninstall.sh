#!/bin/bash
# Removes the files that `make install` installed, and our folders that are then empty. DESTDIR must be the same as then.
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

# Our folders are those called gsim and those below; bin, share/man and others may belong to the system, even if they are empty.
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
