#include "collision/cell/cell_file.h"

#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision/pairs/candidate_pairs.h"
#include "tests/collision/segments.h"

namespace gsim::cell::cell_file_test {
namespace {

using testing::HasSubstr;

constexpr std::string_view kWhole = R"([cell]
name = "A cell"
machine = "machines/af5.toml"
clearance_mm = 2.5

[[frame]]
name = "table"
frame = { x_mm = 100.0, yaw_deg = 90.0 }

[[object]]
name = "sheet"
role = "workpiece"
attached_to = "table"
shape = { box_mm = [300.0, 200.0, 2.0] }
frame = { z_mm = 1.0 }

[[object]]
name = "post"
shape = { cylinder_mm = [20, 100] }

[[shape]]
name = "head"
on = "C"
shape = { capsule_mm = [40, 100] }

[[shape]]
name = "water"
on = "jet"
shape = { cylinder_mm = [1.0, 4.0] }
frame = { z_mm = -2.0 }
)";

std::string error_of(std::string text) {
    const auto cell = read_cell(text, "dir/c.toml", af5());
    return cell ? "" : cell.error().message;
}

std::string with(std::string_view more) {
    return fmt::format("{}{}", kWhole, more);
}

TEST(CellFile, ReadsAllTables) {
    const auto cell =
        read_cell(fmt::format("{}{}", "ignore = [[\"head\", \"post\"]]\n", kWhole), "dir/c.toml", af5());
    ASSERT_TRUE(cell) << cell.error().message;
    EXPECT_EQ(cell->name, "A cell");
    EXPECT_EQ(cell->clearance_mm, 2.5);
    ASSERT_EQ(cell->items.size(), 4U);
    EXPECT_EQ(cell->items[0].role, Role::workpiece);
    EXPECT_EQ(cell->items[1].role, Role::fixture);
    EXPECT_EQ(cell->items[2].role, Role::machine);
    EXPECT_EQ(cell->items[3].role, Role::jet);
    EXPECT_EQ(cell->frames.link(cell->items[2].frame), 5);
    EXPECT_EQ(cell->frames.link(cell->items[3].frame), 5);
    // Yaw by 90 degrees takes Z to -Y.
    EXPECT_TRUE(
        cell->frames.pose_in_link(cell->items[0].frame).translation().isApprox(Eigen::Vector3d(100, -1, 0)));
    EXPECT_EQ(cell->ignored, (std::vector<std::pair<std::size_t, std::size_t>>{{2, 1}}));
    const auto files = read_cell_files(kWhole, "dir/c.toml");
    ASSERT_TRUE(files);
    EXPECT_EQ(files->machine, "dir/machines/af5.toml");
    EXPECT_TRUE(files->machine_data.empty());
}

TEST(CellFile, ReportsErrorsWithSourceLocation) {
    EXPECT_THAT(error_of("x = 1"), HasSubstr("dir/c.toml:1:1: unknown key 'x' in a cell file"));
    EXPECT_THAT(error_of(""), HasSubstr("lacks the key 'cell'"));
    EXPECT_THAT(error_of("[cell]\nname = \"c\"\nclearance_mm = -1"),
                HasSubstr("'clearance_mm' must be 0 or greater"));
    EXPECT_THAT(error_of("[cell]\nname = \"c\"\nclearance_mm = nan"), HasSubstr("must be a number"));
    EXPECT_THAT(error_of(with("[[object]]\nname = \"a\"\nshape = { box_mm = [1, 2] }")),
                HasSubstr("dir/c.toml:33:20: 'box_mm' must be [x, y, z], each greater than 0"));
    EXPECT_THAT(error_of(with("[[object]]\nname = \"a\"\nshape = { sphere_mm = 0 }")),
                HasSubstr("'sphere_mm' must be greater than 0"));
    EXPECT_THAT(error_of(with("[[object]]\nname = \"a\"\nshape = { sphere_mm = 1, box_mm = [1, 1, 1] }")),
                HasSubstr("'shape' must contain one of box_mm, cylinder_mm, sphere_mm, capsule_mm and mesh"));
    EXPECT_THAT(error_of(with("[[object]]\nname = \"a\"\nshape = {}")),
                HasSubstr("'shape' must contain one of box_mm, cylinder_mm, sphere_mm, capsule_mm and mesh"));
    EXPECT_THAT(error_of(with("[[object]]\nname = \"a\"\nshape = { cylinder_mm = [1, inf] }")),
                HasSubstr("'cylinder_mm' must be [diameter, height]"));
    EXPECT_THAT(error_of(with("[[object]]\nname = \"a\"\nshape = { mesh = \"no.stl\" }")),
                HasSubstr("dir/no.stl: No such file"));
    EXPECT_THAT(error_of(with("[[object]]\nname = \"a\"\nshape = { mesh = \"no.stl\", tolerance_mm = 1 }")),
                HasSubstr("'tolerance_mm' is for STEP and IGES files"));
    EXPECT_THAT(error_of(with("[[object]]\nname = \"a\"\nshape = { mesh = \"a.stp\", tolerance_mm = 1e-4 }")),
                HasSubstr("'tolerance_mm' must be from 0.001 to 100"));
    EXPECT_THAT(error_of(with("[[object]]\nname = \"a\"\nshape = { sphere_mm = 1, tolerance_mm = 1 }")),
                HasSubstr("with mesh it may also contain scale and tolerance_mm"));
    EXPECT_THAT(error_of(with("[[object]]\nname = \"post\"\nshape = { sphere_mm = 1 }")),
                HasSubstr("the name 'post' is already used"));
    EXPECT_THAT(error_of(with("[[object]]\nname = \"X\"\nshape = { sphere_mm = 1 }")),
                HasSubstr("the name 'X' is already used"));
    EXPECT_THAT(
        error_of(with("[[object]]\nname = \"a\"\nattached_to = \"tabel\"\nshape = { sphere_mm = 1 }")),
        HasSubstr("'tabel' is not defined above; did you mean 'table'?"));
    EXPECT_THAT(error_of(with("[[shape]]\nname = \"a\"\non = \"post\"\nshape = { sphere_mm = 1 }")),
                HasSubstr("'on' must be \"base\""));
    EXPECT_THAT(error_of(fmt::format("{}{}", "ignore = [[\"head\", \"pots\"]]\n", kWhole)),
                HasSubstr("no object or shape has the name 'pots'"));
    EXPECT_THAT(error_of(fmt::format("{}{}", "ignore = [\"head\"]\n", kWhole)),
                HasSubstr("'ignore' must contain pairs of names"));
    EXPECT_THAT(error_of(fmt::format("{}{}", "ignore = 3\n", kWhole)), HasSubstr("must be a list of pairs"));
}

machine::Machine with_body() {
    machine::Machine machine = af5();
    machine.shapes = {{"hull", "tool", machine::CylinderShape{60, 200}, {.z_mm = 110}},
                      {"bed", "base", machine::BoxShape{10, 20, 30}, {}}};
    machine.ignored = {{0, 1}};
    return machine;
}

TEST(CellFile, IncludesShapesOfMachine) {
    const auto cell =
        read_cell(fmt::format("{}{}", "ignore = [[\"hull\", \"post\"]]\n", kWhole), "c.toml", with_body());
    ASSERT_TRUE(cell) << cell.error().message;
    ASSERT_EQ(cell->items.size(), 6U);
    EXPECT_EQ(cell->items[0].name, "hull");
    EXPECT_EQ(cell->items[0].role, Role::machine);
    EXPECT_EQ(cell->frames.link(cell->items[0].frame), 5);
    EXPECT_EQ(cell->frames.link(cell->items[1].frame), 0);
    EXPECT_EQ(cell->ignored, (std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}, {0, 3}}));
}

