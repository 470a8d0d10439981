#include "base/toml/toml_bounds.h"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "machine/file/machine_file.h"

namespace gsim::machine::toml_bounds_test {
namespace {

constexpr std::size_t kDeep = 300'000;

std::string repeated(std::string_view text, std::size_t times) {
    std::string all;
    for (std::size_t i = 0; i < times; ++i) all += text;
    return all;
}

std::string error_of(const std::string& toml) {
    const auto machine = read_machine(toml, "f.toml");
    return machine ? "none" : machine.error().message;
}

// Each of these took the stack of the parser, or of the destructor of its tables.
TEST(TomlBounds, RejectsDeepNestingWithLocation) {
    const std::string joined = "more than 32 names joined by dots";
    const std::string nested = "arrays and tables are nested deeper than 32";
    EXPECT_EQ(error_of("# deep\n" + repeated("a.", kDeep) + "a = 1\n"), "f.toml:2:64: " + joined);
    EXPECT_EQ(error_of("[" + repeated("a.", kDeep) + "a]\n"), "f.toml:1:65: " + joined);
    EXPECT_EQ(error_of("[[" + repeated("'a' . ", kDeep) + "a]]\n"), "f.toml:1:193: " + joined);
    EXPECT_EQ(error_of("é = 1\n\"é\" = " + repeated("[", kDeep)), "f.toml:2:39: " + nested);
    EXPECT_EQ(error_of("a = " + repeated("{a=", kDeep)), "f.toml:1:101: " + nested);
    EXPECT_EQ(error_of("a = " + repeated("[{a=", kDeep)), "f.toml:1:69: " + nested);
}

TEST(TomlBounds, ParsesMaximumDepth) {
    // Both bounds at once: the deepest table there is.
    const std::string key = repeated("a.", base::kMaxTomlKeyParts - 1) + "a";
    const std::string deepest =
        repeated("{" + key + "=", base::kMaxTomlBrackets) + "1" + repeated("}", base::kMaxTomlBrackets);
    const std::string text = "[" + key + "]\n" + key + " = " + deepest;
    EXPECT_FALSE(base::find_toml_bounds_error(text));
    EXPECT_EQ(error_of(text).substr(0, 30), "f.toml:1:2: unknown key 'a' in");
}

TEST(TomlBounds, IgnoresStringsAndComments) {
    const std::string dots = repeated("a.", 100);
    const std::string brackets = repeated("[{", 100);
    const std::vector<std::string> harmless{
        "a = '" + dots + brackets + "'\n",
        "a = \"\\\"" + dots + brackets + "\"\n",
        "a = \"\"\"\n\"" + dots + "\n\\\"\"\"" + brackets + "\"\"\"\"\"\n",
        "a = '''\n'" + dots + "\n''" + brackets + "'''''\n",
        "a = 1 # " + dots + brackets + "\n",
        repeated("a = 1.5 \n", 100) + "b = [" + repeated("1.5,", 100) + "]\n",
        repeated("[[a.b]]\nc.d = {e.f = [1.5]}\n", 100),
    };
    for (const std::string& text : harmless) EXPECT_FALSE(base::find_toml_bounds_error(text)) << text;
}

// The apparent end of a string must be where the parser has it, or the remainder would not be checked.
TEST(TomlBounds, ContinuesCountingAfterStrings) {
    const std::string deep = ", " + repeated("b.", 100) + "b = 1}\n";
    for (const std::string value :
         {"''", "\"\"", "'\\'", "\"\\\\\"", "'''a'''", "'''a''''", "'''a'''''", "''''''", "\"\"\"a\"\"\"\"",
          "\"\"\"a\"\"\"\"\"", "\"\"\"\\\"\"\"\"", "\"\"\"\\\\\"\"\""}) {
        const auto excess = base::find_toml_bounds_error("a = {a = " + value + deep);
        ASSERT_TRUE(excess) << value;
        EXPECT_EQ(excess->message, "more than 32 names joined by dots") << value;
    }
}

// toml++ checks if such letters are blanks: after a backslash at the end of a line, and where no letter may
// be.
TEST(TomlBounds, TreatsLettersOfAllAlphabetsAsText) {
    for (const std::string letter : {"\u00e9", "\u03c9", "\u044d", "\u0499", "\u20ac", "\u4e2d"}) {
        const auto machine = read_machine("[machine]\nname = \"\"\"\\\n  " + letter +
                                              "\"\"\"\n[[axis]]\nletter = \"X\"\nkind = \"linear\"\n"
                                              "direction = \"x\"\n",
                                          "f.toml");
        ASSERT_TRUE(machine) << machine.error().message;
        EXPECT_EQ(machine->name, letter);
        EXPECT_THAT(error_of(letter + " = 1\n"), testing::StartsWith("f.toml:1:"));
    }
}

TEST(TomlBounds, RejectsFilesAboveSizeLimit) {
    EXPECT_EQ(error_of(std::string(base::kMaxTomlBytes + 1, '\n')),
              "f.toml:1:1: files of up to 4 MiB are read");
}

}  // namespace
}  // namespace gsim::machine::toml_bounds_test
