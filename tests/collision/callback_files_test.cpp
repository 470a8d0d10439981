// A machine and a cell with all that they name, of files that are on no disk.

#include <map>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/os/files.h"
#include "collision/cell/cell_file.h"
#include "collision/cell/machine_shapes.h"
#include "machine/file/machine_file.h"

namespace gsim::cell::given_files_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kTetrahedron =
    "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// Files by name, and which were asked for.
struct RecordingFiles {
    std::map<std::string, std::string> bytes;
    std::set<std::string> requested;
    os::CallbackFiles files{[this](const std::string& name) -> std::optional<std::string> {
        requested.insert(name);
        const auto found = bytes.find(name);
        return found == bytes.end() ? std::nullopt : std::optional(found->second);
    }};
};

std::string machine_toml() {
    return std::string(machine::built_in_machine_toml()) +
           "\n[controller]\nmodel = \"../rules/own.toml\"\n"
           "\n[[shape]]\nname = \"cover\"\non = \"X\"\nshape = { mesh = \"cover.obj\" }\n";
}

TEST(CallbackFiles, LoadControllerAndMeshesOfMachine) {
    RecordingFiles given;
    given.bytes = {{"shop/af5.toml", machine_toml()},
                   {"rules/own.toml", "[controller]\nstandstill_s = 0.25\n"},
                   {"shop/cover.obj", kTetrahedron}};
    const auto machine = machine::load_machine("shop/af5.toml", os::NameSource::in_file, given.files);
    ASSERT_TRUE(machine) << machine.error().message;
    EXPECT_EQ(machine->controller.standstill.dwell_s, 0.25);
    const auto cell = make_machine_cell(*machine, {.files = given.files});
    ASSERT_TRUE(cell) << cell.error().message;
    ASSERT_EQ(cell->items.back().name, "cover");
    EXPECT_EQ(cell->items.back().shape.triangles()->triangle_count(), 4U);
    EXPECT_THAT(given.requested, ElementsAre("rules/own.toml", "shop/af5.toml", "shop/cover.obj"));
}

TEST(CallbackFiles, LoadMeshesAndSolidsOfCell) {
    RecordingFiles given;
    given.bytes = {{"shop/post.obj", kTetrahedron}};
    const auto machine =
        machine::read_machine(machine::built_in_machine_toml(), "af5.toml", given.files).value();
    std::string requested;
    const auto read_solid = [&requested](const std::filesystem::path& file, double) {
        requested = file.string();
        return Result<solid::Mesh>(solid::Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
    };
    const auto cell = read_cell(
        "[cell]\nname = \"shop\"\n[[object]]\nname = \"post\"\nshape = { mesh = \"post.obj\" }\n"
        "[[object]]\nname = \"mould\"\nshape = { mesh = \"mould.step\" }\n",
        "shop/cell.toml", machine, {}, {given.files, read_solid});
    ASSERT_TRUE(cell) << cell.error().message;
    EXPECT_EQ(requested, "shop/mould.step");
    EXPECT_EQ(cell->items.back().shape.triangles()->triangle_count(), 1U);
}

TEST(CallbackFiles, ReportMissingFileByName) {
    RecordingFiles given;
    const auto machine = machine::read_machine(machine_toml(), "shop/af5.toml", given.files);
    ASSERT_FALSE(machine);
    EXPECT_THAT(machine.error().message, HasSubstr("cannot read 'shop/../rules/own.toml': file not found"));
    const auto bare =
        machine::read_machine(machine::built_in_machine_toml(), "af5.toml", given.files).value();
    const auto cell =
        read_cell("[cell]\nname = \"shop\"\n[[object]]\nname = \"post\"\nshape = { mesh = \"post.obj\" }\n",
                  "shop/cell.toml", bare, {}, {.files = given.files});
    ASSERT_FALSE(cell);
    EXPECT_THAT(cell.error().message, HasSubstr("cannot read 'shop/post.obj': file not found"));
}

TEST(CallbackFiles, RejectTooLargeFile) {
    RecordingFiles given;
    given.bytes = {{"big.toml", std::string(os::kMaxTextFileBytes + 1, ' ')}};
    EXPECT_EQ(given.files.read_text("big.toml").error().message, "'big.toml' is larger than 4 MiB");
}

}  // namespace
}  // namespace gsim::cell::given_files_test
