"""Compares two versions of a source (C++, flex, Bison, Lua) as a compiler sees them: names, comments and layout may differ.

The words of messages may differ: two texts of several words each are equal if they have the same values in the same order. A file in which
only words of messages changed compiles as before; tests and the table of messages (scripts/messages.py) check the words.

Two versions are the same if one becomes the other by renaming: each name of the first has one name in the second, no two names share one, and everything else
is equal, token by token. Renamings that a list declares need not be one-to-one, because they follow scopes, which this module does not know.
A renamed source is built and tested as every other one; only checks that take hours are not repeated for it."""

import re

INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
STRING = r'"(?:[^"\\\n]|\\.)*"'
# A directive of the preprocessor ends with its line, so its end is a token. Marks for clang-tidy in a comment are part of the source.
C_TOKENS = re.compile(
    rf"""(?P<mark>//\s*NOLINT[^\n]*)|(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<raw>R"(\w*)\(.*?\)\4")|(?P<text>{STRING}(?:\s*{STRING})*)"""
    r"""|'(?:[^'\\\n]|\\.)+'|(?P<directive>^[ \t]*\#(?:[^\n\\]|\\.)*)|(?P<number>\.?\d(?:[\w.]|'\d|[eEpP][+-])*)|(?P<name>[A-Za-z_]\w*)|\S""",
    re.DOTALL | re.MULTILINE)
LUA_TOKENS = re.compile(
    rf"""(?P<comment>--\[\[.*?\]\]|--[^\n]*)|(?P<raw>\[\[.*?\]\])|(?P<text>{STRING})|'(?:[^'\\\n]|\\.)*'"""
    r"""|(?P<number>\.?\d[\w.]*)|(?P<name>[A-Za-z_]\w*)|\S""", re.DOTALL)
NO_CODE = re.compile(rf"//[^\n]*|/\*.*?\*/|{STRING}|^--[^\n]*", re.DOTALL | re.MULTILINE)
NAME = re.compile(r"[A-Za-z_]\w*")
# The values in a message, and the ends of its lines.
VALUES = re.compile(r"\{\{|\}\}|\{[^{}]*\}|%[-+0#]*\d*(?:\.\d+)?[a-zA-Z%]|\\n")
MESSAGE = re.compile(r"[A-Za-z']+[,;:]? [A-Za-z']+")


def names_of(text):
    """Returns the names in a source, without the words of its comments and texts."""
    return NAME.findall(NO_CODE.sub(" ", text))


def words_removed(text):
    """Returns a message without its words, and any other text unchanged."""
    return '"message ' + " ".join(VALUES.findall(text)) + '"' if MESSAGE.search(text) else text


def tokens_of(text, is_lua):
    """Returns pairs (is a name, text of the token)."""
    for token in (LUA_TOKENS if is_lua else C_TOKENS).finditer(text):
        kind = token.lastgroup
        if kind == "comment":
            continue
        if kind == "text":
            yield False, words_removed("".join(re.findall(STRING, token.group())).replace('""', ""))
        elif kind == "directive":
            yield False, "#"
            yield from tokens_of(token.group().lstrip()[1:].replace("\\\n", " "), is_lua)
            yield False, "end of #"
        else:
            yield kind == "name", token.group()


def essence(text, is_lua, old_headers):
    """Returns the headers that a source includes, by their names before a move (a formatter sorts them), and its other tokens."""
    headers = sorted(old_headers.get(header, header) for header in INCLUDE.findall(text))
    return headers, list(tokens_of(INCLUDE.sub("", text), is_lua))


def changed_names(before, after):
    """Returns the pairs of different names at the same position of both lists, or None if anything else differs."""
    if len(before) != len(after):
        return None
    pairs = set()
    for (is_name, old), (is_new_name, new) in zip(before, after):
        if is_name != is_new_name or (not is_name and old != new):
            return None
        if old != new:
            pairs.add((old, new))
    return pairs


def is_one_to_one(pairs, kept):
    """Returns True if no name has two new ones, no two names have the same new one, and no new name is one that the source keeps."""
    return len({old for old, _ in pairs}) == len({new for _, new in pairs} - kept) == len(pairs)


def is_same(before, after, is_lua, old_headers, names, renamings):
    """Returns True if two texts of a source differ only in names, comments, layout and moved headers. `names`: all current names of the
    project. An old name that is still among them was not renamed, but replaced by another name. `renamings`: pairs that were renamed
    nevertheless, because the name had several meanings."""
    (headers, tokens), (new_headers, new_tokens) = essence(before, is_lua, {}), essence(after, is_lua, old_headers)
    pairs = changed_names(tokens, new_tokens)
    if headers != new_headers or pairs is None:
        return False
    kept = {old for (is_name, old), (_, new) in zip(tokens, new_tokens) if is_name and old == new}
    undeclared = pairs - renamings
    return is_one_to_one(undeclared, kept) and not any(old in names for old, _ in undeclared)
