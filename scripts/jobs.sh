#!/bin/bash
# Prints the number of compilers to run at once: one for each core, but no more than fit into memory.
set -euo pipefail

readonly kib_per_job=$((2304 * 1024))
free_kib=$(awk '/^MemAvailable:/ { print $2 }' /proc/meminfo)
limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || echo max)
if [[ $limit != max ]] && ((limit / 1024 < free_kib)); then
    free_kib=$((limit / 1024))
fi
jobs=$(nproc)
room=$((free_kib / kib_per_job))
((room < jobs)) && jobs=$room
((jobs < 1)) && jobs=1
echo "$jobs"
