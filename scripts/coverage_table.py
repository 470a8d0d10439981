#!/usr/bin/env python3
"""Prints the table of docs/coverage.md: covered lines and branches of each module, from gcovr's summary, and the lines of lua_lib/ that
the tests recorded (tests/coverage). Returns status 1 if fewer lines are covered than --least, in C++ or in Lua.
Usage: coverage_table.py --least PERCENT [--missing] SUMMARY LUA-LINES"""

import argparse
import json
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path


def module_of(name):
    folders = name.split("/")[:-1]
    return "/".join(folders[:1] if folders[0] in ("apps", "cli", "codegen", "grammar", "lexer") else folders[:2])


def modules_of(summary):
    modules = defaultdict(lambda: [0, 0, 0, 0])
    for file in summary["files"]:
        counts = modules[module_of(file["filename"])]
        for place, name in enumerate(("line_total", "line_covered", "branch_total", "branch_covered")):
            counts[place] += file[name]
    return modules


def lines_with_code(file):
    """Returns the lines with instructions, from Lua's compiler. Lines that it adds at the beginning of a chunk, and at the
    end of a function that returns earlier, are never run, so they do not count."""
    listed = subprocess.run(["luac5.4", "-l", "-p", file], capture_output=True, text=True, check=True).stdout
    numbers = {int(number) for number in re.findall(r"^\t\d+\t\[(\d+)\]\t(?!VARARGPREP)", listed, re.MULTILINE)}
    texts = file.read_text(encoding="utf-8").splitlines()
    return {number for number in numbers if not re.fullmatch(r"\s*end\W*", texts[number - 1])}


def lua_missing(noted):
    run = set(Path(noted).read_text(encoding="utf-8").split())
    for file in sorted(Path("lua_lib").rglob("*.lua")):
        lines = lines_with_code(file)
        yield file, len(lines), sorted(number for number in lines if f"{file}:{number}" not in run)


def percent(covered, total):
    return 100 * covered / total if total else 100.0


def row(name, counts):
    lines, lines_run, branches, branches_run = counts
    cells = [lines, lines_run, f"{percent(lines_run, lines):.1f}"]
    cells += [branches, branches_run, f"{percent(branches_run, branches):.1f}"] if branches else ["", "", ""]
    return f"| {name} | " + " | ".join(str(cell) for cell in cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--least", type=float, required=True, help="per cent of lines")
    parser.add_argument("--missing", action="store_true", help="list the lines of lua_lib/ that are not run, too")
    parser.add_argument("summary")
    parser.add_argument("lua_lines")
    arguments = parser.parse_args()

    modules = modules_of(json.loads(Path(arguments.summary).read_text(encoding="utf-8")))
    lua = list(lua_missing(arguments.lua_lines))
    lua_total = sum(total for _, total, _ in lua)
    lua_run = lua_total - sum(len(missing) for _, _, missing in lua)
    all_modules = [sum(column) for column in zip(*modules.values())]

    print("| module | lines | run | % | branches | taken | % |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    for name in sorted(modules):
        print(row(f"`{name}`", modules[name]))
    print(row("C++ in all", all_modules))
    print(row("`lua_lib`", [lua_total, lua_run, 0, 0]))
    if arguments.missing:
        for file, _, missing in lua:
            print(*(f"{file}:{number}" for number in missing), sep="\n")

    low = [name for name, total, run in (("C++", *all_modules[:2]), ("Lua", lua_total, lua_run)) if percent(run, total) < arguments.least]
    for name in low:
        print(f"coverage: the tests run less than {arguments.least:g} % of the lines of {name}", file=sys.stderr)
    return 1 if low else 0


if __name__ == "__main__":
    sys.exit(main())
