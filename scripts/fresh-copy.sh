#!/bin/bash
# Copies the project into a folder, like a clone with the uncommitted changes: all files that git tracks or would track.
# Usage: scripts/fresh-copy.sh FOLDER, which must not exist yet
set -euo pipefail

mkdir -p "$(dirname "$1")"
mkdir "$1"
to=$(realpath "$1")
cd "$(dirname "$0")/.."
git ls-files -z --cached --others --exclude-standard | while IFS= read -r -d '' file; do
    [[ ! -e $file && ! -L $file ]] || printf '%s\0' "$file"
done | tar --create --null --no-recursion --files-from=- | tar --extract --directory="$to"
