#!/bin/bash
# Renews the pictures of the documentation: a command on its page draws each of them.
# Usage: scripts/pictures.sh BUILD-FOLDER
set -euo pipefail

cd "$(dirname "$0")/.."
readonly scratch=$1/pictures
readonly largest=200000  # bytes

# page, output of its command, the picture
readonly pictures="
README.md                   path.png     wheel.png
docs/first-cell.md          part.png     first-cell.png
docs/tasks/cycle-time.md    rosette.png  rosette.png
docs/tasks/drawing.md       plate.png    plate.png
docs/tasks/machine.md       reach.svg    reach.svg
"

while read -r page drawn picture; do
    [[ -n $page ]] || continue
    PYTHONDONTWRITEBYTECODE=1 python3 tests/docs/run_commands.py --source . --programs "$1/bin" --scratch "$scratch" --keep "$page"
    name=${page%.md}
    cp "$scratch/${name//\//_}/$drawn" "docs/images/$picture"
    if (($(stat -c %s "docs/images/$picture") > largest)); then
        echo "pictures: docs/images/$picture has more than $largest bytes" >&2
        exit 1
    fi
done <<<"$pictures"
rm -rf "$scratch"
