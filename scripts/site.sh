#!/bin/bash
# Makes the documentation as pages with a search, in build/site. Nothing is fetched, and the pages load nothing from other sites.
# Usage: scripts/site.sh
set -euo pipefail

cd "$(dirname "$0")/.."
readonly source=build/site-src

# mkdocs needs all pages in a separate folder. The folder has the same layout as the project, so that all links stay valid.
rm -rf "$source"
mkdir -p "$source"
cp -r --parents README.md SECURITY.md CONTRIBUTING.md RELEASING.md CHANGELOG.md LICENSE docs samples lua_lib/README.md bench/README.md \
    bench/RESULTS.md tests/fuzz/README.md tests/fuzz/RESULTS.md engine/gsim.h "$source"

# The same sources give the same pages: mkdocs uses the date of the last commit.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || echo 0)}
export SOURCE_DATE_EPOCH
log=$(mktemp)
trap 'rm -f "$log"' EXIT
mkdocs build --clean --config-file mkdocs.yml >"$log" 2>&1 || { cat "$log" >&2; exit 1; }

# A new version of mkdocs or of its theme could load fonts or scripts from other sites.
if grep -rEl --include='*.html' '(src|href)="(https?:)?//[^"]*\.(js|css|woff2?|ttf|png|svg)"' build/site; then
    echo "site: the pages above load files from elsewhere" >&2
    exit 1
fi
echo "build/site/index.html; its search needs a server: python3 -m http.server --directory build/site"
