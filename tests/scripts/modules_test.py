#!/usr/bin/env python3
"""Tests that includes are compared with the table of modules. Usage: modules_test.py SCRIPTS-FOLDER"""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop(1))
import modules

PAGE = """# Architecture

## Modules

| module | holds | includes |
| --- | --- | --- |
| `low/` | words | fmt |
| `low/deep/` | more of it | `low/` |
| `high/` | all | `low/`, `low/deep/`, POSIX |

## More

| `other/` | is no module | fmt |
"""
SOURCES = {
    "low/a.h": "#include <vector>\n#include <fmt/format.h>\n",
    "low/deep/a.cpp": '#include "low/deep/a.h"\n#include "low/a.h"\n',
    "high/a.cpp": '#include <unistd.h>\n\n  #  include "low/a.h"\n#include "low/deep/a.h"\n',
    "tests/a.cpp": '#include "high/a.h"\n',
}


def faults(changed):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in {**SOURCES, **changed}.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        table = modules.rows(PAGE)
        return list(modules.faults(table, *modules.uses(root, table)))


class Modules(unittest.TestCase):
    def test_what_the_table_says_is_no_fault(self):
        self.assertEqual([], faults({}))

    def test_what_a_row_does_not_say_is_one(self):
        self.assertEqual(["low/b.cpp:2: low/ uses POSIX, which its row does not say"], faults({"low/b.cpp": "\n#include <unistd.h>\n"}))
        self.assertEqual(["low/b.cpp:1: low/ uses high, which its row does not say"], faults({"low/b.cpp": '#include "high/a.h"\n'}))
        self.assertEqual(["low/b.cpp:1: low/ uses xyz/any.hpp, which its row does not say"],
                         faults({"low/b.cpp": "#include <xyz/any.hpp>\n"}))

    def test_what_nothing_includes_is_one(self):
        self.assertEqual(["docs/architecture.md: high/ may use POSIX, and nothing there does"],
                         faults({"high/a.cpp": '#include "low/a.h"\n#include "low/deep/a.h"\n'}))

    def test_a_room_uses_none_below_its_row(self):
        upwards = PAGE.replace("| words | fmt |", "| words | fmt, `high/` |")
        table = modules.rows(upwards)
        self.assertIn("low/a.h:1: low/ uses high/, which stands below it in the table",
                      list(modules.faults(table, {**{module: {} for module in table}, "low": {"high": "low/a.h:1"}}, [])))

    def test_top_level_folders_that_include_each_other_are_one(self):
        used = {"low": {"high/deep": "low/a.h:1"}, "low/deep": {}, "high": {"low": "high/a.cpp:3"}, "high/deep": {}}
        self.assertEqual(["high/a.cpp:3: high/ and low/ include each other (low/a.h:1)"], list(modules.top_level_circles(used)))
        self.assertEqual([], list(modules.top_level_circles({**used, "low": {"low/deep": "low/a.h:1"}})))

    def test_a_folder_with_51_files_is_large(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in ("low", "high"):
                (root / name).mkdir()
                for number in range(51 if name == "low" else 50):
                    (root / name / f"{number}.cpp").write_text("", encoding="utf-8")
            self.assertEqual(["low/ has 51 files; 50 are permitted, so divide it"], list(modules.large_folders(root)))

    def test_each_folder_of_sources_is_a_room(self):
        self.assertEqual(["shed/a.cpp: its folder has no row in the table of modules"], faults({"shed/a.cpp": "int i;\n"}))


if __name__ == "__main__":
    unittest.main()
