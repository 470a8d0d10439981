// A build without OpenCASCADE.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/mesh/mesh.h"

namespace gsim::solid::without_reader_test {

namespace {

TEST(WithoutReader, ReportsHowToInstallReader) {
    const auto mesh = read_mesh("part.step", 0.05);
    ASSERT_FALSE(mesh);
    EXPECT_THAT(mesh.error().message,
                testing::HasSubstr("'part.step': this build does not read STEP and IGES files; "
                                   "install OpenCASCADE (scripts/setup.sh step)"));
}

}  // namespace

}  // namespace gsim::solid::without_reader_test
