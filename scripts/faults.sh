#!/bin/bash
# Prints the tables of docs/faults.md: injects all possible faults (GSIM_TEST_ALL=1 in the environment) or a sample of
# them, and adds up the results of the jobs. Fails if a test fails.
# Usage: scripts/faults.sh BUILD-FOLDER
set -euo pipefail

build=$1
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT

code=0
for part in allocations calls kills; do
    GSIM_FAULT_TABLE=1 "$build/bin/faults_${part}_test" >"$rows.$part" || code=1
    grep '^| ' "$rows.$part" >>"$rows"
    ((code == 0)) || cat "$rows.$part" >&2
    rm -f "$rows.$part"
done

echo '| fault | jobs | places | tried | status 2 and a message | as without it |'
echo '| --- | ---: | ---: | ---: | ---: | ---: |'
awk -F' *[|] *' 'NF == 8 { if (!($2 in jobs)) order[++kinds] = $2; jobs[$2]++; of[$2] += $4; tried[$2] += $5; told[$2] += $6; done[$2] += $7 }
    END { for (i = 1; i <= kinds; i++) { k = order[i]; print "| " k " | " jobs[k] " | " of[k] " | " tried[k] " | " told[k] " | " done[k] " |" } }' "$rows"
echo
echo '| signal | jobs | sent | new files are all there | temporary files or locks are left |'
echo '| --- | ---: | ---: | ---: | ---: |'
awk -F' *[|] *' 'NF == 7 { if (!($2 in jobs)) order[++kinds] = $2; jobs[$2]++; sent[$2] += $4; whole[$2] += $5; left[$2] += $6 }
    END { for (i = 1; i <= kinds; i++) { k = order[i]; print "| " k " | " jobs[k] " | " sent[k] " | " whole[k] " | " left[k] " |" } }' "$rows"
exit "$code"
