#include "base/toml/toml_editor.h"

#include <gtest/gtest.h>

namespace gsim::base {
namespace {

using nlohmann::ordered_json;

/// Returns the text after a change, or the error.
template <typename Change>
std::string after(const std::string& text, const Change& change) {
    auto edit = TomlEditor::read(text, "part.toml");
    if (!edit) return edit.error().message;
    const Result<void> done = change(*edit);
    if (!done) {
        EXPECT_EQ(edit->text(), text);
        return done.error().message;
    }
    EXPECT_EQ(edit->value(), *toml_json(edit->text(), "again"));
    return edit->text();
}

std::string set(const std::string& text, const TomlPath& path, const ordered_json& value) {
    return after(text, [&](TomlEditor& edit) { return edit.set(path, value); });
}
std::string add(const std::string& text, const TomlPath& path, const ordered_json& value) {
    return after(text, [&](TomlEditor& edit) { return edit.add(path, value); });
}
std::string removed(const std::string& text, const TomlPath& path) {
    return after(text, [&](TomlEditor& edit) { return edit.remove(path); });
}
std::string moved(const std::string& text, const TomlPath& path, std::size_t to) {
    return after(text, [&](TomlEditor& edit) { return edit.move(path, to); });
}

constexpr std::size_t kFirst = 0;
constexpr std::size_t kSecond = 1;

constexpr const char* kMachine = R"(# A machine.

[machine]
name = "router"  # as it is called

# The first axis.
[[axis]]
letter = "X"
max_mm = 600.0              # measured
frame = { x_mm = 1.0 }

# The second one.
[[axis]]
letter = "Y"
max_mm = 400.0
)";

std::string with(std::string text, const std::string& old, const std::string& now) {
    return text.replace(text.find(old), old.size(), now);
}

TEST(TomlEditor, ReplacesValueAndKeepsComment) {
    EXPECT_EQ(set(kMachine, {"machine", "name"}, "mill"), with(kMachine, "\"router\"  #", "\"mill\"    #"));
    EXPECT_EQ(set(kMachine, {"axis", kFirst, "max_mm"}, 1234.5), with(kMachine, "600.0  ", "1234.5 "));
    EXPECT_EQ(set("a = 1 # one\n", {"a"}, 12), "a = 12 # one\n");
    EXPECT_EQ(set("a=true", {"a"}, false), "a=false");
    EXPECT_EQ(set("a = '''x\ny''' # c\nb = 1\n", {"a"}, "z"), "a = \"z\" # c\nb = 1\n");
}

TEST(TomlEditor, KeepsSpellingOfEqualValue) {
    EXPECT_EQ(set("a = 6e2\n", {"a"}, 600), "a = 6e2\n");
    EXPECT_EQ(set("a = { b = 0x10, c = +1_000.50 }\n", {"a"}, {{"b", 16}, {"c", 1000.5}}),
              "a = { b = 0x10, c = +1_000.50 }\n");
    EXPECT_EQ(set("a = [1.50, 2.50]\n", {"a"}, {1.5, 3}), "a = [1.50, 3.0]\n");
}

TEST(TomlEditor, WritesNumberInStyleOfPreviousOne) {
    EXPECT_EQ(set("a = 1.5\n", {"a"}, 254), "a = 254.0\n");
    EXPECT_EQ(set("a = 40\n", {"a"}, 50), "a = 50\n");
    EXPECT_EQ(set("a = 40\n", {"a"}, 0.1), "a = 0.1\n");
    EXPECT_EQ(set("a = 0.5\n", {"a"}, 1e21), "a = 1e+21\n");
    EXPECT_EQ(set("a = 0.5\n", {"a"}, "inf"), "a = inf\n");
    EXPECT_EQ(set("a = inf\n", {"a"}, 3), "a = 3.0\n");
    EXPECT_EQ(set("a = \"x\"\n", {"a"}, "inf"), "a = \"inf\"\n");
    EXPECT_EQ(set("a = 1.0\n", {"b"}, 2), "a = 1.0\nb = 2.0\n");
    EXPECT_EQ(set("a = 1\n", {"b"}, 2), "a = 1\nb = 2\n");
    EXPECT_EQ(set("a = 1979-05-27\n", {"b"}, 2), "a = 1979-05-27\nb = 2.0\n");
}

TEST(TomlEditor, AddsNewKeyAfterLastKeyOfTable) {
    EXPECT_EQ(set(kMachine, {"machine", "inverse"}, "gantry"),
              with(kMachine, "as it is called\n", "as it is called\ninverse = \"gantry\"\n"));
    EXPECT_EQ(set(kMachine, {"axis", kSecond, "min_mm"}, 0),
              with(kMachine, "max_mm = 400.0\n", "max_mm = 400.0\nmin_mm = 0.0\n"));
    EXPECT_EQ(set("[a]\n  b=1\n\n[c]\n", {"a", "d"}, 2), "[a]\n  b=1\n  d=2\n\n[c]\n");
    EXPECT_EQ(set("  [a] # none\n[c]\n", {"a", "d"}, 2), "  [a] # none\n  d = 2.0\n[c]\n");
    EXPECT_EQ(set("[a]", {"a", "d"}, 2), "[a]\nd = 2.0");
    EXPECT_EQ(set("a = 1", {"d"}, 2), "a = 1\nd = 2");
}

TEST(TomlEditor, AddsRootKeyBeforeTables) {
    EXPECT_EQ(set(kMachine, {"ignore"}, ordered_json::array({ordered_json::array({"a", "b"})})),
              with(kMachine, "[machine]", "ignore = [[\"a\", \"b\"]]\n\n[machine]"));
    EXPECT_EQ(set("# Title\n[a]\n", {"b"}, 1), "# Title\n\nb = 1.0\n\n[a]\n");
    EXPECT_EQ(set("", {"b"}, 1), "b = 1.0\n");
    EXPECT_EQ(set("# only\n# comments\n", {"b"}, 1), "# only\n# comments\n\nb = 1.0\n");
    EXPECT_EQ(set("# only", {"b"}, 1), "# only\n\nb = 1.0");
    EXPECT_EQ(set("\xEF\xBB\xBF[a]\n", {"b"}, 1),
              "\xEF\xBB\xBF"
              "b = 1.0\n\n[a]\n");
}

TEST(TomlEditor, CreatesMissingTables) {
    EXPECT_EQ(set(kMachine, {"path", "max_feed_mm_s"}, 100),
              std::string(kMachine) + "\n[path]\nmax_feed_mm_s = 100.0\n");
    EXPECT_EQ(set(kMachine, {"axis", kSecond, "frame", "x_mm"}, 2),
              with(kMachine, "400.0\n", "400.0\nframe = { x_mm = 2.0 }\n"));
    EXPECT_EQ(set("[controller]\nplanner = \"x\"\n\n[tool]\n", {"controller", "stops", "at"}, true),
              "[controller]\nplanner = \"x\"\n\n[controller.stops]\nat = true\n\n[tool]\n");
    EXPECT_EQ(set("", {"axis", kFirst, "letter"}, "X"), "[[axis]]\nletter = \"X\"\n");
    EXPECT_EQ(set("[a.b]\nc = 1\n", {"a", "d"}, 2), "[a]\nd = 2\n\n[a.b]\nc = 1\n");
}

TEST(TomlEditor, KeepsStyleOfInlineTables) {
    EXPECT_EQ(set("a = { x = 1.0 } # c\n", {"a", "y"}, 2), "a = { x = 1.0, y = 2.0 } # c\n");
    EXPECT_EQ(set("a = {x = 1.0}\n", {"a", "x"}, 2), "a = {x = 2.0}\n");
    EXPECT_EQ(set("a = {}\n", {"a", "x"}, 2), "a = { x = 2.0 }\n");
    EXPECT_EQ(set("a = { b.c = 1, d = 2 }\n", {"a", "b", "e"}, 3), "a = { b.c = 1, b.e = 3, d = 2 }\n");
    EXPECT_EQ(set("shape = { box_mm = [1.0, 2.0, 3.0] }\n", {"shape", "box_mm", kSecond}, 5),
              "shape = { box_mm = [1.0, 5.0, 3.0] }\n");
    EXPECT_EQ(set("a = [\n  1, # one\n  2 # two\n]\n", {"a", std::size_t{2}}, 3),
              "a = [\n  1, # one\n  2, # two\n  3\n]\n");
    EXPECT_EQ(set("a = [\n  1,\n  2,\n]\n", {"a"}, {1, 2, 3}), "a = [\n  1,\n  2,\n  3,\n]\n");
    EXPECT_EQ(set("shape = { box_mm = [1.0, 2.0, 3.0] }\n", {"shape"}, {{"sphere_mm", 4}}),
              "shape = { sphere_mm = 4.0 }\n");
}

TEST(TomlEditor, FindsDottedAndQuotedKeys) {
    EXPECT_EQ(set("a.b . \"c d\" = 1 # x\n", {"a", "b", "c d"}, 2), "a.b . \"c d\" = 2 # x\n");
    EXPECT_EQ(set("a.b = 1\n", {"a", "e.f"}, 2), "a.b = 1\na.\"e.f\" = 2\n");
    EXPECT_EQ(set("\"\\u00e4\\t\" = 1\n", {"\xC3\xA4\t"}, 2), "\"\\u00e4\\t\" = 2\n");
    EXPECT_EQ(set("['x.y'.z]\na = 1\n", {"x.y", "z", "a"}, 2), "['x.y'.z]\na = 2\n");
    EXPECT_EQ(set("[a]\nname = \"Fr\xC3\xA4se\" # \xE2\x82\xAC\n", {"a", "name"}, "B\xC3\xB6hrer"),
              "[a]\nname = \"B\xC3\xB6hrer\" # \xE2\x82\xAC\n");
}

TEST(TomlEditor, KeepsLineEndings) {
    EXPECT_EQ(set("[a]\r\nb = 1 # c\r\n", {"a", "b"}, 2), "[a]\r\nb = 2 # c\r\n");
    EXPECT_EQ(set("[a]\r\nb = 1\r\n", {"a", "c"}, 2), "[a]\r\nb = 1\r\nc = 2\r\n");
    EXPECT_EQ(add("[[a]]\r\nb = 1\r\n", {"a"}, {{"b", 2}}), "[[a]]\r\nb = 1\r\n\r\n[[a]]\r\nb = 2\r\n");
    EXPECT_EQ(removed("[[a]]\r\nb = 1\r\n\r\n[[a]]\r\nb = 2\r\n", {"a", kFirst}), "[[a]]\r\nb = 2\r\n");
}

TEST(TomlEditor, AddsTableAfterLastOfItsKind) {
    EXPECT_EQ(
        add(std::string(kMachine) + "\n[times]\n", {"axis"}, {{"letter", "Z"}, {"frame", {{"z_mm", 1}}}}),
        std::string(kMachine) + "\n[[axis]]\nletter = \"Z\"\nframe = { z_mm = 1.0 }\n\n[times]\n");
    EXPECT_EQ(add("[[a]]\nb = 1\n[[a]]\nb = 2\n", {"a"}, {{"b", 3}}),
              "[[a]]\nb = 1\n[[a]]\nb = 2\n[[a]]\nb = 3\n");
    EXPECT_EQ(add("[[a]]\nb = 1", {"a"}, {{"b", 3}}), "[[a]]\nb = 1\n\n[[a]]\nb = 3");
    EXPECT_EQ(add("[[a]]\n[[a.c]]\nd = 1\n[a.e]\nf = 1\n", {"a", kFirst, "c"}, {{"d", 2}}),
              "[[a]]\n[[a.c]]\nd = 1\n[[a.c]]\nd = 2\n[a.e]\nf = 1\n");
    EXPECT_EQ(add("[cell]\nname = \"c\"\n", {"object"}, {{"name", "t"}}),
              "[cell]\nname = \"c\"\n\n[[object]]\nname = \"t\"\n");
    EXPECT_EQ(add("a = [1]\n", {"a"}, 2), "a = [1, 2]\n");
}

TEST(TomlEditor, RemovesValueWithItsComments) {
    EXPECT_EQ(removed(kMachine, {"axis", kSecond}),
              with(kMachine, "\n# The second one.\n[[axis]]\nletter = \"Y\"\nmax_mm = 400.0\n", ""));
    EXPECT_EQ(removed(kMachine, {"axis", kFirst}),
              with(kMachine,
                   "# The first axis.\n[[axis]]\nletter = \"X\"\nmax_mm = 600.0              # measured\n"
                   "frame = { x_mm = 1.0 }\n\n",
                   ""));
    EXPECT_EQ(removed(kMachine, {"axis", kFirst, "frame"}), with(kMachine, "frame = { x_mm = 1.0 }\n", ""));
    EXPECT_EQ(removed("[a]\n# both\nb = 1\nc = 2\n", {"a", "b"}), "[a]\n# both\nc = 2\n");
    EXPECT_EQ(removed("[a]\nc = 2\n# of b\nb = 1 # too\n", {"a", "b"}), "[a]\nc = 2\n");
    EXPECT_EQ(removed("[[a]]\nb = 1\n[a.c]\nd = 1\n# e = 2\n\n# On its own.\n\n[f]\n", {"a", kFirst}),
              "# On its own.\n\n[f]\n");
    EXPECT_EQ(removed("# The file.\n[a]\nb = 1\n", {"a"}), "# The file.\n");
    EXPECT_EQ(removed("a = { b = 1, c = 2 }\n", {"a", "b"}), "a = { c = 2 }\n");
    EXPECT_EQ(removed("a = { b = 1, c = 2 }\n", {"a", "c"}), "a = { b = 1 }\n");
    EXPECT_EQ(removed("a = { b = 1 }\n", {"a", "b"}), "a = {}\n");
    EXPECT_EQ(removed("a = { b.c = 1, d = 2, b.e = 3 }\n", {"a", "b"}), "a = { d = 2 }\n");
    EXPECT_EQ(removed("a = [\n  1, # one\n  2, # two\n]\n", {"a", kFirst}), "a = [\n  2, # two\n]\n");
    EXPECT_EQ(removed("a = [\n  1, # one\n  2 ]\n", {"a", kSecond}), "a = [\n  1, # one\n   ]\n");
    EXPECT_EQ(removed("[a.b]\nc = 1\n[d]\n[a.e]\nf = 1\n", {"a"}), "[d]\n");
}

TEST(TomlEditor, MovesEntryWithCommentsAndSubtables) {
    constexpr const char* kThree =
        "[[a]]\nb = 1\n\n# two\n[[a]]\nb = 2\n[a.c]\nd = 2\n\n[[a]]\nb = 3\n\n[e]\n";
    EXPECT_EQ(moved(kThree, {"a", kSecond}, 0),
              "# two\n[[a]]\nb = 2\n[a.c]\nd = 2\n\n[[a]]\nb = 1\n\n[[a]]\nb = 3\n\n[e]\n");
    EXPECT_EQ(moved(kThree, {"a", kSecond}, 2),
              "[[a]]\nb = 1\n\n[[a]]\nb = 3\n\n# two\n[[a]]\nb = 2\n[a.c]\nd = 2\n\n[e]\n");
    EXPECT_EQ(moved(kThree, {"a", std::size_t{2}}, 1),
              "[[a]]\nb = 1\n\n[[a]]\nb = 3\n\n# two\n[[a]]\nb = 2\n[a.c]\nd = 2\n\n[e]\n");
    EXPECT_EQ(moved(kThree, {"a", kFirst}, 2),
              "# two\n[[a]]\nb = 2\n[a.c]\nd = 2\n\n[[a]]\nb = 3\n\n[[a]]\nb = 1\n\n[e]\n");
    EXPECT_EQ(moved("a = [1.0, 2.50, 3]\n", {"a", kFirst}, 2), "a = [2.50, 3, 1.0]\n");
    EXPECT_EQ(moved("[[a]]\nb = 1\n[[a]]\nb = 2", {"a", kSecond}, 0), "[[a]]\nb = 2\n[[a]]\nb = 1\n");
}

constexpr const char* kClamps = R"(clamps = [
  # by the door
  "left", # heavy
  # between

