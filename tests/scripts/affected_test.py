#!/usr/bin/env python3
"""Tests which sources and tests a change affects. Usage: affected_test.py SCRIPTS-FOLDER"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop(1))
import affected

SOURCES = {
    "low/a.h": "int a();\n",
    "low/b.h": "int b();\n",
    "low/a.cpp": '#include "low/a.h"\n\nint a() { return 1; }\n',
    "high/c.cpp": '#include "low/a.h"\n#include "low/b.h"\n\nint c() { return a() + b(); }\n',
    "high/d.cpp": "int d() { return 2; }\n",
}


class Affected(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        affected.names.cache_clear()
        affected.renamings.cache_clear()
        for name, text in SOURCES.items():
            self.write(name, text)
        self.git("init", "--quiet")
        self.git("add", ".")
        self.git("-c", "user.name=a", "-c", "user.email=a@example.org", "commit", "--quiet", "-m", "Begin")

    def git(self, *words):
        subprocess.run(["git", *words], check=True, capture_output=True)

    def write(self, name, text):
        path = pathlib.Path(name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def test_a_changed_header_affects_what_includes_it(self):
        self.write("low/b.h", "long b();\n")
        self.assertEqual(["low/b.h"], affected.changed_files("HEAD"))
        self.assertEqual(["high/c.cpp"], affected.changed_sources("HEAD"))

    def test_a_header_that_only_gained_names_affects_no_source_by_itself(self):
        self.write("low/b.h", "int b();\nint e();\n")
        self.assertEqual(["low/b.h"], affected.changed_files("HEAD"))
        self.assertEqual([], affected.changed_sources("HEAD"))
        self.assertEqual(["high/c.cpp"], affected.one_for_each_header("HEAD"))

    def test_a_header_that_lost_an_include_affects_what_includes_it(self):
        self.write("low/b.h", '#include "low/a.h"\nint b();\n')
        self.git("add", ".")
        self.git("-c", "user.name=a", "-c", "user.email=a@example.org", "commit", "--quiet", "-m", "Include")
        self.write("low/b.h", "int b();\n")
        self.assertEqual(["high/c.cpp"], affected.changed_sources("HEAD"))

    def test_a_header_that_moved_and_lost_an_include_affects_what_includes_it(self):
        self.write("low/b.h", '#include "low/a.h"\nint b();\n')
        self.git("add", ".")
        self.git("-c", "user.name=a", "-c", "user.email=a@example.org", "commit", "--quiet", "-m", "Include")
        self.git("mv", "low/b.h", "low/e.h")
        self.write("low/e.h", "int b();\n")
        self.write("high/c.cpp", SOURCES["high/c.cpp"].replace("low/b.h", "low/e.h"))
        self.git("add", ".")
        self.assertIn("high/c.cpp", affected.changed_sources("HEAD"))

    def test_a_source_that_only_moved_has_not_changed(self):
        self.git("mv", "low", "base")
        self.write("base/a.cpp", SOURCES["low/a.cpp"].replace("low/", "base/"))
        self.write("high/c.cpp", '#include "base/b.h"\n#include "base/a.h"\n\nint c() { return a() + b(); }\n')
        self.git("add", ".")
        self.assertEqual([], affected.changed_files("HEAD"))

    def test_a_source_that_moved_and_changed_has_changed(self):
        self.git("mv", "low", "base")
        self.write("base/a.cpp", '#include "base/a.h"\n\nint a() { return 3; }\n')
        self.write("high/c.cpp", SOURCES["high/c.cpp"].replace("low/", "base/"))
        self.git("add", ".")
        self.assertEqual(["base/a.cpp", "low/a.cpp"], affected.changed_files("HEAD"))

    def test_another_header_of_the_same_name_is_a_change(self):
        self.write("high/a.h", "int e();\n")
        self.write("low/a.cpp", SOURCES["low/a.cpp"].replace("low/a.h", "high/a.h"))
        self.assertEqual(["high/a.h", "low/a.cpp"], affected.changed_files("HEAD"))

    def test_names_comments_and_layout_are_no_change(self):
        self.write("high/c.cpp", '#include "low/a.h"\n#include "low/b.h"\n\n// The sum.\nint sum() {\n    return a() + b();\n}\n')
        self.assertEqual([], affected.changed_files("HEAD"))

    def test_another_value_is_a_change(self):
        self.write("high/d.cpp", "int d() { return 3; }\n")
        self.assertEqual(["high/d.cpp"], affected.changed_files("HEAD"))

    def test_another_name_of_the_project_is_a_change(self):
        self.write("high/c.cpp", SOURCES["high/c.cpp"].replace("a()", "d()"))
        self.assertEqual(["high/c.cpp"], affected.changed_files("HEAD"))

    def test_a_name_may_become_one_that_there_was_if_it_is_gone(self):
        self.write("high/c.cpp", SOURCES["high/c.cpp"].replace("c()", "d()"))
        self.assertEqual([], affected.changed_files("HEAD"))

    def test_a_name_that_stays_elsewhere_may_be_renamed_if_a_list_says_so(self):
        self.write("high/d.cpp", "int a() { return 2; }\n")
        self.write("high/e.cpp", "int d();\n")
        self.git("add", ".")
        self.assertEqual(["high/d.cpp", "high/e.cpp"], affected.changed_files("HEAD"))
        self.write(".ci/renames", "# old new\nd a\n")
        affected.renamings.cache_clear()
        self.git("add", ".")
        self.assertEqual([".ci/renames", "high/e.cpp"], affected.changed_files("HEAD"))

    def test_a_name_that_becomes_another_one_of_the_source_is_a_change(self):
        self.write("high/c.cpp", SOURCES["high/c.cpp"].replace("b()", "a()"))
        self.assertEqual(["high/c.cpp"], affected.changed_files("HEAD"))

    def test_all_folders_of_a_module_are_one(self):
        self.write("docs/architecture.md", "## Modules\n\n| `low/` | all | |\n")
        self.assertEqual(("low", "high"), (affected.module_of("low/deep/a.h"), affected.module_of("high/c.cpp")))

    def test_another_header_is_a_change(self):
        self.write("high/d.cpp", '#include "low/a.h"\nint d() { return 2; }\n')
        self.assertEqual(["high/d.cpp"], affected.changed_files("HEAD"))


class SameSource(unittest.TestCase):
    def is_same(self, before, after, is_lua=False):
        return affected.same_source.is_same(before, after, is_lua, {}, set(), set())

    def test_a_comment_in_a_text_is_none(self):
        self.assertFalse(self.is_same('puts("a // b");', 'puts("a // c");'))
        self.assertTrue(self.is_same('puts("a"); // b', 'puts("a"); /* c */'))

    def test_a_text_may_be_cut_otherwise(self):
        self.assertTrue(self.is_same('puts("ab" "cd");', 'puts("a"\n     "bcd");'))

    def test_a_raw_text_is_compared_as_it_is(self):
        self.assertFalse(self.is_same('x = R"(a  b)";', 'x = R"(a b)";'))

    def test_the_end_of_a_directive_is_part_of_it(self):
        self.assertFalse(self.is_same("#define a\nb c;", "#define a b\nc;"))

    def test_a_mark_for_clang_tidy_is_part_of_the_source(self):
        self.assertFalse(self.is_same("int a; // NOLINT", "int a;"))

    def test_two_names_do_not_become_one(self):
        self.assertFalse(self.is_same("a = b;", "c = c;"))
        self.assertTrue(self.is_same("a = b;", "b = a;"))

    def test_numbers_are_no_names(self):
        self.assertFalse(self.is_same("x = 1e5;", "x = 1e6;"))
        self.assertFalse(self.is_same("x = 1'000;", "x = 1'001;"))

    def test_lua(self):
        self.assertTrue(self.is_same("local a = 1 -- b", "local c = 1", True))
        self.assertFalse(self.is_same("local a = 'b'", "local a = 'c'", True))


if __name__ == "__main__":
    unittest.main()
