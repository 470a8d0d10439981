#!/bin/bash
# Runs the programs that are installed below PREFIX: the wheel, a cell, a path, a module, and all other installed parts. The
# programs get an empty environment and a foreign folder. It needs only bash, coreutils, grep and sed, so that it also
# runs in a root that has only the packages. Prints a line for each check, "ok ..." or "FAILED ...".
# Usage: tests/install/check.sh PREFIX
# shellcheck disable=SC2317  # functions are called by check
set -uo pipefail

prefix=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
readonly prefix scratch bin=$prefix/bin share=$prefix/share
readonly samples=$share/gsim/samples
failed=0
cd /

# Runs a command with a minimal environment.
bare() {
    env -i PATH=/usr/bin:/bin HOME="$scratch" LC_ALL=C "$@"
}

# check WHAT PATTERN COMMAND...: checks that the command succeeds, and that a line of its output has the pattern.
check() {
    local what=$1 pattern=$2 output code=0
    shift 2
    output=$("$@" 2>&1) || code=$?
    if ((code == 0)) && grep -q -e "$pattern" <<<"$output"; then
        echo "ok $what"
    else
        failed=1
        echo "FAILED $what: status $code, wanted '$pattern' from: $*"
        head -n 20 <<<"$output"
    fi
}

# Prints `present` if each file exists, compressed or not, and is not empty; links must have a target.
present() {
    local file
    for file; do
        if [[ ! -s $file && ! -s $file.gz ]]; then
            echo "missing or empty: $file"
            return 1
        fi
    done
    echo present
}

way_of_a_path() {
    bare "$bin/autopath" "$samples/plate.svg" --material aluminum --thickness 12 --at 200 200 50 -o "$scratch/plate.json" &&
        bare "$bin/path2gcode" "$scratch/plate.json" -o "$scratch/plate.nc" &&
        bare "$bin/gsim-run" "$scratch/plate.nc"
}

translated() {
    bare "$bin/gcode2lua" "$samples/wheel.nc" -o "$scratch/wheel.lua" &&
        bare "$bin/gsim" run --machine "$samples/machines/af5-measured.toml" "$scratch/wheel.lua"
}

# Builds a module from the example with the installed header, and runs it.
own_module() {
    cc -shared -fPIC -I"$prefix/include" "$prefix/share/doc/gsim/examples/small_module.c" -o "$scratch/small.so" -lm &&
        printf 'G1 X10 F600\nM2\n' >"$scratch/part.nc" &&
        bare "$bin/gsim-run" --rcs "$scratch/small.so" "$scratch/part.nc"
}

# Checks the folders of gsim.pc; pkg-config puts backslashes before special characters of the shell.
described() {
    local variable folder
    local -A files=([includedir]=gsim/rcs_module.h [moduledir]=libgsim_rcs_default.so)
    for variable in "${!files[@]}"; do
        folder=$(PKG_CONFIG_PATH=$share/pkgconfig pkg-config "--variable=$variable" gsim)
        present "${folder//\\/}/${files[$variable]}" || return
    done
}

# The file is not a solid, but the reader must start with all its libraries to find that out.
no_solid() {
    echo 'ISO-10303-21; nothing follows' >"$scratch/part.step"
    ! bare "$bin/autopath" "$scratch/part.step" --material aluminum --thickness 12
}

# Identifies a servo loop from a run of the machine that has it.
servo_loop() {
    bare "$bin/gsim-run" --quiet --machine "$samples/machines/gantry-dynamics.toml" --dialect rs274ngc --trajectory "$scratch/servo.csv" --following --step 0.001 \
        "$samples/rosette.ngc" &&
        bare "$bin/gsim-calibrate" servo "$scratch/servo.csv" --machine "$samples/machines/gantry-dynamics.toml" -o "$scratch/followed.toml" &&
        bare "$bin/gsim-run" --quiet --machine "$scratch/followed.toml" --dialect rs274ngc "$samples/rosette.ngc"
}

readonly names=(gsim-run gsim-check gcode2lua autopath path2gcode gsim-data gsim-studio)
for name in gsim "${names[@]}"; do
    check "$name --version" "^$name [0-9]" bare "$bin/$name" --version
    check "$name(1)" present present "$share/man/man1/$name.1"
    check "completion of $name" present present "$share/bash-completion/completions/$name" "$share/fish/vendor_completions.d/$name.fish"
done
# Makes a page with a finished run, if the page of the studio is installed.
page_of_a_run() {
    bare "$bin/gsim" run --quiet --view "$scratch/run.html" "$samples/wheel.nc" && grep -c 'id="run">H4sI' "$scratch/run.html"
}

