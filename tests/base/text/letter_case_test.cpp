#include "base/text/letter_case.h"

#include <gtest/gtest.h>

namespace gsim::text::letter_case_test {
namespace {

TEST(LetterCase, ChangesOnlyAsciiLetters) {
    EXPECT_EQ(upper("azAZ09_[`{@\xe4"), "AZAZ09_[`{@\xe4");
    EXPECT_EQ(lower("azAZ09_[`{@\xc4"), "azaz09_[`{@\xc4");
    EXPECT_EQ(upper(""), "");
}

}  // namespace
}  // namespace gsim::text::letter_case_test