TEST(CellFile, RejectsNameUsedInMachineFile) {
    const auto cell =
        read_cell(with("[[object]]\nname = \"bed\"\nshape = { sphere_mm = 1 }"), "c.toml", with_body());
    ASSERT_FALSE(cell);
    EXPECT_EQ(cell.error().message,
              "c.toml:32:8: the name 'bed' is already used by a [[shape]] of the machine file");
}

TEST(CellFile, ToolOfCellReplacesToolOfMachine) {
    const std::string tool = "[[shape]]\nname = \"hull\"\non = \"tool\"\nshape = { sphere_mm = 6 }\n";
    const auto cell = read_cell(with(tool), "c.toml", with_body());
    ASSERT_TRUE(cell) << cell.error().message;
    ASSERT_EQ(cell->items.size(), 6U);
    EXPECT_EQ(cell->items[0].name, "bed");
    EXPECT_EQ(cell->items[5].name, "hull");
    EXPECT_EQ(cell->items[5].shape.radius_mm(), 3);
    EXPECT_EQ(cell->replaced, 1U);
    EXPECT_TRUE(cell->ignored.empty());

    // Its jet does not replace the tool, nor its bodies on an axis.
    machine::Machine machine = with_body();
    machine.shapes.push_back({"spray", "jet", machine::SphereShape{1}, {}});
    machine.ignored = {{1, 2}, {0, 1}};
    const auto includes_jet = read_cell(kWhole, "c.toml", machine);
    ASSERT_TRUE(includes_jet) << includes_jet.error().message;
    EXPECT_EQ(includes_jet->items[0].name, "hull");
    EXPECT_EQ(includes_jet->items.size(), 6U);
    EXPECT_EQ(includes_jet->replaced, 1U);
    EXPECT_EQ(includes_jet->ignored, (std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}}));
}