# Requests the page only by its address, which is the first line of the output.
served_page() {
    local address host
    (exec env -i PATH=/usr/bin:/bin HOME="$scratch" LC_ALL=C "$bin/gsim" studio --no-browser "$samples" >"$scratch/address" 2>"$scratch/refused") &
    local server=$!
    for _ in {1..100}; do
        [[ -s $scratch/address ]] && break
        sleep 0.1
    done
    address=$(head -n 1 "$scratch/address")
    [[ $address =~ ^http://(127\.0\.0\.1):([0-9]+)(/[0-9a-f]{32}/)$ ]] || { cat "$scratch/refused"; return 1; }
    host=${BASH_REMATCH[1]}:${BASH_REMATCH[2]}
    exec 5<>"/dev/tcp/${BASH_REMATCH[1]}/${BASH_REMATCH[2]}"
    printf 'GET %s HTTP/1.1\r\nHost: %s\r\n\r\n' "${BASH_REMATCH[3]}" "$host" >&5
    head -n 1 <&5
    exec 5>&-
    kill "$server"
    wait "$server"
}

# Runs a batch twice: the second time nothing is left to run.
batch() {
    (cd "$scratch" && for _ in 1 2; do bare "$bin/gsim-batch" --machine af5-measured --no-collisions "$samples/wheel.nc" || return; done)
}
check 'gsim-batch --version' '^gsim-batch [0-9]' bare "$bin/gsim-batch" --version
# Without bodies, which take minutes under sanitizers. The archive's folder has double quotes in its name, so TOML needs a literal string.
cat >"$scratch/place.toml" <<END
programs = '$samples/wheel.path.json'
machines = "af5-measured"
[options]
collisions = false
[objective]
cycle_time_s = 1
[[setting]]
key = "path.place.x_mm"
from = -150
to = 500
END
search_by_name() {
    (cd "$scratch" && bare "$bin/gsim-optimise" place.toml --variants 12 --best best -q && bare "$bin/gsim-run" --quiet --no-collisions --machine af5-measured best/wheel.nc && echo "run again")
}
check 'a search, and what it has written' 'run again' search_by_name
check 'gsim-optimise --version' '^gsim-optimise [0-9]' bare "$bin/gsim-optimise" --version
check 'gsim-optimise(1)' present present "$share/man/man1/gsim-optimise.1"
check 'completion of gsim-optimise' present present "$share/bash-completion/completions/gsim-optimise"
check 'gsim-batch(1)' present present "$share/man/man1/gsim-batch.1"
check 'many runs' '0 run in .* 1 reused; 0 failed' batch
check 'completion for zsh' present present "$share"/zsh/*/_gsim
check samples present present "$share/doc/gsim/samples/wheel.nc" "$share/doc/gsim/lua_lib/init.lua"
check wheel '^cycle time  129\.9[89]' bare "$bin/gsim-run" --machine "$samples/machines/af5-measured.toml" "$samples/wheel.nc"
check 'wheel, translated' '^cycle time  129\.9[89]' translated
check 'wheel, checked' '' bare "$bin/gsim-check" "$samples/wheel.nc"
check cell '^collisions  none' bare "$bin/gsim-run" --cell "$samples/cell/table.toml" "$samples/wheel.nc"
check path '^status      completed' way_of_a_path
check module '^status      completed' bare "$bin/gsim-run" --rcs "$prefix/lib/gsim/libgsim_rcs_default.so" "$samples/wheel.nc"
check 'library in Lua' '^cycle time  129\.9[89]' bare "$bin/gsim-run" --lua-lib "$share/gsim/lua_lib" \
    --machine "$samples/machines/af5-measured.toml" "$samples/wheel.nc"
# Calls the programs by their names, from a foreign folder.
check 'sample machine by its name' '^cycle time  129\.9[89]' bare "$bin/gsim-run" --machine af5-measured samples/wheel.nc
check 'module in the program' '^status      completed' bare "$bin/gsim-run" --rcs gsim_rcs_default --rcs-in-process "$samples/wheel.nc"
check 'module by its name' '^status      completed' bare "$bin/gsim-run" --rcs gsim_rcs_default samples/wheel.nc
check 'materials and drawings by their names' '' bare "$bin/autopath" samples/plate.svg --materials samples/materials.toml \
    --material aluminum --thickness 12 --at 200 200 50 -o "$scratch/named.json"
if [[ -e $prefix/include/gsim/rcs_module.h ]] && command -v cc >/dev/null; then
    check 'module of one'"'"'s own' '^status      completed' own_module
fi
if [[ -e $share/pkgconfig/gsim.pc ]] && command -v pkg-config >/dev/null; then
    check pkg-config present described
fi
if [[ -e $prefix/libexec/gsim/gsim-solid ]]; then
    check 'reader of solids' 'part\.step' no_solid
else
    check 'no reader of solids' "gsim-solid is neither in '$bin' nor in\|scripts/setup.sh step" no_solid
fi
if [[ -e $bin/gsim-calibrate ]]; then
    check 'gsim-calibrate --version' '^gsim-calibrate [0-9]' bare "$bin/gsim-calibrate" --version
    check 'gsim-calibrate(1)' present present "$share/man/man1/gsim-calibrate.1"
    check 'servo loop from a recording' 'X: the following error' servo_loop
fi
if [[ -e $share/gsim/studio/studio.html ]]; then
    check 'page of a run' '^1$' page_of_a_run
fi
if [[ -e $share/gsim/studio/served.html && -e $prefix/libexec/gsim/gsim-serve ]]; then
    check 'served page' '^HTTP/1.1 200' served_page
fi
if [[ -e $share/doc/gsim/README.md ]]; then
    check documentation present present "$share/doc/gsim/docs/machine-file.md" "$share/doc/gsim/docs/path.schema.json"
fi
exit "$failed"
