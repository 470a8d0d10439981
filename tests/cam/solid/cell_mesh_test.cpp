// STEP and IGES files as the meshes of a cell.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/mesh/mesh_file.h"
#include "tests/cam/solid/solids.h"

namespace gsim::cell::cell_mesh_test {

namespace {

TEST(CellMesh, IsReadFromStepAndIges) {
    const solid::SolidFolder folder;
    const TopoDS_Shape post = solid::cylinder({10, 20, 0}, 5, 30);
    for (const auto& file : {folder.step("post.step", post, "INCH"), folder.iges("post.igs", post)}) {
        const auto mesh = load_mesh(file, 2, 0.01);
        ASSERT_TRUE(mesh) << mesh.error().message;
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d& vertex : (*mesh)->vertices_mm()) box.extend(vertex);
        EXPECT_TRUE(box.min().isApprox(Eigen::Vector3d(10, 30, 0), 0.01)) << box.min();
        EXPECT_TRUE(box.max().isApprox(Eigen::Vector3d(30, 50, 60), 0.01)) << box.max();
        const auto coarse = load_mesh(file, 2, 1);
        ASSERT_TRUE(coarse) << coarse.error().message;
        EXPECT_LT((*coarse)->triangle_count(), (*mesh)->triangle_count());
    }
}

TEST(CellMesh, RejectsTooLargeOrDamagedFile) {
    const solid::SolidFolder folder;
    const auto large = load_mesh(folder.step("far.step", solid::box({0, 0, 0}, {2e6, 1, 1})), 1);
    ASSERT_FALSE(large);
    EXPECT_THAT(large.error().message,
                testing::HasSubstr("is at 2e+06 mm; coordinates must be within 1000000 mm"));
    const auto damaged = load_mesh(folder.write("bad.igs", "0"), 1);
    ASSERT_FALSE(damaged);
    EXPECT_THAT(damaged.error().message, testing::HasSubstr("bad.igs: this is not an IGES file"));
}

}  // namespace

}  // namespace gsim::cell::cell_mesh_test
