#include "tests/conformance/known.h"

#include <gtest/gtest.h>

#include "tests/conformance/scratch_folder.h"

namespace gsim::conformance::known_test {
namespace {

TEST(KnownErrors, AreReadFromList) {
    const ScratchFolder folder;
    folder.write("list.txt", "# remark\n\n a.ngc\tG7 (x) is not \t # so\nb.ngc why\n");
    const auto known = read_known(folder.path() / "list.txt");
    ASSERT_TRUE(known) << known.error().message;
    ASSERT_EQ(known->size(), 2U);
    ASSERT_NE(find_known(*known, "folder/lathe__a.ngc"), nullptr);
    EXPECT_EQ(find_known(*known, "folder/lathe__a.ngc")->reason, "G7 (x) is not");
    EXPECT_EQ(find_known(*known, "a.ngc.txt"), nullptr);
}

TEST(KnownErrors, LineWithoutReasonIsNamed) {
    const ScratchFolder folder;
    folder.write("list.txt", "a.ngc why\nb.ngc # why\n");
    const auto known = read_known(folder.path() / "list.txt");
    ASSERT_FALSE(known);
    EXPECT_NE(known.error().message.find("list.txt:2: what does the error of b.ngc hold?"),
              std::string::npos);
    EXPECT_FALSE(read_known(folder.path() / "none.txt"));
}

}  // namespace
}  // namespace gsim::conformance::known_test
