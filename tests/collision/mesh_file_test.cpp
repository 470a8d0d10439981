#include "geometry/mesh/mesh_file.h"

#include <bit>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/collision/meshes.h"

namespace gsim::cell::mesh_file_test {
namespace {

using testing::HasSubstr;

void write(std::string& bytes, std::uint32_t value) {
    for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>((value >> (8U * i)) & 0xffU);
}

std::string stl_binary(const Surface& surface) {
    std::string bytes(80, 's');
    bytes.replace(0, 5, "solid");  // some programs write this before binary data
    write(bytes, static_cast<std::uint32_t>(surface.triangles.size()));
    for (const Triangle& triangle : surface.triangles) {
        bytes.append(12, '\0');
        for (const std::uint32_t corner : triangle) {
            for (const double coordinate : surface.vertices[corner])
                write(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(coordinate)));
        }
        bytes.append(2, '\0');
    }
    return bytes;
}

std::string stl_text(const Surface& surface) {
    std::string text = "solid a part with a name\n";
    for (const Triangle& triangle : surface.triangles) {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for (const std::uint32_t corner : triangle) {
            const Eigen::Vector3d& at = surface.vertices[corner];
            text += fmt::format("      vertex {:e} {:e} {:e}\n", at.x(), at.y(), at.z());
        }
        text += "    endloop\r\n  endfacet\n";
    }
    return text + "endsolid a part with a name\n";
}

constexpr std::string_view kObjCube = R"(# a cube of 2 x 3 x 4
mtllib cube.mtl
o Cube
v 0 0 0
v 2 0 0 1.0
v 2 3 0
v 0 3 0
v 0 0 4
v 2 0 4
v 2 3 4
v 0 3 4
vn 0 0 1
usemtl steel
s off
f 1 4 3 2
f -4/1/1 -3//1 -2/1 -1
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
)";

std::string error_of(std::string_view bytes, std::string_view name = "part.stl") {
    const auto mesh = read_mesh(bytes, name, 1);
    return mesh ? "" : mesh.error().message;
}

Eigen::AlignedBox3d bounds(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& vertex : mesh.vertices_mm()) box.extend(vertex);
    return box;
}

TEST(MeshFile, ReadsBinaryStlTextStlAndObj) {
    const Surface box = box_surface({2, 3, 4});
    for (const auto& [bytes, name] :
         {std::pair(stl_binary(box), "part.stl"), std::pair(stl_text(box), "part.STL"),
          std::pair(std::string(kObjCube), "part.OBJ")}) {
        const auto mesh = read_mesh(bytes, name, 10);
        ASSERT_TRUE(mesh) << mesh.error().message;
        EXPECT_EQ((*mesh)->triangle_count(), 12U) << name;
        EXPECT_TRUE(bounds(**mesh).sizes().isApprox(Eigen::Vector3d(20, 30, 40), 1e-6)) << name;
    }
}

TEST(MeshFile, ReportsErrorsWithSourceLocation) {
    const std::string binary = stl_binary(box_surface({1, 1, 1}));
    EXPECT_THAT(error_of(binary.substr(84)), HasSubstr("part.stl: "));
    std::string renamed = binary;
    renamed[0] = 'S';
    EXPECT_THAT(error_of(renamed.substr(0, 500)),
                HasSubstr("a binary STL file of 12 triangles must have 684 bytes, not 500"));
    renamed.replace(84 + 50 + 12, 4, std::string("\x00\x00\xc0\x7f", 4));  // a NaN
    EXPECT_THAT(error_of(renamed), HasSubstr("triangle 2 has a coordinate that is not finite"));
    EXPECT_THAT(error_of("solid\nfacet normal 0 0 1\nouter loop\nvertex 1 2 x\n"),
                HasSubstr("part.stl:4: 'a coordinate' is expected; found 'x'"));
    EXPECT_THAT(error_of("solid\nfacet normal 0 0 1\nouter loop\nvertex 1 2"), HasSubstr("the file ends"));
    EXPECT_THAT(error_of("solid\nendsolid\n"), HasSubstr("it contains no triangle"));
    EXPECT_THAT(error_of(""), HasSubstr("0 bytes are too few"));
    EXPECT_THAT(error_of("v 0 0 0\nv 1 0 0\nf 1 2 3\n", "a.obj"),
                HasSubstr("a.obj:3: '3' is not a vertex; 2 are defined above this line"));
    EXPECT_THAT(error_of("v 0 0\n", "a.obj"), HasSubstr("a.obj:1: a vertex must have three numbers"));
    EXPECT_THAT(error_of("v 1e999 0 0\n", "a.obj"), HasSubstr("not '1e999'"));
    EXPECT_THAT(error_of("v 0 0 0\nv 2e6 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj"),
                HasSubstr("vertex 2 is at 2e+06 mm"));
    EXPECT_THAT(error_of("cstype bspline\n", "a.obj"), HasSubstr("'cstype' is not supported"));
    EXPECT_EQ(error_of("v 1e-999 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", "a.obj"), "");
    EXPECT_FALSE(load_mesh("no/such/file.stl", 1));
    EXPECT_FALSE(load_mesh("/", 1));
}

// Whatever is done to a file, it is read or refused with its name; what is read is finite.
TEST(MeshFile, ReadsOrRejectsMangledFiles) {
    std::mt19937 random(8);
    const Surface surface = box_surface({1, 2, 3});
    const std::array<std::pair<std::string, std::string_view>, 3> files{
        std::pair(stl_binary(surface), "m.stl"), std::pair(stl_text(surface), "m.stl"),
        std::pair(std::string(kObjCube), "m.obj")};
    constexpr std::string_view kBits("\0\xff 9e-/\nn", 10);
    for (int i = 0; i < 3000; ++i) {
        const auto& [full_motion, name] = files[random() % files.size()];
        std::string bytes = full_motion;
        for (unsigned change = random() % 4; change > 0; --change)
            bytes[random() % bytes.size()] = kBits[random() % kBits.size()];
        if (random() % 3 == 0) bytes.resize(random() % bytes.size());
        if (random() % 5 == 0) bytes.erase(random() % (bytes.size() + 1), random() % 9);
        const auto mesh = read_mesh(bytes, name, 1);
        if (!mesh) {
            EXPECT_TRUE(mesh.error().message.starts_with(name)) << mesh.error().message;
            continue;
        }
        EXPECT_LE(bounds(**mesh).max().cwiseAbs().maxCoeff(), 1e6);
    }
}

}  // namespace
}  // namespace gsim::cell::mesh_file_test
