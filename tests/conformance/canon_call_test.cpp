#include "tests/conformance/canon_call.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsim::conformance::canon_call_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(CanonCall, HasNameAndNumbers) {
    const auto traverse = read_canon_call("   12 N..... STRAIGHT_TRAVERSE(1.0000, -2.5000, 0.0000)");
    ASSERT_TRUE(traverse);
    EXPECT_EQ(traverse->name, "STRAIGHT_TRAVERSE");
    EXPECT_THAT(traverse->numbers(), ElementsAre(1, -2.5, 0));

    const auto tool =
        read_canon_call("   14 N..... USE_TOOL_LENGTH_OFFSET(1.0000 0.0000 5.0000, 0.0000 0.0000 2.0)");
    ASSERT_TRUE(tool);
    EXPECT_THAT(tool->numbers(), ElementsAre(1, 0, 5, 0, 0, 2));
}

TEST(CanonCall, MayHaveWordsOrNoArguments) {
    const auto units = read_canon_call("    1 N..... USE_LENGTH_UNITS(CANON_UNITS_MM)");
    ASSERT_TRUE(units);
    EXPECT_EQ(units->arguments, "CANON_UNITS_MM");
    EXPECT_THAT(units->numbers(), IsEmpty());
    EXPECT_THAT(read_canon_call("    6 N..... ON_RESET()")->numbers(), IsEmpty());
    EXPECT_THAT(read_canon_call("   11 N..... NURBS_FEED(5, ...)")->numbers(), ElementsAre(5));
}

TEST(CanonCall, KeepsBracketsInComments) {
    const auto comment = read_canon_call(R"(   24 N..... COMMENT("a (nested) remark"))");
    ASSERT_TRUE(comment);
    EXPECT_EQ(comment->arguments, R"("a (nested) remark")");
}

TEST(CanonCall, IsNotFoundInOtherLines) {
    EXPECT_FALSE(read_canon_call(""));
    EXPECT_FALSE(read_canon_call("   "));
    EXPECT_FALSE(read_canon_call("executing"));
    EXPECT_FALSE(read_canon_call("    1 N..... lower(1)"));
    EXPECT_FALSE(read_canon_call("    1 N..... OPEN(1"));
}

}  // namespace
}  // namespace gsim::conformance::canon_call_test
