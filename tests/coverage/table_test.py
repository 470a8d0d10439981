#!/usr/bin/env python3
"""Tests that the table of coverage counts the lines of gcovr and the recorded lines of Lua. Usage: table_test.py SCRIPTS-FOLDER"""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop(1))
import coverage_table


def counted(name, lines, run, branches, taken):
    return {"filename": name, "line_total": lines, "line_covered": run, "branch_total": branches, "branch_covered": taken}


class Table(unittest.TestCase):
    def test_modules_add_up_their_files_and_runtime_has_several(self):
        files = [counted("base/text/a.cpp", 10, 9, 4, 1), counted("base/text/b.cpp", 30, 30, 0, 0), counted("collision/a.cpp", 5, 0, 2, 0),
                 counted("motion/linuxcnc/a.cpp", 7, 7, 2, 2), counted("codegen/lua/a.cpp", 3, 3, 0, 0)]
        self.assertEqual({"base/text": [40, 39, 4, 1], "collision": [5, 0, 2, 0], "motion/linuxcnc": [7, 7, 2, 2], "codegen": [3, 3, 0, 0]},
                         dict(coverage_table.modules_of({"files": files})))

    def test_a_row_has_percentages_to_a_tenth(self):
        self.assertEqual("| os | 40 | 39 | 97.5 | 4 | 1 | 25.0 |", coverage_table.row("os", [40, 39, 4, 1]))
        self.assertEqual("| lua | 3 | 2 | 66.7 |  |  |  |", coverage_table.row("lua", [3, 2, 0, 0]))

    def test_lines_of_lua_are_those_with_code(self):
        text = "-- a comment\nlocal function f(a)\n  if a then\n    return 1\n  end\n\n  return {\n    2,\n  }\nend\nreturn f\n"
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.lua"
            file.write_text(text, encoding="utf-8")
            found = coverage_table.lines_with_code(file)
        self.assertLessEqual({3, 4, 7, 11}, found)
        self.assertFalse({1, 5, 6, 10} & found)


if __name__ == "__main__":
    unittest.main()
