#!/usr/bin/env python3
"""Prints the sources that take the most CPU time to compile, each compiled by itself, as a Markdown table.

The commands are those of BUILD/compile_commands.json, from a configuration without unity builds:
    cmake --preset release -B build-alone -DGSIM_BATCHES=OFF -DGSIM_PRECOMPILE=ON && make -C build-alone generated gsim_precompiled
Usage: compile-times.py BUILD [COUNT [FOLDER ...]]   COUNT rows (30), of sources in these folders only
"""

import json
import os
import resource
import shlex
import subprocess
import sys


def commands_of(build):
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        return {os.path.relpath(entry["file"]): entry for entry in json.load(file)}


def compile_cpu_s(entry):
    """Returns the CPU seconds of one compilation, None if it fails. The object file is discarded."""
    words = shlex.split(entry["command"])
    words[words.index("-o") + 1] = os.devnull
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, cwd=entry["directory"], capture_output=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        return None
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    build = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 30
    folders = tuple(folder.rstrip("/") + "/" for folder in sys.argv[3:])
    rows = []
    for name, entry in sorted(commands_of(build).items()):
        if name.startswith(("..", "/", build)) or (folders and not name.startswith(folders)):
            continue
        cpu_s = compile_cpu_s(entry)
        if cpu_s is None:
            print(f"not compiled: {name}", file=sys.stderr)
        else:
            rows.append((cpu_s, name))
    rows.sort(reverse=True)
    print(f"{len(rows)} sources, {sum(row[0] for row in rows):.0f} CPU s, median {sorted(rows)[len(rows) // 2][0]:.2f} s\n")
    print("| source | CPU s |\n| --- | ---: |")
    for cpu_s, name in rows[:count]:
        print(f"| `{name}` | {cpu_s:.1f} |")


if __name__ == "__main__":
    main()
