#!/usr/bin/env python3
"""Counts the words that docs/style.md bans, and fails if one is used more often than scripts/words.txt permits.

Usage: words.py               prints counts above their limits, and the sums
       words.py --list WORD   prints each use of a word, with its file
       words.py --lower       lowers the limits to the counts; never raises one

Names and files count once for each distinct name that has the word; comments, messages and documents count each use."""

import argparse
import os
import re
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# Words of names that stand for a term of docs/glossary.md.
NAME_WORDS = """anew answer answers apart ask asks behind beside choice crowd fault faults foretell guest held kink least led
    leeway look looks meeting mended most night own pace pacer piece pieces place places put puts refusal remedy room sentence sentences
    sheet stance stances stand stands stranger suspect suspects take taken taker takers takes tell tells tip tips told trouble untold wanted
    watch way ways whole why wrong""".split()
# Words of sentences. Most words above are plain English in a sentence.
PROSE_WORDS = """anew behind beside foretell foretold guest leeway mended sentence sentences stance stances stranger strangers tell tells told
    way ways where who whoever whole""".split()
# "Where" and "behind" are for places (docs/style.md): the point where an axis turns, an axis that lags behind.
OF_PLACES = re.compile(r"\b(?:(?:points?|positions?|places?|lines?|locations?|spots?|ends?|edges?|corners?|folders?|files?|side) where"
                       r"|(?:lags?|lagging|material|exit|queued|hidden|tool|robot) behind)\b")
PROSE_PHRASES = ["by lot", "for ever", "in vain", "to and fro"]

CODE = {".cpp": "c", ".h": "c", ".def": "c", ".ts": "c", ".mjs": "c", ".c": "c", ".y": "c", ".l": "c", ".lua": "lua", ".py": "hash",
        ".sh": "hash", ".toml": "hash", ".cmake": "hash"}
# Comments, then texts, of each kind of language. A text of Python that begins a line is a comment.
TOKENS = {
    "c": re.compile(r"""(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<text>R"(\w*)\(.*?\)\3"|"(?:[^"\\\n]|\\.)*"|`(?:[^`\\]|\\.)*`)|'(?:[^'\\\n]|\\.)*'""", re.DOTALL),
    "lua": re.compile(r"""(?P<comment>--\[\[.*?\]\]|--[^\n]*)|(?P<text>"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'|\[\[.*?\]\])""", re.DOTALL),
    "hash": re.compile(r'''(?P<comment>^\s*""".*?"""|(?<![\w$&{])\#[^\n]*)|(?P<text>"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*')''', re.DOTALL | re.MULTILINE),
}
IDENTIFIER = re.compile(r"[A-Za-z_]\w*")
PART = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")
WORD = re.compile(r"[a-z']+")
BLOCK_OF_CODE = re.compile(r"^```.*?^```|^(?: {4}|\t)[^\n]*|`[^`\n]*`|\]\([^)\n]*\)", re.DOTALL | re.MULTILINE)
# Pages that name the banned words.
EXEMPT = {"docs/style.md", "docs/glossary.md", "scripts/words.py"}
# Copied from others, generated, or data of other programs.
SKIPPED = re.compile(r"^(tests/(fuzz/corpus|golden|conformance/data|accuracy/data)/|samples/.*\.(nc|ngc)$|debian/)")


def files(root):
    """Our own files by name, without what builds write."""
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(name for name in folders if not name.startswith((".", "build-")) and name not in ("node_modules", "__pycache__")
                            and not (Path(folder) == root and name in ("build", "out")))
        for name in sorted(names):
            file = (Path(folder) / name).relative_to(root).as_posix()
            if file not in EXEMPT and not SKIPPED.match(file):
                yield file


def parts(identifier):
    return [part.lower() for part in PART.findall(identifier)]