  "middle",
  # behind
  # the slats
  "right", # new
]
)";

TEST(TomlEditor, ListChangeKeepsCommentsOfElements) {
    const auto set_clamps = [](const ordered_json& value) { return set(kClamps, {"clamps"}, value); };
    const std::string left = "  # by the door\n  \"left\", # heavy\n";
    const std::string right = "  # behind\n  # the slats\n  \"right\", # new\n";
    EXPECT_EQ(set_clamps({"middle", "right"}), with(kClamps, left, ""));
    EXPECT_EQ(set_clamps({"left", "right"}), with(kClamps, "  \"middle\",\n", ""));
    EXPECT_EQ(set_clamps({"left", "middle"}), with(kClamps, right, ""));
    EXPECT_EQ(set_clamps({"right"}), with(with(kClamps, left, ""), "  \"middle\",\n", ""));
    EXPECT_EQ(set_clamps({"left", "centre", "right"}), with(kClamps, "middle", "centre"));
    EXPECT_EQ(set_clamps({"left", "middle", "more", "right"}),
              with(kClamps, "  \"middle\",\n", "  \"middle\",\n  \"more\",\n"));
    EXPECT_EQ(set_clamps({"more", "left", "middle", "right"}), with(kClamps, left, "  \"more\",\n" + left));
    EXPECT_EQ(set_clamps({"right", "left", "middle"}),
              "clamps = [\n" + right + "  # between\n\n" + left + "  \"middle\",\n]\n");
    // If two of three elements remain, no element is known to replace another one.
    EXPECT_EQ(set_clamps({"left", "both"}), with(with(kClamps, right, ""), "  # between\n\n  \"middle\",\n",
                                                 "  \"both\",\n  # between\n\n"));
    EXPECT_EQ(set("a = [\n  # all\n  1, # one\n  2,\n  3 # three\n]\n", {"a"}, {2, 3}),
              "a = [\n  # all\n  2,\n  3 # three\n]\n");
    EXPECT_EQ(set("a = [1, # one\n  2, # two\n  3] # all\n", {"a"}, {2, 3}),
              "a = [\n  2, # two\n  3] # all\n");
    EXPECT_EQ(set("a = [ 1 # one\n    , 2 # two\n    , 3 ]\n", {"a"}, {1, 3}), "a = [ 1 # one\n    , 3 ]\n");
    EXPECT_EQ(set("a = [1, 2, 3, 4]\n", {"a"}, {2, 4}), "a = [2, 4]\n");
    EXPECT_EQ(set("a = [1, 2]\n", {"a"}, ordered_json::array()), "a = []\n");
    EXPECT_EQ(set("a = [[1, 2], [3, 4]]\n", {"a"}, {{3, 4}}), "a = [[3, 4]]\n");
}

