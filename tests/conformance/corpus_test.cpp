#include "tests/conformance/corpus.h"

#include <gtest/gtest.h>

#include "tests/conformance/scratch_folder.h"

namespace gsim::conformance::corpus_test {
namespace {

TEST(Corpus, ContainsOnlyProgramsWithRecordedOutput) {
    const ScratchFolder folder;
    folder.write("b.ngc", "M2");
    folder.write("b.ngc.canon.gz", "");
    folder.write("a.nc", "M428");
    folder.write("a.nc.canon-without-M428-430.gz", "");
    folder.write("alone.ngc", "M2");
    folder.write("lost.ngc.canon.gz", "");
    const auto found = find_recorded(folder.path());
    ASSERT_TRUE(found) << found.error().message;
    ASSERT_EQ(found->size(), 2U);
    EXPECT_EQ((*found)[0].program.filename(), "a.nc");
    EXPECT_TRUE((*found)[0].without_kinematics);
    EXPECT_EQ((*found)[1].program.filename(), "b.ngc");
    EXPECT_FALSE((*found)[1].without_kinematics);
}

TEST(Corpus, NamesMissingFolder) {
    const ScratchFolder folder;
    const auto found = find_recorded(folder.path() / "none");
    ASSERT_FALSE(found);
    EXPECT_NE(found.error().message.find("none"), std::string::npos);
}

TEST(Corpus, RemovesKinematicsSwitches) {
    EXPECT_EQ(without_kinematics_switches("G1 X1 M428\nm0429 G0 X2\nM430\nM4281 M42 M428.5"),
              "G1 X1 \n G0 X2\n\nM4281 M42 M428.5");
}

}  // namespace
}  // namespace gsim::conformance::corpus_test
