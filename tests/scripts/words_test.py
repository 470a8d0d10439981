#!/usr/bin/env python3
"""Tests that banned words are found and counted, and that limits only fall. Usage: words_test.py SCRIPTS-FOLDER"""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, sys.argv.pop(1))
import words

SOURCES = {
    "scripts/words.txt": "# limits\nallow least_squares  # the method\nnames most 1\n",
    "motion/a.cpp": '// Where it stands, behind the wall.\nint kMostAxes = least_squares(way_mm); // always\nauto text = "told by lot";\n',
    "motion/b.lua": "local way_mm = 1 -- told\n",
    "motion/tip_path.h": "",
    "docs/a.md": "It tells `tell` where.\n\n    tell in code\n",
    "build/a.cpp": "int way;\n",
}


class Words(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)
        for name, text in SOURCES.items():
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(text, encoding="utf-8")

    def sizes(self):
        _, allowed = words.read_limits(self.root / "scripts/words.txt")
        return {key: words.size(key, pairs) for key, pairs in words.count(self.root, allowed).items()}

    def test_counts_distinct_names_and_each_use_in_prose(self):
        self.assertEqual({("names", "most"): 1, ("names", "way"): 1, ("files", "tip"): 1,
                          ("comments", "where"): 1, ("comments", "behind"): 1, ("comments", "told"): 1,
                          ("messages", "told"): 1, ("messages", "by lot"): 1,
                          ("documents", "tells"): 1, ("documents", "where"): 1}, self.sizes())

    def test_lowers_limits_and_never_raises_one(self):
        path = self.root / "scripts/words.txt"
        words.write_limits(path, {("names", "most"): 3, ("names", "way"): 2, ("messages", "guest"): 5}, {("names", "most"): 1, ("names", "way"): 7})
        limits, allowed = words.read_limits(path)
        self.assertEqual({("names", "most"): 1, ("names", "way"): 2}, limits)
        self.assertEqual({"least_squares"}, allowed)


if __name__ == "__main__":
    unittest.main()
