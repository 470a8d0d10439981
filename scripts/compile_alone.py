#!/usr/bin/env python3
"""Checks that sources compile by themselves: reads their names from standard input and runs the compiler only for errors, with the
commands of BUILD/compile_commands.json. Usage: compile_alone.py BUILD JOBS"""

import json
import os
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor


def commands_of(build):
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        return {os.path.relpath(entry["file"]): entry for entry in json.load(file)}


def errors(entry):
    words = shlex.split(entry["command"])
    place = words.index("-o")
    del words[place : place + 2]
    ended = subprocess.run([*words, "-fsyntax-only"], cwd=entry["directory"], capture_output=True, text=True)
    return ended.stderr if ended.returncode != 0 else ""


def main():
    build, jobs = sys.argv[1], int(sys.argv[2])
    known = commands_of(build)
    # A source that is not built here (because its library is not installed) has no command.
    names = [name for name in sys.stdin.read().split() if name in known]
    with ThreadPoolExecutor(jobs) as pool:
        found = [text for text in pool.map(lambda name: errors(known[name]), names) if text]
    print(*found, sep="\n", end="")
    print(f"{len(names)} sources by themselves, {len(found)} with errors")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
