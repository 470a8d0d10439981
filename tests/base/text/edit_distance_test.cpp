#include "base/text/edit_distance.h"

#include <gtest/gtest.h>

namespace gsim::text::edit_distance_test {
namespace {

TEST(EditDistance, CountsSingleCharacterChanges) {
    EXPECT_EQ(edit_distance("", ""), 0U);
    EXPECT_EQ(edit_distance("", "abc"), 3U);
    EXPECT_EQ(edit_distance("abc", ""), 3U);
    EXPECT_EQ(edit_distance("goto", "goto"), 0U);
    EXPECT_EQ(edit_distance("goto", "gato"), 1U);
    EXPECT_EQ(edit_distance("goto", "gto"), 1U);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
    EXPECT_EQ(edit_distance("goto", "GOTO"), 4U);
}

}  // namespace
}  // namespace gsim::text::edit_distance_test
