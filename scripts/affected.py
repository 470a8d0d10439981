#!/usr/bin/env python3
"""Prints what a change can break: the differences between the working tree and a commit, and the sources that include them.

Usage: affected.py files SINCE      the files that changed, new ones included and deleted ones too
       affected.py changed SINCE    the C++ sources that changed
       affected.py sources SINCE    the C++ sources that changed, and those that include a header that has lost a name or an include
       affected.py headers SINCE    one C++ source for each header that changed, so that the header is checked once
       affected.py tests SINCE      the folders of tests (tests/NAME) of the modules with changed sources, and of those that include them
       affected.py readers SINCE    the fuzz targets of the readers in the modules with changed sources

SINCE `all`: everything. A source has not changed if only its folder, names, comments or layout differ (scripts/same_source.py)."""

import functools
import re
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # no compiled Python among the sources
import modules
import same_source
from same_source import INCLUDE

# Build files are not sources: a source that is added to a list has changed itself.
SOURCE = re.compile(r".*\.(cpp|h|def|l|y|lua)")


def git(*words):
    return subprocess.run(["git", *words], check=True, capture_output=True, text=True).stdout.splitlines()


def tracked(*patterns):
    return [name for name in git("ls-files", "--cached", "--others", "--exclude-standard", "--", *patterns) if Path(name).exists()]


@functools.cache
def names():
    """Returns all names in the sources of the working tree."""
    return frozenset(name for file in tracked("*.cpp", "*.h", "*.def", "*.l", "*.y", "*.lua", "*.c")
                     for name in same_source.names_of(Path(file).read_text(encoding="utf-8", errors="replace")))


@functools.cache
def renamings():
    """Returns the pairs of .ci/renames: names that changed since the commit in .ci/accepted, although other things keep the old name."""
    path = Path(".ci/renames")
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    return frozenset(tuple(line.split()) for line in lines if line and not line.startswith("#"))


def text_at(since, name):
    """Returns the text of a file at a commit, or None if there was no file of this name."""
    shown = subprocess.run(["git", "show", f"{since}:{name}"], capture_output=True, text=True)
    return shown.stdout if shown.returncode == 0 else None


def is_same_source(since, before, after, old_names):
    if not SOURCE.fullmatch(after) or not Path(after).exists():
        return False
    old = text_at(since, before)
    return same_source.is_same(old, Path(after).read_text(encoding="utf-8"), after.endswith(".lua"), old_names, names(), renamings())


def changed_files(since):
    """Returns the names of all files that differ, deleted ones too."""
    if since == "all":
        return tracked()
    found = set(git("ls-files", "--others", "--exclude-standard"))
    rows = [line.split("\t") for line in git("diff", "--name-status", "--find-renames=5%", "-l0", since, "--")]
    old_names = {names[1]: names[0] for status, *names in rows if status[0] == "R"}
    for status, *names in rows:
        if status[0] in "MR" and is_same_source(since, names[0], names[-1], old_names):
            continue
        found.update(names)
    return sorted(found)


def includes():
    """Returns which of our files each of our C++ files includes, by name."""
    return {name: set(INCLUDE.findall(Path(name).read_text(encoding="utf-8"))) for name in tracked("*.cpp", "*.h")}


def including(headers, graph):
    return {name for name, used in graph.items() if used & headers}


def lost_something(since, header):
    """Returns True if a header has lost a name or an include. Sources that include it may miss one only then: batches compile all else.
    A header that moved may have lost some, too."""
    before = text_at(since, header)
    if before is None or not Path(header).exists():
        return True
    after = Path(header).read_text(encoding="utf-8")
    return any(set(found(before)) - set(found(after)) for found in (same_source.names_of, INCLUDE.findall))


def changed_sources(since):
    graph = includes()
    changed = set(changed_files(since))
    headers = {name for name in changed if since == "all" or (name.endswith(".h") and lost_something(since, name))}
    return sorted(name for name in (changed & set(graph)) | including(headers, graph) if name.endswith(".cpp"))


def one_for_each_header(since):
    graph = includes()
    found = set()
    for header in changed_files(since):
        users = sorted(name for name in including({header}, graph) if name.endswith(".cpp") and not name.startswith("tests/"))
        found.update(users[:1])
    return sorted(found)


def folder(name):
    return str(Path(name).parent)


def module_of(name):
    """Returns the module of a source in the table of docs/architecture.md, or its folder if it is in none, such as a test."""
    return modules.module_of(name, module_names()) or folder(name)


@functools.cache
def module_names():
    page = Path(modules.PAGE)
    return tuple(modules.rows(page.read_text(encoding="utf-8"))) if page.exists() else ()


def headers_of(changed, graph):
    """Returns the headers through which changes reach others: those that changed, that include one, or that belong to changed sources."""
    headers = {name for name in changed if not name.endswith(".cpp")} | {str(Path(name).with_suffix(".h")) for name in changed if name.endswith(".cpp")}
    while more := {name for name in including(headers, graph) if name.endswith(".h")} - headers:
        headers |= more
    return headers


def affected_folders(since):
    """Returns modules with changed sources, and those with a source that includes a header of one."""
    graph = includes()
    changed = {name for name in changed_files(since) if SOURCE.fullmatch(name)}
    return {module_of(name) for name in changed | including(headers_of(changed, graph), graph)}


def test_folders():
    return sorted(folder(name) for name in tracked("tests/**/CMakeLists.txt") if name != "tests/CMakeLists.txt")


def tests_of(folders):
    """Returns the tests of folders: those of the same name below tests/, or of the parent; if there are none, those that include it."""
    known = test_folders()
    found = set()
    uses = {test: {module_of(header) for name in tracked(f"{test}/*.cpp", f"{test}/*.h") for header in INCLUDE.findall(Path(name).read_text(encoding="utf-8"))}
            for test in known}
    for one in folders:
        own = [test for test in known if f"{one}/".startswith((f"{test}/", f"{test.removeprefix('tests/')}/"))]
        found.update([max(own, key=len)] if own else [test for test in known if one in uses[test]])
    return sorted(found)


def readers_of(folders, is_all):
    """Returns targets whose check includes a header of these folders, or is in them (tests/fuzz/targets.cpp names the check of each)."""
    targets = re.findall(r'Target\{"(\w+)", "\w+", (\w+)', Path("tests/fuzz/targets.cpp").read_text(encoding="utf-8"))
    found = []
    for check in tracked("tests/fuzz/check_*.cpp"):
        text = Path(check).read_text(encoding="utf-8")
        used = {module_of(header) for header in INCLUDE.findall(text) if not header.startswith("tests/")} | {check}
        if is_all or used & folders:
            found += [name for name, function in targets if re.search(rf"^Outcome {function}\(", text, re.MULTILINE)]
    return sorted(found)


def main():
    what, since = sys.argv[1:]
    if what == "files":
        found = changed_files(since)
    elif what == "changed":
        found = [name for name in changed_files(since) if name.endswith(".cpp") and Path(name).exists()]
    elif what == "sources":
        found = changed_sources(since)
    elif what == "headers":
        found = one_for_each_header(since)
    elif what == "tests":
        found = test_folders() if since == "all" else tests_of(affected_folders(since))
    elif what == "readers":
        files = [name for name in changed_files(since) if SOURCE.fullmatch(name)]
        changed = {module_of(name) for name in files} | {name for name in files if name.startswith("tests/fuzz/check_")}
        found = readers_of(changed, since == "all")
    else:
        sys.exit(__doc__)
    print(*found, sep="\n", end="\n" if found else "")


if __name__ == "__main__":
    main()
