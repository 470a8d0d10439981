// gsim-run --check-machine, --envelope.

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::machine_studies_test {
namespace {

class MachineStudies : public Apps {
  protected:
    static std::string sample(const std::string& name) { return tests::source_path("samples/") + name; }
};

TEST_F(MachineStudies, SelfCollidingArmReturnsStatusOne) {
    const Ended e = gsim_run({"--check-machine", sample("machines/arm6.toml"), "--json"});
    EXPECT_EQ(e.status, 1) << e.err;
    const auto json = text::parse_json<nlohmann::json>(e.out);
    EXPECT_EQ(json["machine"], "6-joint arm, PUMA 560");
    EXPECT_EQ(json["pairs"].size(), 15U);
    EXPECT_EQ(gsim_run({"--check-machine", sample("machines/arm6.toml"), "--quiet"}).out, "");
}

TEST_F(MachineStudies, RouterHasNoErrors) {
    const Ended e = gsim_run({"--check-machine", sample("machines/router3.toml")});
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_TRUE(contains(e.out, "clean: no errors found")) << e.out;
}

TEST_F(MachineStudies, ChecksObjectsOfCell) {
    const std::string cell =
        write("vice.toml",
              "[cell]\nname = \"vice\"\n"
              "[[object]]\nname = \"jaw\"\nshape = { sphere_mm = 40 }\nframe = { x_mm = 300, y_mm = 90 }\n"
              "[[shape]]\nname = \"cutter\"\non = \"tool\"\nshape = { capsule_mm = [6, 30] }\n");
    const Ended e = gsim_run({"--check-machine", sample("machines/router3.toml"), "--cell", cell});
    EXPECT_EQ(e.status, 1) << e.err;
    EXPECT_TRUE(contains(e.out, "cutter and jaw")) << e.out;
}

TEST_F(MachineStudies, ReportsFileAndOptionErrorsAsUsageErrors) {
    const Ended e = gsim_run({"--check-machine", write("bad.toml", "[machine]\nname = 3\n")});
    EXPECT_EQ(e.status, 2);
    EXPECT_TRUE(contains(e.err, "bad.toml:2:8: 'name' must be a string")) << e.err;
    const std::string router = sample("machines/router3.toml");
    EXPECT_EQ(gsim_run({"--check-machine", router, write("part.nc", "G0 X1\n")}).status, 2);
    EXPECT_EQ(gsim_run({"--check-machine", router, "--machine", router}).status, 2);
    EXPECT_EQ(gsim_run({"--machine", router, "--envelope", "out.obj"}).status, 2);
    const Ended endless = gsim_run({"--machine", sample("machines/unlimited.toml"), "--envelope", "out.stl"});
    EXPECT_EQ(endless.status, 2);
    EXPECT_TRUE(contains(endless.err, "axis X has an unlimited range")) << endless.err;
    EXPECT_FALSE(exists("out.stl"));
}

TEST_F(MachineStudies, EnvelopeFormatFollowsFileExtension) {
    const Ended e = gsim_run({"--machine", sample("machines/router3.toml"), "--envelope", "out.stl",
                              "--envelope", "out.csv", "--envelope", "out.svg"});
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_TRUE(contains(e.out, "volume: 28.8 l, 12 triangles, exact")) << e.out;
    EXPECT_EQ(read("out.stl").size(), 84U + 12 * 50);
    EXPECT_TRUE(contains(read("out.csv"), "X Y,plane,1,1,600,400,0\n")) << read("out.csv");
    EXPECT_TRUE(contains(read("out.svg"), "X to the right, Y up")) << read("out.svg");
}

TEST_F(MachineStudies, WritesAxisPicture) {
    const Ended e = gsim_run({"--machine", sample("machines/router3.toml"), "--draw-axes", "axes.svg"});
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_TRUE(contains(read("axes.svg"), "+Y moves the tool to the back (+y)")) << read("axes.svg");
    const Ended bad = gsim_run({"--machine", sample("machines/router3.toml"), "--draw-axes", "axes.bmp"});
    EXPECT_EQ(bad.status, 2);
    EXPECT_TRUE(contains(bad.err, "axes.bmp: the picture of the axes must be a file that ends in .svg"))
        << bad.err;
}

TEST_F(MachineStudies, RejectsRunOptions) {
    for (const std::string option : {"--moves", "--plot", "--report", "--record"}) {
        const Ended e = gsim_run({"--check-machine", sample("machines/router3.toml"), option, "file"});
        EXPECT_EQ(e.status, 2);
        EXPECT_TRUE(contains(e.err, "run no program")) << e.err;
        EXPECT_FALSE(exists("file"));
    }
}

}  // namespace
}  // namespace gsim::apps::machine_studies_test