TEST(TomlEditor, RemainingTablesKeepComments) {
    const ordered_json y{{"letter", "Y"}, {"max_mm", 400}};
    const ordered_json z{{"letter", "Z"}};
    EXPECT_EQ(set(kMachine, {"axis"}, ordered_json::array({y})), removed(kMachine, {"axis", kFirst}));
    EXPECT_EQ(set(kMachine, {"axis"}, ordered_json::array({y, z})),
              removed(kMachine, {"axis", kFirst}) + "\n[[axis]]\nletter = \"Z\"\n");
}

TEST(TomlEditor, MovesListElementWithComments) {
    const std::string left = "  # by the door\n  \"left\", # heavy\n";
    const std::string right = "  # behind\n  # the slats\n  \"right\", # new\n";
    EXPECT_EQ(moved(kClamps, {"clamps", kFirst}, 2),
              "clamps = [\n  \"middle\",\n  # between\n\n" + right + left + "]\n");
    EXPECT_EQ(moved("a = [\n  1, # one\n  2\n]\n", {"a", kFirst}, 1), "a = [\n  2,\n  1 # one\n]\n");
    EXPECT_EQ(moved("a = [1, # one\n  2] # both\n", {"a", kFirst}, 1), "a = [2,\n  1 # one\n] # both\n");
    EXPECT_EQ(moved("a = [\r\n  1, # one\r\n  2, # two\r\n]\r\n", {"a", kFirst}, 1),
              "a = [\r\n  2, # two\r\n  1, # one\r\n]\r\n");
    EXPECT_EQ(moved("a = [1,\n  # two\n  2,\n]\n", {"a", kSecond}, 0), "a = [\n  # two\n2,\n  1,\n]\n");
}

