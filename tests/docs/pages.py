"""Reads the steps of a page of the documentation: its commands, the files that it shows, the output that it promises.

A comment before a block has information that the block itself cannot have. Readers do not see it:

    <!-- file: cell.toml -->        the block is this file
    <!-- expect: 1 -->              the exit status of the block's commands, or one for each ('0 1')
    <!-- skip: why -->              its commands are not run
    <!-- prints: 71.2 s -->         what the block's commands print has this in it
    <!-- output -->                 the block is what the commands before it print: '...' stands for anything
"""

import re
import subprocess
import textwrap
from dataclasses import dataclass, field

PROGRAMS = ("gsim", "gsim-run", "gsim-check", "gcode2lua", "autopath", "path2gcode", "gsim-data", "gsim-batch", "gsim-optimise")
TOOLS = ("apt-get", "awk", "cat", "cd", "cmake", "cp", "ctest", "diff", "docker", "echo", "git", "grep", "head", "jq",
         "make", "man", "mkdir", "python3", "sed", "sort", "sudo", "tail")
FOLDERS = ("./", "bench/", "build/", "scripts/")

DIRECTIVE = re.compile(r"^\s*<!-- (file|expect|skip|prints|output)(?:: (.+?))? -->\s*$")
FENCE = re.compile(r"^\s*(```|~~~)")
ASSIGNMENT = re.compile(r"^\w+=\S*$")
SPAN = re.compile(r"(?<!`)`([^`]+)`(?!`)")


class PageError(Exception):
    """A page with an error; the text has its source location and the reason."""


@dataclass
class Block:
    line: int
    text: str
    directives: dict = field(default_factory=dict)


@dataclass
class Command:
    line: int
    text: str
    status: int = 0
    skip: str = ""
    prints: tuple = ()


@dataclass
class File:
    line: int
    name: str
    text: str


@dataclass
class Output:
    line: int
    text: str


def is_command(line):
    """Returns True if a line of a block begins like a command."""
    words = line.split()
    while words and ASSIGNMENT.match(words[0]):
        words.pop(0)
    if not words:
        return False
    if words[0] == "for":  # Lua has `for`, too
        return len(words) > 2 and words[2] == "in"
    return words[0] in PROGRAMS + TOOLS or words[0].startswith(FOLDERS)


def is_program(line):
    words = line.split()
    return bool(words) and (words[0] in PROGRAMS or words[0].startswith("build/bin/"))


class Reader:
    """Splits a page into blocks and prose."""

    def __init__(self, name, text):
        self.name = name
        self.lines = text.split("\n")
        self.at = 0
        self.blocks = []
        self.prose = []
        self.directives = {}
        self.directive_line = 0

    def fail(self, line, message):
        raise PageError(f"{self.name}:{line}: {message}")

    def read(self):
        blank_before = True
        while self.at < len(self.lines):
            line = self.lines[self.at]
            if FENCE.match(line):
                self.read_fenced()
                blank_before = True
            elif blank_before and line.startswith("    ") and line.strip() and not DIRECTIVE.match(line):
                self.read_indented()
            else:
                blank_before = self.read_prose(line)
                self.at += 1
        self.expect_no_directives()
        return self

    def read_prose(self, line):
        """Returns True if an indented line after this one begins a block."""
        found = DIRECTIVE.match(line)
        if found:
            self.add_directive(found.group(1), found.group(2) or "")
            return True
        if line.strip():
            self.expect_no_directives()
            self.prose.append((self.at + 1, line))
            return False
        self.prose.append((self.at + 1, ""))
        return True

    def add_directive(self, kind, value):
        self.directive_line = self.at + 1
        if (kind == "output") == bool(value):
            self.fail(self.at + 1, f"'{kind}' {'takes no value' if value else 'says nothing'}")
        if kind == "prints":
            self.directives.setdefault(kind, []).append(value)
        elif kind in self.directives:
            self.fail(self.at + 1, f"'{kind}' stands twice before one block")
        else:
            self.directives[kind] = value

    def expect_no_directives(self):
        if self.directives:
            self.fail(self.directive_line, "no block follows this comment")

    def read_fenced(self):
        first = self.at + 1
        mark = FENCE.match(self.lines[self.at]).group(1)
        self.at += 1
        content = []
        while self.at < len(self.lines) and not self.lines[self.at].strip().startswith(mark):
            content.append(self.lines[self.at])
            self.at += 1
        self.at += 1
        self.add_block(first + 1, content)

    def read_indented(self):
        first = self.at + 1
        content = []
        while self.at < len(self.lines):
            line = self.lines[self.at]
            if line.strip() and not line.startswith("    ") or DIRECTIVE.match(line):
                break
            content.append(line)
            self.at += 1
        self.add_block(first, content)

    def add_block(self, line, content):
        text = textwrap.dedent("\n".join(content)).strip("\n") + "\n"
        self.blocks.append(Block(line, text, self.directives))
        self.directives = {}


def split_commands(text):
    """Returns pairs of an offset in lines and a command, which may continue over several lines."""
    commands = []
    pending = []
    for offset, line in enumerate(text.split("\n")):
        if not pending and not line.strip():
            continue
        pending.append(line)
        whole = "\n".join(pending)
        if line.endswith("\\") or subprocess.run(["bash", "-n", "-c", whole], capture_output=True).returncode != 0:
            continue
        commands.append((offset - len(pending) + 1, whole))
        pending = []
    if pending:
        commands.append((0, "\n".join(pending)))
    return commands


def steps_of_commands(reader, block):
    found = split_commands(block.text)
    statuses = [int(word) for word in block.directives.get("expect", "0").split()]
    if len(statuses) == 1:
        statuses *= len(found)
    if len(statuses) != len(found):
        reader.fail(block.line, f"{len(found)} commands and {len(statuses)} exit statuses")
    prints = block.directives.get("prints", [])
    return [
        Command(block.line + offset, command, status, block.directives.get("skip", ""),
                tuple(prints) if offset == found[-1][0] else ())
        for (offset, command), status in zip(found, statuses)
    ]


def steps_of(reader, block):
    lines = block.text.split("\n")
    if "file" in block.directives:
        return [File(block.line, block.directives["file"], block.text)]
    if "output" in block.directives:
        return [Output(block.line, block.text)]
    if is_command(lines[0]):
        return steps_of_commands(reader, block)
    if block.directives:
        reader.fail(block.line, f"'{next(iter(block.directives))}' is for commands, and this does not begin with one")
    for offset, line in enumerate(lines):
        if is_program(line):
            reader.fail(block.line + offset, "a command in the middle of something else: put a sentence between them")
    return []


def read_page(name, text):
    """Returns the steps of a page in order, and the commands in its prose as (line, text)."""
    reader = Reader(name, text).read()
    steps = [step for block in reader.blocks for step in steps_of(reader, block)]
    return steps, named_commands(reader.prose)


def named_commands(prose):
    named = []
    text = "\n".join(line for _, line in prose)
    for found in SPAN.finditer(text):
        span = found.group(1).replace("\n", " ")
        if "\n\n" not in found.group(1) and is_program(span):
            named.append((prose[text.count("\n", 0, found.start())][0], span))
    return named
