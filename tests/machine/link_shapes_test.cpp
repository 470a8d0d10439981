// The bodies in machine files.

#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"

namespace gsim::machine::link_shapes_test {
namespace {

using testing::HasSubstr;

constexpr std::string_view kMachine = R"([machine]
name = "m"
[[axis]]
letter = "X"
kind = "linear"
frame = {}
)";

std::string with(std::string_view shapes, std::string_view before = "") {
    return fmt::format("{}{}{}", before, kMachine, shapes);
}

std::string error_of(const std::string& toml) {
    const auto machine = read_machine(toml, "dir/m.toml");
    return machine ? "no error" : machine.error().message;
}

std::string shape(std::string_view name, std::string_view on, std::string_view form) {
    return fmt::format("[[shape]]\nname = \"{}\"\non = \"{}\"\nshape = {{ {} }}\n", name, on, form);
}

TEST(LinkShapes, ReadsAndPrintsAllKinds) {
    const std::string mesh = tests::source_path("samples/cell/mould.stl");
    const std::string text =
        with(fmt::format("{}{}{}{}{}frame = {{ z_mm = 2.5, yaw_deg = 90 }}\n",
                         shape("bed", "base", "box_mm = [1, 2, 3.5]"),
                         shape("post", "X", "cylinder_mm = [4, 5]"), shape("arm", "X", "capsule_mm = [6, 7]"),
                         shape("mould", "work", fmt::format("mesh = \"{}\", scale = 25.4", mesh)),
                         shape(R"(ball \"one\")", "tool", "sphere_mm = 8")),
             "ignore = [[\"bed\", \"post\"], [\"ball \\\"one\\\"\", \"arm\"]]\n");
    const auto machine = read_machine(text, "m.toml");
    ASSERT_TRUE(machine) << machine.error().message;
    ASSERT_EQ(machine->shapes.size(), 5U);
    EXPECT_EQ(machine->shapes[0].form, ShapeForm(BoxShape{1, 2, 3.5}));
    EXPECT_EQ(machine->shapes[1].form, ShapeForm(CylinderShape{4, 5}));
    EXPECT_EQ(machine->shapes[2].form, ShapeForm(CapsuleShape{6, 7}));
    EXPECT_EQ(machine->shapes[3].form, ShapeForm(MeshShape{mesh, 25.4}));
    EXPECT_EQ(machine->shapes[4].form, ShapeForm(SphereShape{8}));
    EXPECT_EQ(machine->shapes[4].on, "tool");
    EXPECT_EQ(machine->shapes[4].frame.z_mm, 2.5);
    using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
    EXPECT_EQ(machine->ignored, (Pairs{{0, 1}, {4, 2}}));
    const auto repeated = read_machine(print_machine(*machine), "elsewhere/printed.toml");
    ASSERT_TRUE(repeated) << repeated.error().message << print_machine(*machine);
    EXPECT_EQ(*repeated, *machine) << print_machine(*machine);
}

TEST(LinkShapes, MeshPathIsRelativeToMachineFile) {
    const std::string text = with(shape("mould", "X", "mesh = \"../cell/mould.stl\""));
    const auto machine = read_machine(text, tests::source_path("samples/machines/m.toml"));
    ASSERT_TRUE(machine) << machine.error().message;
    EXPECT_TRUE(std::filesystem::exists(std::get<MeshShape>(machine->shapes[0].form).file));
}

// The file is not read here, so it may be incomplete.
TEST(LinkShapes, KeepsToleranceOfSolid) {
    const auto file = std::filesystem::path(testing::TempDir()) / "link_shapes_test.step";
    std::ofstream(file) << "ISO-10303-21;";
    const auto machine = read_machine(
        with(shape("body", "X", fmt::format("mesh = \"{}\", tolerance_mm = 0.25", file.string()))), "m.toml");
    ASSERT_TRUE(machine) << machine.error().message;
    EXPECT_EQ(machine->shapes[0].form, ShapeForm(MeshShape{file, 1, 0.25}));
    const auto repeated = read_machine(print_machine(*machine), "m.toml");
    ASSERT_TRUE(repeated) << repeated.error().message;
    EXPECT_EQ(*repeated, *machine);
    std::filesystem::remove(file);
}

TEST(LinkShapes, ErrorsNameLocationAndReason) {
    EXPECT_EQ(error_of(with("[[shape]]\nnmae = \"a\"\n")),
              "dir/m.toml:8:1: unknown key 'nmae' in [[shape]]; did you mean 'name'?");
    EXPECT_EQ(error_of(with("[[shape]]\nname = \"a\"\nshape = { sphere_mm = 1 }\n")),
              "dir/m.toml:7:1: [[shape]] lacks the key 'on'");
    EXPECT_EQ(error_of(with(shape("a", "tol", "sphere_mm = 1"))),
              "dir/m.toml:9:6: 'on' must be \"base\", an axis letter (X), \"tool\", \"work\" or \"jet\"; did "
              "you mean \"tool\"?");
    EXPECT_THAT(error_of(with(shape("a", "Y", "sphere_mm = 1"))), HasSubstr("m.toml:9:6: 'on' must be"));
    EXPECT_THAT(error_of(with(shape("a", "world", "sphere_mm = 1"))), HasSubstr("'on' must be"));
    EXPECT_EQ(error_of(with(shape("a", "X", "sphere_in = 1"))),
              "dir/m.toml:10:11: unknown key 'sphere_in' in 'shape'; did you mean 'sphere_mm'?");
    EXPECT_THAT(error_of(with(shape("a", "X", "box_mm = [1, 2, 2e6]"))),
                HasSubstr("dir/m.toml:10:20: 'box_mm' must be [x, y, z]"));
    EXPECT_THAT(error_of(with(shape("a", "X", "mesh = \"no.stl\""))),
                HasSubstr("dir/m.toml:10:18: dir/no.stl: No such file"));
    EXPECT_THAT(error_of(with(shape("a", "X", "mesh = \"a\\u0000.stl\""))),
                HasSubstr("without control characters"));
    EXPECT_EQ(error_of(with(shape("a", "X", "sphere_mm = 1") + shape("a", "base", "sphere_mm = 1"))),
              "dir/m.toml:12:8: the name 'a' is given twice; first in line 8");
    EXPECT_THAT(error_of(with(shape("X", "X", "sphere_mm = 1"))),
                HasSubstr("the name 'X' is already used by a frame of the machine"));
    EXPECT_THAT(error_of(with(shape("a", "X", "sphere_mm = 1"), "ignore = [[\"a\", \"b\"]]\n")),
                HasSubstr("dir/m.toml:1:11: no object or shape has the name 'b'"));
    EXPECT_THAT(error_of(with("", "ignore = 3\n")), HasSubstr("'ignore' must be a list of pairs"));
    EXPECT_THAT(error_of(with("", "shape = 3\n")), HasSubstr("'shape' must be an array of tables"));
}

}  // namespace
}  // namespace gsim::machine::link_shapes_test
