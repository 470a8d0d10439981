#!/usr/bin/env python3
"""Prints docs/services.md, the services of a controller, from the list that they are made of; or checks it.
Usage: scripts/services.py controller/module/rcs_services.def [docs/services.md]"""

import re
import sys

HEAD = """# Services of a controller

Made by `make docs` from `controller/module/rcs_services.def`, of which the program makes its interfaces, too.

A service answers a status: `RRS_SUCCESS` (0), a positive one with news, or a negative one, after which nothing has changed. Beside those of the table any
service may answer `RRS_NOT_INITIALIZED`, `RRS_SERVICE_NOT_SUPPORTED`, `RRS_INVALID_PARAMETER` (a number that is not finite or out of its range) and, of a
controller module, `RRS_MODULE_FAULT`. Lengths are mm, angles rad, times s; values of joints are mm or rad.

Scripts call a service by its name, `rrs.SetMotionTime(1.5)`, with what it takes; they get the status, then what it gives ([lua_lib/README.md](../lua_lib/README.md#services-of-the-controller-rrs)).
Controller modules get its opcode with a structure, and fill one in ([controller-modules.md](controller-modules.md)). RRS: the service's number in the interface of
controllers (RCS) of RRS-1, as public clients of it have them; without one it is an extension, or not known there.
"""

ROW = re.compile(
    r"((?:///[^\n]*\n)+)GSIM_RCS_(SERVICE|QUERY)\((\w+),\s*(\w+),\s*(\d+),\s*(\d+),\s*([\w,\s]+?),\s*"
    r"\(([^()]*)\),\s*\(([^()]*)\),\s*\(([^()]*)\)\)")


def parameters(text):
    """Names of what is taken and of what is given."""
    taken, given = [], []
    for parameter in filter(None, (part.strip() for part in text.split(","))):
        kind, name = parameter.rsplit(" ", 1)
        (given if kind.endswith("&") and not kind.startswith("const") else taken).append(name)
    return taken, given


def codes(names):
    return ", ".join(f"`{name}`" for name in names)


def row(match):
    comment, kind, method, opcode, number, rrs, structures, answers, declared, _ = match.groups()
    meaning = " ".join(line[3:].strip() for line in comment.splitlines()).replace("|", "\\|")
    taken, given = parameters(" ".join(declared.split()))
    structures = [name.strip() for name in structures.split(",")]
    source = structures[0].replace("none", "-")
    result = structures[1] if kind == "QUERY" else "-"
    statuses = [status.strip() for status in answers.split(",") if status.strip()]
    return (f"| `{method}` | {codes(taken)} | {codes(given)} | {codes(statuses)} | {rrs if rrs != '0' else ''} "
            f"| {number} `{opcode}`: {source}, {result} | {meaning} |")


def page(text):
    parts = re.split(r"^// --- (.*?) ---$", text, flags=re.MULTILINE)
    lines, rows = [HEAD], 0
    for title, body in zip(parts[1::2], parts[2::2]):
        lines += [f"## {title}", "", "| service | takes | gives | answers | RRS | opcode: input, output | meaning |",
                  "| --- | --- | --- | --- | ---: | --- | --- |"]
        found = [row(match) for match in ROW.finditer(body)]
        rows += len(found)
        lines += found + [""]
    listed = len(re.findall(r"^GSIM_RCS_(?:SERVICE|QUERY)\(", text, flags=re.MULTILINE))
    if rows != listed:
        sys.exit(f"scripts/services.py: {listed - rows} of {listed} services of the list are in another form than the rest")
    return "\n".join(lines)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        made = page(file.read())
    if len(sys.argv) < 3:
        print(made, end="")
        return
    with open(sys.argv[2], encoding="utf-8") as file:
        if file.read() != made:
            sys.exit(f"{sys.argv[2]} is not what the list of services says; `make docs` writes it anew")


if __name__ == "__main__":
    main()
