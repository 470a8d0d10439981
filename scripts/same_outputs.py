#!/usr/bin/env python3
"""Shows that two versions of gsim do the same with programs, apart from renamed keys and the wording of messages.

Usage: same_outputs.py OLD NEW [--dialect NAME]... PROGRAM...

OLD and NEW are source trees with build/bin. A folder stands for all programs in it. Each program is translated (the Lua text without its
comments must be equal) and run (exit status and report must be equal: keys by their present names, messages by their codes). Prints each
difference, and how many programs were equal."""

import argparse
import json
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

PROGRAMS = {".nc", ".ngc", ".gcode", ".tap", ".cnc", ".mpf", ".min", ".txt"}
# Keys of reports of version 0.1, by their present names (CHANGELOG.md).
RENAMED = {"jet_on_mm": "process_on_mm", "remedy": "suggested_fix", "looked_at": "checked", "behind_s": "lag_s", "asked_s": "requested_s"}
# Their wording is held by tests/messages/messages.txt.
MESSAGES = {"message", "text"}
COUNTED = {"warnings"}
TIMEOUT_S = 120


def normalized(value):
    """The report with present keys; messages are dropped, lists of messages become their lengths."""
    if isinstance(value, list):
        return [normalized(item) for item in value]
    if not isinstance(value, dict):
        return value
    result = {}
    for key, item in value.items():
        if key in MESSAGES:
            continue
        result[RENAMED.get(key, key)] = len(item) if key in COUNTED and isinstance(item, list) else normalized(item)
    return result


def run(command, tree):
    """(exit status, standard output); the status is text if the program did not end by itself."""
    try:
        ended = subprocess.run(command, cwd=tree, capture_output=True, timeout=TIMEOUT_S)
    except subprocess.TimeoutExpired:
        return "timeout", b""
    return ended.returncode, ended.stdout


def translation(tree, program, dialect):
    status, text = run([f"{tree}/build/bin/gcode2lua", *dialect, program], tree)
    return status, re.sub(rb"[ \t]*--[^\n]*", b"", text)


def report(tree, program, dialect):
    status, text = run([f"{tree}/build/bin/gsim-run", "--json", "--quiet", *dialect, program], tree)
    try:
        return status, normalized(json.loads(text)) if text else None
    except json.JSONDecodeError:
        return status, text


def first_difference(old, new, at=""):
    if isinstance(old, dict) and isinstance(new, dict) and list(old) == list(new):
        pairs = [(f"{at}.{key}", old[key], new[key]) for key in old]
    elif isinstance(old, (list, tuple)) and isinstance(new, (list, tuple)) and len(old) == len(new):
        pairs = [(f"{at}[{i}]", *both) for i, both in enumerate(zip(old, new))]
    else:
        return None if old == new else f"{at}: {str(old)[:200]} is {str(new)[:200]} now"
    return next(filter(None, (first_difference(a, b, place) for place, a, b in pairs)), None)


def compare(trees, program, dialect):
    """The differences of one program."""
    words = ["--dialect", dialect] if dialect else []
    found = []
    for name, output in (("Lua", translation), ("report", report)):
        old, new = (output(tree, program, words) for tree in trees)
        if old != new:
            found.append(f"{program} {dialect}: {name}: {first_difference(old, new)}")
    return found


def programs(names):
    for name in names:
        path = Path(name).resolve()
        if path.is_file():
            yield str(path)
        else:
            yield from (str(file) for file in sorted(path.rglob("*")) if file.is_file() and file.suffix.lower() in PROGRAMS)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--dialect", action="append", default=[])
    parser.add_argument("program", nargs="+")
    options = parser.parse_args()
    trees = [str(Path(tree).resolve()) for tree in (options.old, options.new)]
    jobs = [(program, dialect) for program in programs(options.program) for dialect in options.dialect or [""]]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        found = list(pool.map(lambda job: compare(trees, *job), jobs))
    for differences in found:
        print(*differences, sep="\n", end="\n" if differences else "")
    different = sum(map(bool, found))
    print(f"{len(jobs) - different} runs are equal, {different} are not")
    return 1 if different or not jobs else 0


if __name__ == "__main__":
    sys.exit(main())