TEST(TomlEditor, RejectsInvalidChangeAndKeepsText) {
    EXPECT_EQ(set("a = \n", {"a"}, 1).substr(0, 13), "part.toml:1:5");
    EXPECT_EQ(removed(kMachine, {"axis", std::size_t{2}}), "'axis[2]' does not exist and cannot be removed");
    EXPECT_EQ(removed(kMachine, {"tool"}), "'tool' does not exist and cannot be removed");
    EXPECT_EQ(removed(kMachine, {}), "the document itself cannot be removed");
    EXPECT_EQ(moved(kMachine, {"axis", kFirst}, 2),
              "'axis' has 2 elements, from 0 on; index 2 does not exist");
    EXPECT_EQ(moved(kMachine, {"machine"}, 0), "'machine' is not an element of a list");
    EXPECT_EQ(moved(kMachine, {"shape", kFirst}, 0), "'shape[0]' does not exist and cannot be moved");
    EXPECT_EQ(set(kMachine, {"machine"}, 3),
              "'machine' is a table on separate lines; a number cannot replace it");
    EXPECT_EQ(set(kMachine, {"machine", "name", "first"}, 3),
              "'machine.name' is a string, and has no key 'first'");
    EXPECT_EQ(set(kMachine, {"axis", "letter"}, "X"), "'axis' is a list, and has no key 'letter'");
    EXPECT_EQ(set(kMachine, {"machine", kFirst}, "X"), "'machine' is a table, and has no elements");
    EXPECT_EQ(set(kMachine, {"axis", std::size_t{5}, "letter"}, "Z"),
              "'axis' has 2 elements; the next index is 2");
    EXPECT_EQ(set(kMachine, {"shape", std::size_t{5}, "letter"}, "Z"),
              "'shape[5].letter' cannot be created: the first index of a new list must be 0");
    EXPECT_EQ(set(kMachine, {"axis"}, ordered_json::array()),
              "'axis' is created by its entries; an empty one is removed");
    EXPECT_EQ(add(kMachine, {"machine"}, 1), "'machine' is a table, and has no elements");
    EXPECT_EQ(add(kMachine, {"axis"}, 1), "'axis' is a list of tables; a number cannot be an element of it");
    EXPECT_EQ(set(kMachine, {"machine", "name"}, nullptr), "TOML has no null; remove the key instead");
    EXPECT_EQ(set(kMachine, {}, 3), "a document must be a table, with keys");
    EXPECT_EQ(set(kMachine, TomlPath(40, "a"), 3), "a path may lead through at most 32 tables and lists");
}

TEST(TomlEditor, RevertsEarlierPartsIfLaterPartFails) {
    EXPECT_EQ(set(kMachine, {}, {{"machine", {{"name", "mill"}}}, {"axis", 3}}),
              "'axis' is a list on separate lines; a number cannot replace it");
}

}  // namespace
}  // namespace gsim::base
