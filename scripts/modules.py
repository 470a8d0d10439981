#!/usr/bin/env python3
"""Compares each #include with the table of modules in docs/architecture.md: the row of a module lists exactly the modules that it includes.
The table is in order of dependency, from the base up: a module uses none below its own row. Top-level folders do not include each other,
and no folder of sources has more than 50 files.
Usage: modules.py             checks the table
       modules.py --print     the rows as the sources have them
       modules.py --folders   the top-level folders of the table, as a regular expression: 'base|lexer|...'"""

import re
import sys
from collections import defaultdict
from pathlib import Path

HERE = Path(__file__).resolve().parent.parent
PAGE = "docs/architecture.md"
HEADING = "## Modules"
LARGEST_FOLDER = 50
FREE = ("tests/", "bench/", "samples/", "docs/")  # may include every module
EVERYBODYS = ("base/bits.h", "base/error.h", "base/plane.h", "base/units.h")

# All sources include nlohmann-json through this header.
JSON_HEADER = "base/text/json.h"

# The module of a generated header, by the beginning or end of its name.
EXTERNAL = (
    (r"fmt/.*", "fmt"), (r"fast_float/.*", "fast_float"), (r"Eigen/.*", "Eigen"), (r"tl/.*", "tl-expected"), (r"toml\+\+/.*", "toml++"), (r"nlohmann/.*", "nlohmann-json"),
    (r"lua\.hpp", "Lua"), (r"pugixml\.hpp", "pugixml"), (r"CLI/.*", "CLI11"), (r"ceres/.*", "Ceres"), (r".*\.hxx", "OpenCASCADE"),
    (r"boost/.*", "Boost"), (r"sqlite3\.h", "SQLite"), (r"openssl/.*", "OpenSSL"), (r"zlib\.h", "zlib"), (r"httplib\.h", "cpp-httplib"), (r"emscripten\.h", "emscripten"),
    (r"std(int|def)\.h", ""), (r"[a-z_/]+\.h", "POSIX"), (r"[a-z_]+", ""))


def rows(page):
    """Returns the modules of the table, with those that they may use."""
    text = page.split(HEADING + "\n", 1)[1].split("\n## ", 1)[0]
    table = {}
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 3 and (name := re.fullmatch(r"`([a-z0-9_/]+)/`", cells[0])):
            table[name[1]] = [use.strip().strip("`").rstrip("/") for use in cells[2].split(",") if use.strip()]
    return table


def module_of(file, modules):
    inside = [module for module in modules if file.startswith(module + "/")]
    return max(inside, key=len, default=None)


def maker_of(header):
    return next((maker for pattern, maker in EXTERNAL if re.fullmatch(pattern, header)), header)


def sources(root):
    for folder in sorted(root.iterdir()):
        if folder.is_dir() and not folder.name.startswith((".", "build")) and folder.name + "/" not in FREE:
            yield from sorted(file for file in folder.rglob("*")
                              if file.suffix in (".cpp", ".h", ".l", ".y") and "node_modules" not in file.parts)


def uses(root, modules):
    """Returns the modules that each module includes, with the first source location; and sources that are in no module."""
    used, homeless = defaultdict(dict), []
    for path in sources(root):
        file = path.relative_to(root).as_posix()
        module = module_of(file, modules)
        if module is None:
            if file not in EVERYBODYS:
                homeless.append(file)
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if not (include := re.match(r'\s*#\s*include\s*([<"])([^>"]+)', line)):
                continue
            ours = include[1] == '"'
            use = module_of(include[2], modules) if ours else maker_of(include[2])
            if use and use != module:
                used[module].setdefault(use, f"{file}:{number}")
            if include[2] == JSON_HEADER:
                used[module].setdefault("nlohmann-json", f"{file}:{number}")
    return used, homeless


def faults(table, used, homeless):
    order = list(table)
    for file in homeless:
        yield f"{file}: its folder has no row in the table of modules"
    for module, allowed in table.items():
        for use, where in used[module].items():
            if use not in allowed:
                yield f"{where}: {module}/ uses {use}, which its row does not say"
            elif use in table and order.index(use) > order.index(module):
                yield f"{where}: {module}/ uses {use}/, which stands below it in the table"
        for use in allowed:
            if use not in used[module]:
                yield f"{PAGE}: {module}/ may use {use}, and nothing there does"


def top_level_circles(used):
    """Returns pairs of top-level folders that include each other, with a file for each direction."""
    uses_of = defaultdict(dict)
    for module, included in used.items():
        for use, place in included.items():
            if use in used and use.split("/")[0] != module.split("/")[0]:
                uses_of[module.split("/")[0]].setdefault(use.split("/")[0], place)
    for folder, others in sorted(uses_of.items()):
        for other in sorted(others):
            if folder < other and folder in uses_of.get(other, {}):
                yield f"{others[other]}: {folder}/ and {other}/ include each other ({uses_of[other][folder]})"


def large_folders(root):
    """Returns folders with too many files for a reader, except data of tests and samples."""
    for folder in sorted({file.parent for file in sources(root)} | {file.parent for file in (root / "lua_lib").rglob("*.lua")}):
        count = sum(1 for file in folder.iterdir() if file.is_file())
        if count > LARGEST_FOLDER:
            yield f"{folder.relative_to(root).as_posix()}/ has {count} files; {LARGEST_FOLDER} are permitted, so divide it"


def top_level_folders(table):
    return list(dict.fromkeys(module.split("/")[0] for module in table))


def main():
    table = rows((HERE / PAGE).read_text(encoding="utf-8"))
    if "--folders" in sys.argv:
        print("|".join(top_level_folders(table)))
        return 0
    used, homeless = uses(HERE, table)
    if "--print" in sys.argv:
        for module in table:
            ours = [f"`{use}/`" for use in table if use in used[module]]
            others = sorted((use for use in used[module] if use not in table), key=str.lower)
            print(f"{module}: {', '.join(ours + others)}")
    found = [*faults(table, used, homeless), *top_level_circles(used), *large_folders(HERE)]
    print("\n".join(found) if found else f"{len(table)} modules use what the table says")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