TEST(CellFile, RejectsMissingMeshOfMachine) {
    machine::Machine machine = with_body();
    machine.shapes[1].form = machine::MeshShape{"none.stl"};
    const auto cell = read_cell(kWhole, "c.toml", machine);
    ASSERT_FALSE(cell);
    EXPECT_THAT(cell.error().message,
                HasSubstr("the shape 'bed' of the machine cannot be read: cannot read 'none.stl': No such"));
}

// Names were compared with all before them, and each body with each, for minutes.
TEST(CellFile, AcceptsManyObjectsAndRejectsTooManyPairs) {
    std::string text = "[cell]\nname = \"c\"\n";
    for (int i = 0; i < 40'000; ++i)
        text += fmt::format("[[object]]\nname=\"o{}\"\nshape={{sphere_mm=1}}\nframe={{x_mm={}}}\n", i, i);
    const std::string heads = "[[shape]]\nname=\"h{}\"\non=\"tool\"\nshape={{sphere_mm=1}}\n";
    const machine::Machine machine = af5();
    for (int i = 0; i < 2; ++i) text += fmt::format(fmt::runtime(heads), i);
    const auto cell = read_cell(text, "c.toml", machine);
    ASSERT_TRUE(cell) << cell.error().message;
    EXPECT_EQ(candidate_pairs(*cell, *machine::make_kinematics(machine)).size(), 80'000U);
    for (int i = 2; i < 26; ++i) text += fmt::format(fmt::runtime(heads), i);
    const auto too_many = read_cell(text, "c.toml", machine);
    ASSERT_FALSE(too_many);
    EXPECT_THAT(
        too_many.error().message,
        HasSubstr(
            "40026 bodies form 1040000 pairs on parts that move relative to each other; at most 1000000"));
}

// For any change of a file, it is read, or rejected with a source location.
TEST(CellFile, ReadsOrRejectsMangledFiles) {
    std::mt19937 random(9);
    const machine::Machine machine = af5();
    constexpr std::string_view kBits("\0\n[]{}=\"'.,1e-#", 15);
    for (int i = 0; i < 2000; ++i) {
        std::string text = fmt::format("{}{}", "ignore = [[\"head\", \"post\"]]\n", kWhole);
        for (unsigned change = random() % 4; change > 0; --change)
            text[random() % text.size()] = kBits[random() % kBits.size()];
        if (random() % 3 == 0) text.resize(random() % text.size());
        const auto cell = read_cell(text, "c.toml", machine);
        if (!cell) {
            EXPECT_THAT(cell.error().message, HasSubstr("c.toml:"));
        }
        const auto files = read_cell_files(text, "c.toml");
        if (!files) {
            EXPECT_THAT(files.error().message, HasSubstr("c.toml:"));
        }
    }
}

}  // namespace
}  // namespace gsim::cell::cell_file_test
