"""Tests which texts of a source are messages."""

import sys
import unittest

sys.path.insert(0, sys.argv.pop(1))
import messages


def of(text, language="c"):
    return [message for message in messages.messages_of(text, language) if messages.is_message(message)]


class Messages(unittest.TestCase):
    def test_adjacent_literals_are_one_message(self):
        self.assertEqual(["the path must have one point at least"], of('fail("the path must have "\n     "one point at least");'))

    def test_literals_of_two_arguments_are_two(self):
        self.assertEqual(["the axis has no limit", "set a limit for it"], of('fail("the axis has no limit", "set a limit for it");'))

    def test_code_and_keys_are_none(self):
        self.assertEqual([], of('a("max_speed_mm_s"); b("G1 X{} Y{}"); c("SELECT id FROM run"); // the path must have one'))

    def test_lua_has_them_too(self):
        self.assertEqual(["a value of G4 is missing"], of('alarm("dwell", "a value of G4 is missing")', "lua"))


if __name__ == "__main__":
    unittest.main()
