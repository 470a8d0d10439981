#!/usr/bin/env python3
"""Tests that pages are read as pages.py describes."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from pages import Command, File, Output, PageError, read_page
from run_commands import PageRun, is_in


def steps(text):
    return read_page("page.md", text)[0]


class ReadPage(unittest.TestCase):
    def test_commands_are_blocks_that_begin_with_one(self):
        found = steps("Text\n\n    gsim run a.nc\n    for f in x; do\n      echo $f\n    done\n\nText\n\n    a = 1\n")
        self.assertEqual([(3, "gsim run a.nc"), (4, "for f in x; do\n  echo $f\ndone")],
                         [(step.line, step.text) for step in found])

    def test_a_command_goes_on_behind_a_backslash(self):
        self.assertEqual(["gsim run \\\n  a.nc"], [step.text for step in steps("    gsim run \\\n      a.nc\n")])

    def test_lua_and_messages_are_no_commands(self):
        self.assertEqual([], steps("    for i = 1, 3 do\n\nText\n\n    gsim-run: no such file\n"))

    def test_blocks_in_lists_and_fences(self):
        found = steps("1.  Text\n\n        gsim run a.nc\n\nText\n\n```sh\ngsim run b.nc\n```\n")
        self.assertEqual(["gsim run a.nc", "gsim run b.nc"], [step.text for step in found])

    def test_indented_lines_of_a_paragraph_are_text(self):
        self.assertEqual([], steps("1.  Text\n    gsim run a.nc\n"))

    def test_comments_in_front_of_blocks(self):
        found = steps("<!-- file: a.nc -->\n\n    G0 X1\n\n    M2\n\n<!-- expect: 0 1 -->\n\n    gsim run a.nc\n    gsim x\n\n"
                      "<!-- output -->\n\n    done\n\n<!-- skip: no time -->\n<!-- prints: 5 s -->\n\n    gsim run\n")
        self.assertEqual(File(3, "a.nc", "G0 X1\n\nM2\n"), found[0])
        self.assertEqual([0, 1], [step.status for step in found[1:3]])
        self.assertEqual(Output(14, "done\n"), found[3])
        self.assertEqual(Command(19, "gsim run", 0, "no time", ("5 s",)), found[4])

    def test_wrong_pages(self):
        for text, message in [
            ("<!-- file: a.nc -->\n\nText\n", "page.md:1: no block follows this comment"),
            ("<!-- skip -->\n\n    gsim run\n", "page.md:1: 'skip' says nothing"),
            ("<!-- expect: 0 1 -->\n\n    gsim run\n", "page.md:3: 1 commands and 2 exit statuses"),
            ("<!-- expect: 1 -->\n\n    G0 X1\n",
             "page.md:3: 'expect' is for commands, and this does not begin with one"),
            ("    M2\n\n    gsim run\n",
             "page.md:3: a command in the middle of something else: put a sentence between them"),
        ]:
            with self.assertRaises(PageError) as raised:
                steps(text)
            self.assertEqual(message, str(raised.exception))

    def test_commands_in_sentences(self):
        self.assertEqual([(1, "gsim run --cell FILE"), (2, "gcode2lua a.nc")],
                         read_page("page.md", "Say `gsim run --cell\nFILE`, `part.nc` or `gcode2lua a.nc`.\n")[1])


class RunPage(unittest.TestCase):
    def failures(self, text):
        with tempfile.TemporaryDirectory() as folder:
            page = PageRun("page.md", pathlib.Path(folder), pathlib.Path(folder))
            page.take_all(steps(text))
            return page.failures

    def test_what_a_page_says_is_so(self):
        self.assertEqual([], self.failures("<!-- file: f/a -->\n\n    one two\n\n<!-- prints: one two -->\n\n    cat f/a\n\n"
                                           "<!-- output -->\n\n    o... two\n\n<!-- expect: 1 -->\n\n    grep x f/a\n"))

    def test_a_wrong_status_ends_the_page(self):
        self.assertEqual(["page.md:1: exit status 1, expected 0: cat nothing\n    cat: nothing: No such file or directory"],
                         self.failures("    cat nothing\n    cat nothing\n"))

    def test_a_pipe_fails_with_each_of_its_parts(self):
        self.assertEqual(1, len(self.failures("    cat nothing | cat\n")))

    def test_other_output(self):
        self.assertEqual(["page.md:5: the page shows 'two', and the commands before it do not print it\n    one"],
                         self.failures("    echo one\n\n<!-- output -->\n\n    two\n"))
        self.assertEqual(["page.md:3: does not print 'two': echo one\n    one"],
                         self.failures("<!-- prints: two -->\n\n    echo one\n"))

    def test_dots_stand_for_anything(self):
        self.assertTrue(is_in("a ... c", "x\na  b c d\n"))
        self.assertFalse(is_in("a ... c", "c b a\n"))
        self.assertFalse(is_in("a.c", "abc"))


if __name__ == "__main__":
    unittest.main()
