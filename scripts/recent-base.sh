#!/bin/bash
# Prints the newest commit that is older than the last one by so many hours; where there is none, the first.
# Usage: scripts/recent-base.sh HOURS
set -euo pipefail

cd "$(dirname "$0")/.."
newest_s=$(git log -1 --format=%ct)
base=$(git rev-list -1 --before="@$((newest_s - $1 * 3600))" HEAD)
echo "${base:-$(git rev-list --max-parents=0 HEAD | tail -n 1)}"
