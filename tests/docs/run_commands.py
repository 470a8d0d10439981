#!/usr/bin/env python3
"""Runs the commands of the documentation, page by page, each page in a separate folder that has the samples. It also
checks the options of commands in its prose. pages.py has the format of the pages.

Usage: run_commands.py --source FOLDER --programs FOLDER --scratch FOLDER [--keep] [PAGE...]
"""

import argparse
import functools
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys

from pages import Command, File, Output, PageError, read_page

TIMEOUT_S = 600  # for a machine that is slow or busy
SHOWN_LINES = 30
PAGES = ("README.md", "CONTRIBUTING.md", "lua_lib/README.md", "docs/**/*.md")


def run(command, folder, programs):
    """Returns the exit status (None: too slow) and the output."""
    environment = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}", LC_ALL="C.UTF-8")
    process = subprocess.Popen(["bash", "-o", "pipefail", "-c", command], cwd=folder, env=environment, text=True,
                               errors="replace", stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, start_new_session=True)
    try:
        output, _ = process.communicate(timeout=TIMEOUT_S)
        return process.returncode, output
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        return None, process.communicate()[0]


def shown(output):
    lines = output.rstrip("\n").split("\n")
    left_out = len(lines) - SHOWN_LINES
    return "\n".join(["    " + line for line in lines[:SHOWN_LINES]] + ([f"    ... {left_out} lines more"] if left_out > 0 else []))


def single_spaced(text):
    return " ".join(text.split())


def is_in(promised, output):
    """Returns True if a line of the output contains the promised one; '...' stands for anything."""
    parts = [re.escape(single_spaced(part)) for part in promised.split("...")]
    pattern = re.compile(" ?.*".join(parts))
    return any(pattern.search(single_spaced(line)) for line in output.split("\n"))


class PageRun:
    def __init__(self, name, folder, programs):
        self.name = name
        self.folder = folder
        self.programs = programs
        self.output = ""
        self.ran = 0
        self.looked_up = 0
        self.skipped = []
        self.failures = []

    def fail(self, line, what, output=""):
        self.failures.append(f"{self.name}:{line}: {what}\n{shown(output) if output else ''}".rstrip())

    def make_folder(self, source):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        shutil.copytree(source / "samples", self.folder / "samples")
        (self.folder / "build").mkdir()
        (self.folder / "build/bin").symlink_to(self.programs)
        (self.folder / "build/lib").symlink_to(self.programs.parent / "lib")

    def take(self, step):
        if isinstance(step, File):
            path = self.folder / step.name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(step.text)
        elif isinstance(step, Output):
            for line in filter(str.strip, step.text.split("\n")):
                if not is_in(line, self.output):
                    self.fail(step.line, f"the page shows '{line.strip()}', and the commands before it do not print it",
                              self.output)
        elif step.skip:
            self.skipped.append((step.line, step.skip))
        else:
            self.run_command(step)

    def take_all(self, steps):
        """Runs the steps up to the first failure, because later steps usually need the failed one."""
        for step in steps:
            self.take(step)
            if self.failures:
                break

    def run_command(self, command: Command):
        self.ran += 1
        status, self.output = run(command.text, self.folder, self.programs)
        if status is None:
            self.fail(command.line, f"not done within {TIMEOUT_S} s: {command.text}", self.output)
        elif status != command.status:
            self.fail(command.line, f"exit status {status}, expected {command.status}: {command.text}", self.output)
        for text in command.prints:
            if single_spaced(text) not in single_spaced(self.output):
                self.fail(command.line, f"does not print '{text}': {command.text}", self.output)

    def look_up(self, line, text):
        """Checks a command in prose. It may lack arguments, but the options that it has must exist."""
        self.looked_up += 1
        for part in text.split("|"):
            words = part.split()
            options = {word for word in words if re.fullmatch(r"--[a-z][a-z-]*", word)}
            unknown = options - options_of(" ".join(program_words(words)), self.programs)
            if unknown:
                self.fail(line, f"{words[0]} has no option {', '.join(sorted(unknown))}")


def program_words(words):
    """Returns the words that name the program: 'gsim run', 'gcode2lua'."""
    program = os.path.basename(words[0])
    return [program, words[1]] if program == "gsim" and len(words) > 1 and words[1].isalpha() else [program]


@functools.lru_cache(maxsize=None)
def options_of(program, programs):
    text = run(f"{program} --help", ".", programs)[1]
    commands = re.search(r"^Commands:\n((?:  .*\n)+)", text, re.MULTILINE)
    for name in re.findall(r"^  (\S+)", commands.group(1), re.MULTILINE) if commands else []:
        text += run(f"{program} {'FILE ' if program == 'gsim-data' else ''}{name} --help", ".", programs)[1]
    return frozenset(re.findall(r"--[a-z][a-z-]*", text))


def run_page(name, arguments):
    page = PageRun(name, arguments.scratch / name.replace("/", "_").removesuffix(".md"), arguments.programs)
    try:
        steps, named = read_page(name, (arguments.source / name).read_text())
    except PageError as error:
        page.failures.append(str(error))
        return page
    page.make_folder(arguments.source)
    page.take_all(steps)
    for line, text in named:
        page.look_up(line, text)
    if not page.failures and not arguments.keep:
        shutil.rmtree(page.folder)
    return page


def read_arguments():
    parser = argparse.ArgumentParser()
    for name in ("source", "programs", "scratch"):
        parser.add_argument(f"--{name}", required=True, type=lambda text: pathlib.Path(text).absolute())
    parser.add_argument("--keep", action="store_true", help="leave the folders of pages where all is right, too")
    parser.add_argument("page", nargs="*")
    arguments = parser.parse_args()
    if not (arguments.programs / "gsim").exists():
        parser.error(f"there is no program gsim in {arguments.programs}")
    return arguments


def main():
    arguments = read_arguments()
    names = arguments.page or sorted({str(path.relative_to(arguments.source)) for pattern in PAGES
                                      for path in arguments.source.glob(pattern)})
    if not names:
        sys.exit(f"there are no pages in {arguments.source}")
    pages = []
    for name in names:
        page = run_page(name, arguments)
        pages.append(page)
        print(f"{name}: {page.ran} run, {len(page.skipped)} skipped, {page.looked_up} named", flush=True)
        for line, reason in page.skipped:
            print(f"  skipped {name}:{line}: {reason}")
        for failure in page.failures:
            print(f"FAILED {failure}", flush=True)
    failed = sum(len(page.failures) for page in pages)
    print(f"{sum(page.ran for page in pages)} commands run, {sum(len(page.skipped) for page in pages)} skipped, "
          f"{failed} failures")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
