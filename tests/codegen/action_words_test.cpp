// Parts of an action's name that return in the block of a post.
#include <gtest/gtest.h>

#include "codegen/post/action_blocks.h"

namespace gsim::codegen::action_words_test {
namespace {

const ActionBlocks::Blocks kBlocks{{"stop", "M0"},
                                   {"quiet", ""},
                                   {"output {digit} on", "#110{digit}=1"},
                                   {"output {two_digits} on", "#11{two_digits}=1"},
                                   {"limit {axis} {value_mm} mm", "G48.1 {axis}{value_mm}"},
                                   {"say {text} (so)", "(MSG,{text})"},
                                   {"say {text}", "(PRINT,{text})"},
                                   {"turn {angle}", "M19 R{angle}"},
                                   {"turn 90", "M19"}};

std::optional<std::string> block(std::string_view action, double unit_mm = 1) {
    return ActionBlocks(kBlocks).find_block(action, unit_mm);
}

TEST(ActionBlocks, PrefersNameWithoutPlaceholder) {
    EXPECT_EQ(block("stop"), "M0");
    EXPECT_EQ(block("quiet"), "") << "the control does so by itself";
    EXPECT_EQ(block("turn 90"), "M19");
    EXPECT_EQ(block("turn 90.5"), "M19 R90.5");
    EXPECT_EQ(block("turn -3"), "M19 R-3");
}

TEST(ActionBlocks, PlaceholderMatchesOnlyItsKindOfValue) {
    EXPECT_EQ(block("output 7 on"), "#1107=1");
    EXPECT_EQ(block("output 17 on"), "#1117=1");
    EXPECT_EQ(block("output 117 on"), std::nullopt);
    EXPECT_EQ(block("limit X 254 mm"), "G48.1 X254");
    EXPECT_EQ(block("limit X 254 mm", 25.4), "G48.1 X10") << "a length in inches";
    EXPECT_EQ(block("limit x 254 mm"), std::nullopt);
    EXPECT_EQ(block("turn"), std::nullopt);
    EXPECT_EQ(block("turn round"), std::nullopt);
}

// The text after the inner brace was taken for a separate placeholder, and the name left by its end.
TEST(ActionBlocks, BraceInPlaceholderIsPartOfItsName) {
    const ActionBlocks::Blocks blocks{{"turn {{angle} degrees", "M19 R{{angle}"}};
    EXPECT_EQ(ActionBlocks(blocks).find_block("turn 90 degrees", 1), "M19 R90");
}

TEST(ActionBlocks, TextPlaceholderStopsAtNextLiteral) {
    EXPECT_EQ(block("say hello there (so)"), "(MSG,hello there)");
    EXPECT_EQ(block("say hello"), "(PRINT,hello)");
    EXPECT_EQ(block("say (hello)"), std::nullopt) << "no comment could hold it";
    EXPECT_EQ(block("say 5%d"), std::nullopt) << "it would be a format";
}

}  // namespace
}  // namespace gsim::codegen::action_words_test
