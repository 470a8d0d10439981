#!/bin/bash
# Lists our C++ files, one a line: those that git tracks or would track, so never a generated file.
set -euo pipefail

cd "$(dirname "$0")/.."
git ls-files --cached --others --exclude-standard -- '*.h' '*.cpp' | while read -r file; do
    [[ -e $file ]] && echo "$file"
done
