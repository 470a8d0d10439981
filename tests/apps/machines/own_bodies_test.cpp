// The machine's own bodies ([[shape]] of its file) are checked in each run, with a cell or without one.

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/apps/robots/slides.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::own_bodies_test {
namespace {

using nlohmann::json;

/// The head's underside comes to the table's top at Z = -70.
constexpr const char* kBodies = R"(
[[shape]]
name = "table"
on = "base"
shape = { box_mm = [500.0, 500.0, 20.0] }
frame = { z_mm = -110.0 }
[[shape]]
name = "head"
on = "Z"
shape = { box_mm = [60.0, 60.0, 60.0] }
)";

class BodiesOfMachine : public Apps {
  protected:
    std::string machine(const std::string& bodies, const std::string& head = {}) const {
        return write("machine.toml", head + "\n" + slides("router with a table") + bodies);
    }
    json run(const std::vector<std::string>& arguments, int status) const {
        std::vector<std::string> all = arguments;
        all.emplace_back("--json");
        const Ended e = gsim_run(all);
        EXPECT_EQ(e.status, status) << e.err << e.out;
        return text::try_parse_json<json>(e.out);
    }
    const std::string part_ = write("part.nc", "G1 X100 F6000\nG1 Z-80\nG1 Z0\nM2\n");
};

TEST_F(BodiesOfMachine, AreCheckedWithAndWithoutCell) {
    const std::string machine_file = machine(kBodies);
    const json report = run({part_, "--machine", machine_file}, 1);
    ASSERT_EQ(report["collisions"].size(), 1U);
    EXPECT_EQ(report["collisions"][0]["pair"], (json{"head", "table"}));
    EXPECT_EQ(report["collisions"][0]["line"], 2);
    EXPECT_NEAR(report["collisions"][0]["t_s"].get<double>(), 1 + 0.7, 1e-6);
    EXPECT_EQ(report["cell"]["name"], "router with a table");
    const std::string empty = write("cell.toml", "[cell]\nname = \"nothing else\"\n");
    const json in_cell = run({part_, "--machine", machine_file, "--cell", empty}, 1);
    EXPECT_EQ(in_cell["collisions"], report["collisions"]);
}

TEST_F(BodiesOfMachine, AreReportedInTextAndByCheck) {
    const std::string machine_file = machine(kBodies);
    EXPECT_TRUE(contains(gsim_run({part_, "--machine", machine_file}).out, "head and table"));
    const Ended quiet = gsim_run({part_, "--machine", machine_file, "--quiet"});
    EXPECT_TRUE(contains(quiet.err, "collisions: 1")) << quiet.err;
    const Ended checked =
        run_program(tests::program_path("gsim"), {"check", "--machine", machine_file, part_}, folder_);
    EXPECT_EQ(checked.status, 1);
    EXPECT_TRUE(contains(checked.out + checked.err, "collision: 'head' and 'table' at 1.700 s"))
        << checked.out;
}

TEST_F(BodiesOfMachine, AreIgnoredOnRequest) {
    const std::string machine_file = machine(kBodies);
    const json report = run({part_, "--machine", machine_file, "--no-collisions"}, 0);
    EXPECT_FALSE(report.contains("cell"));
    EXPECT_FALSE(report.contains("collisions"));
    const std::string cell =
        write("cell.toml",
              "[cell]\nname = \"c\"\n[[object]]\nname = \"post\"\nshape = { sphere_mm = 50.0 }\n"
              "frame = { x_mm = 100.0 }\n");
    const json all = run({part_, "--machine", machine_file, "--cell", cell}, 1)["collisions"];
    EXPECT_EQ(all.size(), 3U) << all;  // the post on the path there and back, the table between
    EXPECT_FALSE(
        run({part_, "--machine", machine_file, "--cell", cell, "--no-collisions"}, 0).contains("cell"));
    EXPECT_EQ(gsim_run({"--check-machine", machine_file}).status, 1);
    EXPECT_EQ(gsim_run({"--check-machine", machine_file, "--no-collisions"}).status, 0);
}

TEST_F(BodiesOfMachine, MayTouchIfPairIsIgnored) {
    const std::string machine_file = machine(kBodies, "ignore = [[\"head\", \"table\"]]");
    EXPECT_TRUE(run({part_, "--machine", machine_file}, 0)["collisions"].empty());
}

TEST_F(BodiesOfMachine, AddNoCellToReportIfMissing) {
    EXPECT_FALSE(run({part_, "--machine", machine("")}, 0).contains("cell"));
}

TEST_F(BodiesOfMachine, AreCheckedForRobots) {
    machine(kBodies);
    write("r.toml", "[[robot]]\nname = \"left\"\nmachine = \"machine.toml\"\n[[robot]]\nname = \"right\"\n");
    const std::string part =
        write("cell.lua", "process('l', function() local _ENV = robot 'left' F(6000) G1{z=-80} end)\n");
    const json report = run({"--robots", "r.toml", part}, 1);
    ASSERT_EQ(report["robots"][0]["collisions"].size(), 1U);
    EXPECT_NEAR(report["robots"][0]["collisions"][0]["t_s"].get<double>(), 0.7, 1e-6);
    EXPECT_TRUE(report["robots"][1]["collisions"].empty());
    EXPECT_FALSE(run({"--robots", "r.toml", part, "--no-collisions"}, 0)["robots"][0].contains("collisions"));
}

TEST_F(BodiesOfMachine, ReportUnreadableMesh) {
    write("head.stl", "solid head\nfacet normal 0 0 1\n");
    const std::string machine_file =
        machine("[[shape]]\nname = \"head\"\non = \"Z\"\nshape = { mesh = \"head.stl\" }\n");
    const Ended e = gsim_run({part_, "--machine", machine_file});
    EXPECT_EQ(e.status, 2);
    EXPECT_TRUE(contains(e.err, "the shape 'head' of the machine cannot be read: ")) << e.err;
    EXPECT_TRUE(contains(e.err, "head.stl")) << e.err;
    EXPECT_EQ(gsim_run({part_, "--machine", machine_file, "--no-collisions"}).status, 0);
}

// The program that reads such files is searched for next to the running one.
TEST_F(BodiesOfMachine, ReportSolidWithoutReader) {
    write("head.step", "ISO-10303-21;\n");
    const std::string machine_file =
        machine("[[shape]]\nname = \"head\"\non = \"Z\"\nshape = { mesh = \"head.step\" }\n");
    const std::filesystem::path standalone = folder_ / "alone" / "gsim";
    std::filesystem::create_directory(standalone.parent_path());
    std::filesystem::copy_file(tests::program_path("gsim"), standalone);
    const Ended e = run_program(standalone, {"run", "--machine", machine_file, part_}, folder_);
    EXPECT_EQ(e.status, 2);
    EXPECT_TRUE(contains(e.err, "the shape 'head' of the machine cannot be read: ")) << e.err;
    EXPECT_TRUE(contains(e.err, "gsim-solid") || contains(e.err, "OpenCASCADE")) << e.err;
    EXPECT_EQ(
        run_program(standalone, {"run", "--machine", machine_file, "--no-collisions", part_}, folder_).status,
        0);
}

// A probe is to touch the work, which no file describes.
TEST_F(BodiesOfMachine, DoNotStopProbeWithoutCell) {
    const std::string part = write("probe.ngc", "G38.2 Z-50 F600\n(debug,#5070)\nG0 Z0\nM2\n");
    const json report = run({part, "--machine", machine(kBodies), "--dialect", "rs274ngc"}, 0);
    EXPECT_NEAR(report["bounds"]["Z"]["min"].get<double>(), -50, 1e-9);
    EXPECT_TRUE(contains(report["warnings"].dump(), "probe")) << report["warnings"];
}

}  // namespace
}  // namespace gsim::apps::own_bodies_test
