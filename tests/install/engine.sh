#!/bin/bash
# Builds and runs the examples of the installed library below PREFIX, in C, C++ and Python, which draws the wheel. It needs a
# compiler, pkg-config, CMake, python3-cffi, python3-numpy and python3-matplotlib. Prints a line for each check, "ok ..." or "FAILED ...".
# Usage: tests/install/engine.sh PREFIX
set -uo pipefail

prefix=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
readonly prefix scratch examples=$prefix/share/gsim/samples/engine wheel=$prefix/share/gsim/samples/wheel.nc
failed=0
cd "$scratch" || exit

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

in_c() {
    # shellcheck disable=SC2046  # words
    gcc -std=c11 -Wall -Wextra -Werror "$examples/run.c" $(pkg-config --cflags --libs libgsim) -o c && ./c "$wheel"
}

in_cpp() {
    # shellcheck disable=SC2046
    g++ -std=c++20 -Wall -Wextra -Werror "$examples/01_cycle_time.cpp" $(pkg-config --cflags --libs libgsim) -o cpp && ./cpp
}

# Compiles each header by itself.
headers() {
    local header
    for header in "$prefix"/include/gsim/engine/*.h "$prefix/include/gsim/gsim.h"; do
        echo "#include <${header#"$prefix/include/"}>" | g++ -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I"$prefix/include" -x c++ - || return
    done
    echo '#include <gsim/gsim.h>' | gcc -std=c11 -Wall -Wextra -Wpedantic -Werror -fsyntax-only -I"$prefix/include" -x c - && echo 'all headers'
}

by_cmake() {
    cat >CMakeLists.txt <<TEXT
cmake_minimum_required(VERSION 3.25)
project(user CXX)
find_package(gsim 0.1 REQUIRED)
foreach(kind gsim static)
    add_executable(by_\${kind} $examples/01_cycle_time.cpp)
    target_link_libraries(by_\${kind} PRIVATE gsim::\${kind})
endforeach()
TEXT
    cmake -S . -B build -DCMAKE_PREFIX_PATH="$prefix" && cmake --build build && build/by_gsim && build/by_static
}

in_python() {
    /usr/bin/python3 "$examples/plot_wheel.py" "$wheel" wheel.png && file_starts_with wheel.png PNG && echo 'a picture'
}

file_starts_with() {
    head -c 8 "$1" | grep -q -a "$2"
}

errors_in_python() {
    /usr/bin/python3 - <<'TEXT'
import gsim
try:
    gsim.run("part.nc", "G0 X1\nG1 X\n")
except gsim.ProgramError as error:
    assert [told["line"] for told in error.diagnostics] == [2], error.diagnostics
run = gsim.run("part.nc", "M98 P7\nG1 X60 F600\nM2\n", files={"O0007.nc": "O7\nG0 X10\nM99\n"}, step_s=0.1)
assert run.outcome == "completed" and list(run.moves["line"]) == [2, 2] and run.files == ["O0007.nc", "part.nc"], run.moves
assert abs(run.samples["t_s"][-1] - run.report["cycle_time_s"]) < 1e-9
assert "G1{x=60" in gsim.translate("part.nc", "G1 X60 F600\nM2\n")
try:
    gsim.run("part.nc", "M2\n", machin="x")
except TypeError as error:
    print(error)
TEXT
}

check 'headers of the library' 'all headers' headers
check 'library in C' '^44 moves' in_c
check 'library in C++' '^completed: ' in_cpp
check 'library by CMake, shared and static' '^completed: ' by_cmake
check 'library in Python, which draws the wheel' 'a picture' in_python
check 'errors and files in Python' "no option 'machin'" errors_in_python
exit "$failed"
