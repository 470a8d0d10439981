#!/usr/bin/env python3
"""Prints docs/services.md, the services of a controller, from the list of services, or checks that file.
Usage: scripts/services.py controller/module/rcs_services.def [docs/services.md]"""

import re
import sys

HEAD = """# Services of a controller

This page lists the services of a controller, which scripts and controller modules use. `make docs`
makes it from `controller/module/rcs_services.def`; the program makes its interfaces from the same
list.

A service returns a status:

- `RRS_SUCCESS` (0);
- a positive status: success with additional information;
- a negative status: an error, after which nothing has changed.

In addition to the statuses in the table any service may return `RRS_NOT_INITIALIZED`,
`RRS_SERVICE_NOT_SUPPORTED` or `RRS_INVALID_PARAMETER` (a number that is not finite or out of its
range). A controller module may also return `RRS_MODULE_FAULT`. Lengths are mm, angles rad, times s;
values of joints are mm or rad.

- Scripts call a service by its name with its inputs, `rrs.SetMotionTime(1.5)`. They get the status,
  then the outputs ([lua_lib/README.md](../lua_lib/README.md#services-of-the-controller-rrs)).
- Controller modules get its opcode with a structure, and fill in another one
  ([controller-modules.md](controller-modules.md)).
- RRS is the service's number in the interface of controllers (RCS) of RRS-1, as public clients of
  it have it. A service without a number is an extension, or is not known there.
"""

ROW = re.compile(
    r"((?:///[^\n]*\n)+)GSIM_RCS_(SERVICE|QUERY)\((\w+),\s*(\w+),\s*(\d+),\s*(\d+),\s*([\w,\s]+?),\s*"
    r"\(([^()]*)\),\s*\(([^()]*)\),\s*\(([^()]*)\)\)")


def parameters(text):
    """Returns the names of the inputs and of the outputs."""
    inputs, outputs = [], []
    for parameter in filter(None, (part.strip() for part in text.split(","))):
        kind, name = parameter.rsplit(" ", 1)
        (outputs if kind.endswith("&") and not kind.startswith("const") else inputs).append(name)
    return inputs, outputs


def codes(names):
    return ", ".join(f"`{name}`" for name in names)


def row(match):
    comment, kind, method, opcode, number, rrs, structures, answers, declared, _ = match.groups()
    meaning = " ".join(line[3:].strip() for line in comment.splitlines()).replace("|", "\\|")
    inputs, outputs = parameters(" ".join(declared.split()))
    structures = [name.strip() for name in structures.split(",")]
    source = structures[0].replace("none", "-")
    result = structures[1] if kind == "QUERY" else "-"
    statuses = [status.strip() for status in answers.split(",") if status.strip()]
    return (f"| `{method}` | {codes(inputs)} | {codes(outputs)} | {codes(statuses)} | {rrs if rrs != '0' else ''} "
            f"| {number} `{opcode}`: {source}, {result} | {meaning} |")


def page(text):
    parts = re.split(r"^// --- (.*?) ---$", text, flags=re.MULTILINE)
    lines, rows = [HEAD], 0
    for title, body in zip(parts[1::2], parts[2::2]):
        lines += [f"## {title}", "", "| service | inputs | outputs | statuses | RRS | opcode: input, output | meaning |",
                  "| --- | --- | --- | --- | ---: | --- | --- |"]
        found = [row(match) for match in ROW.finditer(body)]
        rows += len(found)
        lines += found + [""]
    listed = len(re.findall(r"^GSIM_RCS_(?:SERVICE|QUERY)\(", text, flags=re.MULTILINE))
    if rows != listed:
        sys.exit(f"scripts/services.py: {listed - rows} of {listed} services of the list are in another form than the others")
    return "\n".join(lines)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        made = page(file.read())
    if len(sys.argv) < 3:
        print(made, end="")
        return
    with open(sys.argv[2], encoding="utf-8") as file:
        if file.read() != made:
            sys.exit(f"{sys.argv[2]} differs from the list of services; `make docs` writes it again")


if __name__ == "__main__":
    main()