def prose_uses(text):
    """The banned words and phrases of a text, each as often as it occurs."""
    lower = OF_PLACES.sub(" ", re.sub(r"\s*\n\s*(?://[/!]?<?|\*|#|--)?\s*", " ", text.lower()))
    for word in WORD.findall(lower):
        if word in PROSE_WORDS:
            yield word
    for phrase in PROSE_PHRASES:
        yield from [phrase] * len(re.findall(r"\b" + phrase.replace(" ", r"\s+") + r"\b", lower))


def uses_in_code(name, text, language):
    """Triples (area, banned word, the name that has it, or its file)."""
    messages = "messages" if not name.startswith("tests/") else None
    rest = []
    end = 0
    for token in TOKENS[language].finditer(text):
        rest.append(text[end:token.start()])
        end = token.end()
        area = "comments" if token["comment"] else messages
        if area and (token["comment"] or token["text"]):
            for word in prose_uses(token.group()):
                yield area, word, name
    rest.append(text[end:])
    for identifier in set(IDENTIFIER.findall(" ".join(rest))):
        for word in set(parts(identifier)) & set(NAME_WORDS):
            yield "names", word, identifier


def uses(root):
    """Each use: (area, banned word, the name that has it, or its file; its file)."""
    for name in files(root):
        path = root / name
        for step in {step for part in Path(name).parts for step in parts(part)} & set(NAME_WORDS):
            yield "files", step, name, name
        if path.suffix == ".md":
            for word in prose_uses(BLOCK_OF_CODE.sub(" ", path.read_text(encoding="utf-8"))):
                yield "documents", word, name, name
        elif path.suffix in CODE:
            for area, word, holder in uses_in_code(name, path.read_text(encoding="utf-8", errors="replace"), CODE[path.suffix]):
                yield area, word, holder, name


def read_limits(path):
    """(limits by (area, word), allowed names)."""
    limits, allowed = {}, set()
    for line in path.read_text(encoding="utf-8").splitlines():
        words = line.split("#")[0].split()
        if not words:
            continue
        if words[0] == "allow":
            allowed.add(words[1])
        else:
            limits[words[0], " ".join(words[1:-1])] = int(words[-1])
    return limits, allowed


def count(root, allowed):
    """The uses of each (area, word), as pairs (holder, file)."""
    found = defaultdict(list)
    for area, word, holder, name in uses(root):
        if holder not in allowed:
            found[area, word].append((holder, name))
    return found


def size(key, pairs):
    """Distinct names, all other uses one by one."""
    return len({holder for holder, _ in pairs}) if key[0] == "names" else len(pairs)


def write_limits(path, sizes, limits):
    head = [line for line in path.read_text(encoding="utf-8").splitlines() if not re.match(r"(names|files|comments|messages|documents) ", line)]
    kept = {key: min(sizes[key], limits.get(key, 0)) for key in sizes}
    rows = [f"{area} {word} {number}" for (area, word), number in sorted(kept.items()) if number]
    path.write_text("\n".join(head + rows) + "\n", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", metavar="WORD")
    parser.add_argument("--lower", action="store_true")
    options = parser.parse_args()
    path = ROOT / "scripts/words.txt"
    limits, allowed = read_limits(path)
    found = count(ROOT, allowed)
    if options.list:
        for (area, word), pairs in sorted(found.items()):
            if word == options.list:
                print(*(f"{area}: {holder} {name if name != holder else ''}".rstrip() for holder, name in sorted(pairs)), sep="\n")
        return 0
    sizes = {key: size(key, pairs) for key, pairs in found.items()}
    above = {key: number for key, number in sizes.items() if number > limits.get(key, 0)}
    for (area, word), number in sorted(above.items()):
        print(f"{area}: '{word}' {number} times, at most {limits.get((area, word), 0)} are permitted; scripts/words.py --list '{word}'",
              file=sys.stderr)
    sums = defaultdict(int)
    for (area, _), number in sizes.items():
        sums[area] += number
    print(", ".join(f"{area} {number}" for area, number in sorted(sums.items())))
    if options.lower:
        write_limits(path, sizes, limits)
    return 1 if above else 0


if __name__ == "__main__":
    sys.exit(main())
