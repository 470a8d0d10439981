#!/usr/bin/env python3
"""Compares the messages of the product with tests/messages/messages.txt, the one place in tests that has their wording.

All other tests ask for codes and values, so a change of wording changes this table alone, and is reviewed there as text.

Usage: messages.py           prints the differences from the table, and fails if there are any
       messages.py --renew   writes the table"""

import difflib
import re
import sys

import modules
from words import CODE, ROOT, TOKENS

TABLE = ROOT / "tests/messages/messages.txt"
HEAD = "# The messages of gsim by module, as its sources have them (scripts/messages.py --renew).\n"
# A message has three words or more, two of them without capitals; code has none of that between blanks.
WORD = re.compile(r"(?<![\w#.<{/=-])[a-z][a-z']+(?![\w(=:.]\w)")
ANY_WORD = re.compile(r"[A-Za-z][a-z']+")


def is_message(text):
    return len(WORD.findall(text)) >= 2 and len(ANY_WORD.findall(text)) >= 3 and "\n" not in text


def messages_of(text, language):
    """Returns the messages of a source; adjacent literals of C++ are one text."""
    run, end = "", None
    for token in TOKENS[language].finditer(text):
        if not token["text"] or token["text"].startswith(("R\"", "[[")):
            continue
        body = token["text"][1:-1]
        if language == "c" and end is not None and text[end:token.start()].isspace():
            run += body
        else:
            yield run
            run = body
        end = token.end()
    yield run


def table():
    lines = set()
    for folder in modules.top_level_folders(modules.rows((ROOT / modules.PAGE).read_text(encoding="utf-8"))):
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in (".cpp", ".h", ".def", ".l", ".y", ".lua"):
                module = path.parent.relative_to(ROOT).as_posix()
                text = path.read_text(encoding="utf-8", errors="replace")
                lines.update(f"{module}: {message}" for message in messages_of(text, CODE[path.suffix]) if is_message(message))
    return HEAD + "\n".join(sorted(lines)) + "\n"


def main():
    now = table()
    if "--renew" in sys.argv[1:]:
        TABLE.write_text(now, encoding="utf-8")
        return 0
    before = TABLE.read_text(encoding="utf-8")
    sys.stdout.writelines(difflib.unified_diff(before.splitlines(True), now.splitlines(True), "tests/messages/messages.txt", "sources", n=0))
    if now != before:
        print("messages have changed: read the new ones, then run scripts/messages.py --renew")
    return now != before


if __name__ == "__main__":
    sys.exit(main())
