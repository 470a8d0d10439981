#!/bin/bash
# The documentation as pages with a search, in build/site. Nothing is fetched, and the pages load nothing from elsewhere.
# Usage: scripts/site.sh
set -euo pipefail

cd "$(dirname "$0")/.."
readonly source=build/site-src

# mkdocs wants all pages in a folder of their own. They lie in it as they lie here, so no link has to be rewritten.
rm -rf "$source"
mkdir -p "$source"
cp -r --parents README.md SECURITY.md CONTRIBUTING.md RELEASING.md CHANGELOG.md LICENSE docs samples lua_lib/README.md bench/README.md \
    bench/RESULTS.md tests/fuzz/README.md tests/fuzz/RESULTS.md engine/gsim.h "$source"

# The same pages from the same sources: what mkdocs dates, it dates by the last commit.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || echo 0)}
export SOURCE_DATE_EPOCH
log=$(mktemp)
trap 'rm -f "$log"' EXIT
mkdocs build --clean --config-file mkdocs.yml >"$log" 2>&1 || { cat "$log" >&2; exit 1; }

# Both mkdocs and its theme may begin to load fonts or scripts with another version of theirs.
if grep -rEl --include='*.html' '(src|href)="(https?:)?//[^"]*\.(js|css|woff2?|ttf|png|svg)"' build/site; then
    echo "site: the pages above load files from elsewhere" >&2
    exit 1
fi
echo "build/site/index.html; its search needs a server: python3 -m http.server --directory build/site"
