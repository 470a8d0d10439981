// Names of what a machine does, as paths have them.
#include "runtime/record/action_name.h"

#include <string>

#include <gtest/gtest.h>

namespace gsim::record::action_name_test {
namespace {

// Programs are written in many encodings; a path file is UTF-8, and no character of it is cut.
TEST(ActionName, IsUtf8WithoutSplitCharacters) {
    EXPECT_EQ(sanitized_name("Stra\xdf"
                             "e 5\t\xc3\x9f"),
              "Stra?e 5 \xc3\x9f");
    const std::string cut = sanitized_name("a" + std::string(300, 'b') + "\xc3\x9f");
    EXPECT_EQ(cut.size(), 200U);
    std::string letters = "a";
    for (int i = 0; i < 150; ++i) letters += "\xc3\x9f";
    EXPECT_EQ(sanitized_name(letters).size(), 199U);
}

}  // namespace
}  // namespace gsim::record::action_name_test
