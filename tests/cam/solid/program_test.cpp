// The programs as users run them on STEP and IGES files.

#include <fmt/format.h>

#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"
#include "tests/cam/solid/solids.h"

namespace gsim::apps::program_test {

namespace {

class SolidProgram : public Apps {
  protected:
    Ended autopath(const std::vector<std::string>& arguments) const {
        return run_program(tests::program_path("autopath"), arguments, folder_);
    }
    std::string step(const std::string& name, const TopoDS_Shape& shape) const {
        return solids_.step(name, shape).string();
    }
    const solid::SolidFolder solids_;
};

TopoDS_Shape ring() {
    return solid::without(solid::cylinder({0, 0, 0}, 40, 8), {solid::cylinder({0, 0, -1}, 15, 10)});
}

TEST_F(SolidProgram, InfersThicknessFromPart) {
    const std::string file = step("ring.step", ring());
    const Ended ended = autopath({file, "--material", "aluminum", "--report", "-o", "ring.path.json"});
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_TRUE(contains(ended.err, "2 contours, 2 pierces")) << ended.err;
    EXPECT_TRUE(contains(ended.err, "inferred from the solid")) << ended.err;
    EXPECT_TRUE(contains(read("ring.path.json"), "waterjet_on"));
    const Ended other = autopath({file, "--material", "aluminum", "--thickness", "10", "-o", "b.path.json"});
    const Ended upright = autopath({file, "--material", "aluminum", "--up", "-x", "-o", "c.path.json"});
    EXPECT_TRUE(contains(upright.err, "no planar face that faces -x")) << upright.err;
    EXPECT_TRUE(contains(other.err, "the solid is 8 mm thick, but --thickness is 10 mm")) << other.err;
}

TEST_F(SolidProgram, RejectedInputLeavesNoFile) {
    const auto rejected = [&](const std::vector<std::string>& arguments) {
        std::vector<std::string> all = arguments;
        all.insert(all.end(), {"--speed", "300", "--kerf", "0.8", "-o", "part.path.json"});
        const Ended ended = autopath(all);
        EXPECT_NE(ended.status, 0);
        EXPECT_FALSE(exists("part.path.json"));
        return ended.err;
    };
    const std::string dome = rejected({step("dome.step", solid::sphere({0, 0, 0}, 10))});
    EXPECT_TRUE(contains(dome, "dome.step: the body at ")) << dome;
    const std::string slit =
        rejected({step("slit.step", solid::without(ring(), {solid::box({20, -0.2, -1}, {30, 0.2, 9})}))});
    EXPECT_TRUE(contains(slit, "narrower than the kerf")) << slit;
    EXPECT_TRUE(contains(slit, "line of plane face #")) << slit;
    EXPECT_TRUE(contains(rejected({step("ring.step", ring()), "--unit", "inch"}),
                         "--unit and --layer apply to drawings"));
    EXPECT_TRUE(contains(rejected({write("a.svg", "<svg/>"), "--flip"}),
                         "--up and --flip apply to STEP and IGES files"));
    EXPECT_TRUE(contains(rejected({write("a.step", "ISO-10303-21;\n")}), "a.step: the file is truncated"));
}

TEST_F(SolidProgram, ReportsCollisionWithStepMeshOfCell) {
    const std::string post = step("post.step", solid::cylinder({200, 200, 0}, 10, 20));
    write("cell.toml", fmt::format(R"([cell]
name = "a post"
[[object]]
name = "post"
shape = {{ mesh = "{}", tolerance_mm = 0.01 }}
[[shape]]
name = "tip"
on = "tool"
shape = {{ sphere_mm = 10.0 }}
)",
                                   post));
    EXPECT_EQ(gsim_run({write("by.nc", "G1 X100 Y216 F6000\nX300\n"), "--cell", "cell.toml"}).status, 0);
    const Ended hit = gsim_run({write("hit.nc", "G1 X100 Y214 F6000\nX300\n"), "--cell", "cell.toml"});
    EXPECT_EQ(hit.status, 1) << hit.err;
    EXPECT_TRUE(contains(hit.out, "post")) << hit.out;
}

}  // namespace

}  // namespace gsim::apps::program_test
