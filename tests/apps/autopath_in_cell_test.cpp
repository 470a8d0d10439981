// Paths round obstacles on the machine, checked by the run that detects collisions.

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::autopath_in_cell_test {

namespace {

// Two holes in a plate, 200 mm apart; a block between them, higher than the paths between cuts.
constexpr const char* kHoles =
    "<svg width='300mm' height='60mm' viewBox='0 0 300 60'>"
    "<circle cx='50' cy='30' r='10'/><circle cx='250' cy='30' r='10'/></svg>";
constexpr const char* kPlate = R"(
[[object]]
name = "plate"
role = "workpiece"
shape = { box_mm = [320.0, 80.0, 10.0] }
frame = { x_mm = 650.0, y_mm = 530.0, z_mm = 95.0 }
)";
constexpr const char* kBlock = R"(
[[object]]
name = "block"
shape = { box_mm = [20.0, 60.0, 120.0] }
frame = { x_mm = 650.0, y_mm = 530.0, z_mm = 160.0 }
)";

class AutopathInCell : public Apps {
  protected:
    void SetUp() override { write("holes.svg", kHoles); }

    std::string cell(const std::string& objects) const {
        return write("cell.toml",
                     "[cell]\nname = \"two holes\"\nmachine = \"af5\"\nclearance_mm = 2.0\n" + objects);
    }
    Ended autopath(std::vector<std::string> options) const {
        options.insert(options.begin(), {"holes.svg", "--speed", "400", "--kerf", "1", "--at", "500", "500",
                                         "100", "-o", "holes.path.json"});
        return run_program(tests::program_path("autopath"), options, folder_);
    }
    Ended drive(const std::vector<std::string>& options = {}) const {
        const Ended written = run_program(tests::program_path("path2gcode"),
                                          {"--machine", "af5", "holes.path.json", "-o", "holes.nc"}, folder_);
        EXPECT_EQ(written.status, 0) << written.err;
        std::vector<std::string> arguments{"--cell", "cell.toml", "holes.nc"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return gsim_run(arguments);
    }
};

TEST_F(AutopathInCell, AvoidsBlockThatDirectPathHits) {
    cell(std::string(kPlate) + kBlock);
    ASSERT_EQ(autopath({}).status, 0);
    const Ended hit = drive();
    EXPECT_EQ(hit.status, 1) << hit.out;
    EXPECT_TRUE(contains(hit.out, "block")) << hit.out;
    const Ended outcome = autopath({"--cell", "cell.toml"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "there are no collisions")) << outcome.err;
    const Ended is_clean = drive();
    EXPECT_EQ(is_clean.status, 0) << is_clean.out;
}

TEST_F(AutopathInCell, KeepsPathIfNothingObstructsIt) {
    cell(kPlate);
    ASSERT_EQ(autopath({}).status, 0);
    const std::string without = read("holes.path.json");
    // The machine's home is below the plate, so the first path differs.
    write("on_top.toml",
          "[cell]\nname = \"nothing\"\nmachine = \"af5\"\n[[object]]\nname = \"far\"\n"
          "shape = { box_mm = [10.0, 10.0, 10.0] }\nframe = { x_mm = 1800.0, y_mm = 2400.0, z_mm = 5.0 }\n");
    ASSERT_EQ(autopath({"--cell", "on_top.toml"}).status, 0);
    EXPECT_EQ(read("holes.path.json"), without);
}

TEST_F(AutopathInCell, RejectsHoleBelowClampByName) {
    cell(std::string(kPlate) +
         "[[object]]\nname = \"clamp\"\nshape = { box_mm = [40.0, 40.0, 30.0] }\n"
         "frame = { x_mm = 750.0, y_mm = 530.0, z_mm = 115.0 }\n");
    const Ended outcome = autopath({"--cell", "cell.toml"});
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "contour 2")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "touches 'clamp'")) << outcome.err;
    EXPECT_FALSE(contains(outcome.err, "contour 1")) << outcome.err;
    EXPECT_FALSE(exists("holes.path.json"));
}

TEST_F(AutopathInCell, UsesWorkOffsetOfMachineData) {
    // The same positions, as the program counts them from (500, 500, 100).
    write("cell.toml",
          "[cell]\nname = \"two holes\"\nmachine = \"af5\"\nmachine_data = \"data.txt\"\n"
          "clearance_mm = 2.0\n" +
              std::string(kPlate) + kBlock);
    write("data.txt", "NCFILE\nOFFSET\n54 500 500 100\nENDFILE\n");
    const Ended outcome = run_program(
        tests::program_path("autopath"),
        {"holes.svg", "--speed", "400", "--kerf", "1", "--cell", "cell.toml", "-o", "holes.path.json"},
        folder_);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "of 3 linking moves were rerouted")) << outcome.err;
    const Ended is_clean = drive();
    EXPECT_EQ(is_clean.status, 0) << is_clean.out << is_clean.err;
}

TEST_F(AutopathInCell, ReportsUnreachableContour) {
    cell(kPlate);
    const Ended outcome = run_program(tests::program_path("autopath"),
                                      {"holes.svg", "--speed", "400", "--kerf", "1", "--at", "1700", "500",
                                       "100", "--machine", "af5", "-o", "holes.path.json"},
                                      folder_);
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "contour 2")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "X")) << outcome.err;
}

TEST_F(AutopathInCell, ReportsMissingCellFile) {
    const Ended outcome = autopath({"--cell", "nowhere.toml"});
    EXPECT_NE(outcome.status, 0);
    EXPECT_TRUE(contains(outcome.err, "nowhere.toml")) << outcome.err;
    EXPECT_FALSE(exists("holes.path.json"));
}

}  // namespace

}  // namespace gsim::apps::autopath_in_cell_test
