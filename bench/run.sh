#!/bin/bash
# Generates the inputs, measures, writes RESULT (BUILD-FOLDER/bench.md). Usage: bench/run.sh BUILD-FOLDER [RESULT]
# RUNS (5), LINES (1000000), ARCS (200000), PASSES (100000), CELL_BLOCKS (10000) may be set smaller for a look.
set -euo pipefail

build=$(cd "$1" && pwd)
result=$(realpath -m "${2:-$build/bench.md}")
readonly result
commit=$(git -C "$(dirname "$0")" describe --always --dirty --abbrev=12 2>/dev/null || echo unknown)
readonly runs=${RUNS:-5} lines=${LINES:-1000000} arcs=${ARCS:-200000} passes=${PASSES:-100000} cell_blocks=${CELL_BLOCKS:-10000}
readonly bin=$build/bin
# The long program is a day of machining many times over: the limits that guard against endless programs are raised for it.
readonly unbounded="--max-time 1e9 --max-blocks 1000000000"

mkdir -p "$(dirname "$result")/bench"
cd "$(dirname "$result")/bench"

generate() {
    "$bin/gsim-bench-generate" "$1" "$2" >"$3"
}

# TITLE BLOCKS FILE
contest() {
    echo "measuring: $1" >&2
    "$bin/gsim-bench-compare" "$1" "$2" "$runs" "rs274 -g" "flex scan=$bin/gsim-bench-floor $3" "gcode2lua=$bin/gcode2lua $3" \
        "gsim-run=$bin/gsim-run --quiet $unbounded $3" "rs274 -g=rs274 -g $3"
}

# TITLE BLOCKS FILE RS274-FILE: a loop is a few lines to scan and to translate, so only running it counts.
loop_contest() {
    echo "measuring: $1" >&2
    "$bin/gsim-bench-compare" "$1" "$2" "$runs" "rs274 -g" "gsim-run=$bin/gsim-run --quiet $unbounded $3" \
        "gsim-run, rs274ngc=$bin/gsim-run --dialect rs274ngc --quiet $unbounded $4" "rs274 -g=rs274 -g $4"
}

# One run each: the row is for its memory.
long_contest() {
    echo "measuring: $1" >&2
    "$bin/gsim-bench-compare" "$1" "$2" 1 none "gcode2lua=$bin/gcode2lua $3" "gsim-run=$bin/gsim-run --quiet $unbounded $3"
}

# BLOCKS: how the look for collisions grows with them, and what the same run takes without. A run that finds contacts would fail.
cell_contest() {
    echo "measuring: $(thousands "$1") blocks in a cell" >&2
    generate cell-blocks "$1" cell.nc
    "$bin/gsim-bench-compare" "$(thousands "$1") blocks in a cell" "$1" "$runs" none "gsim-run=$bin/gsim-run --quiet $unbounded cell.nc" \
        "gsim-run --cell=$bin/gsim-run --quiet $unbounded --cell cell.toml cell.nc"
}

thousands() {
    sed -e ':more' -e 's/\([0-9]\)\([0-9]\{3\}\)\(,\|$\)/\1,\2\3/' -e 't more' <<<"$1"
}

machine() {
    echo "$(lscpu | sed -n 's/^Model name: *//p' | head -n 1), $(nproc) cores, $(free -g | awk '/^Mem:/ { print $2 }') GB; $(date -I); commit $commit"
}

generate lines "$lines" lines.nc
generate lines "$((10 * lines))" long.nc
generate arcs "$arcs" arcs.nc
generate macro-ab9 "$passes" macro.nc
generate macro-rs274 "$passes" macro.ngc
generate cell-mesh 50 torus.obj
generate cell 50 cell.toml

{
    machine
    echo
    echo "| input | program | CPU s, median [min .. max] of $runs | million blocks/s | peak MB | CPU, rs274 = 1 |"
    echo "| --- | --- | ---: | ---: | ---: | ---: |"
    contest "$(thousands "$lines") lines" "$lines" lines.nc
    contest "$(thousands "$arcs") arcs" "$arcs" arcs.nc
    loop_contest "$(thousands "$passes") passes of a loop" "$((21 * passes))" macro.nc macro.ngc
    long_contest "$(thousands "$((10 * lines))") lines (one run)" "$((10 * lines))" long.nc
    cell_contest "$cell_blocks"
    cell_contest "$((10 * cell_blocks))"
} >"$result.part"
mv "$result.part" "$result"
rm -f long.nc
cat "$result"
