#!/usr/bin/env python3
"""Checks that the links of all pages lead to existing files and headings, and that the site has all pages.

Usage: check_links.py FOLDER
"""

import pathlib
import re
import sys

PAGES = ("*.md", "lua_lib/*.md", "bench/*.md", "docs/**/*.md", "tests/**/*.md")
LINK = re.compile(r"\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ (.+?)\s*$", re.MULTILINE)
CODE = re.compile(r"`[^`\n]*`|^    .*$", re.MULTILINE)


def anchor(heading):
    """Returns the anchor of a heading as code hosts and mkdocs make it."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-")


def anchors(page):
    return {anchor(heading) for heading in HEADING.findall(page.read_text())}


def fault(page, target):
    """Returns the error of a link, if there is one."""
    name, _, heading = target.partition("#")
    path = page.parent / name if name else page
    if re.match(r"[a-z]+:", target):
        return ""
    if not path.is_file():
        return "there is no such file"
    return f"there is no heading '{heading}'" if heading and heading not in anchors(path) else ""


def faults(source):
    found = []
    for page in sorted({page for pattern in PAGES for page in source.glob(pattern)}):
        for target in LINK.findall(CODE.sub("", page.read_text())):
            if what := fault(page, target):
                found.append(f"{page.relative_to(source)}: {target}: {what}")
    site = (source / "mkdocs.yml").read_text()
    for page in sorted(source.glob("docs/**/*.md")):
        if f": {page.relative_to(source)}\n" not in site:
            found.append(f"{page.relative_to(source)}: not in mkdocs.yml")
    return found


def main():
    found = faults(pathlib.Path(sys.argv[1]))
    print("\n".join(found + [f"{len(found)} links or pages are wrong"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
