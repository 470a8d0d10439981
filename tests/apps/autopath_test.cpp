// The program as users run it: what it writes, what it says of bad drawings, and that those leave no file.

#include <fmt/format.h>

#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::autopath_test {

namespace {

class AutopathProgram : public Apps {
  protected:
    Ended autopath(const std::vector<std::string>& arguments) const {
        return run_program(tests::program_path("autopath"), arguments, folder_);
    }
    // Cuts a drawing with plain values and writes part.path.json.
    Ended cut(const std::string& name, const std::string& text) const {
        return autopath({write(name, text), "--speed", "300", "--kerf", "0.8", "-o", "part.path.json"});
    }
    void expect_refused(const std::string& name, const std::string& text, const std::string& part) const {
        const Ended ended = cut(name, text);
        EXPECT_NE(ended.status, 0) << text;
        EXPECT_TRUE(contains(ended.err, part)) << ended.err;
        EXPECT_TRUE(contains(ended.err, name)) << ended.err;
        EXPECT_FALSE(exists("part.path.json"));
    }
};

std::string svg(const std::string& content) {
    return fmt::format("<svg width='100mm' height='100mm' viewBox='0 0 100 100'>\n{}\n</svg>", content);
}

std::string dxf(const std::string& entities) {
    return fmt::format("0\nSECTION\n2\nENTITIES\n{}0\nENDSEC\n0\nEOF\n", entities);
}

TEST_F(AutopathProgram, WritesPathFile) {
    const Ended ended = cut("part.svg", svg("<rect width='50' height='30'/><circle cx='20' cy='15' r='5'/>"));
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_TRUE(contains(ended.err, "2 contours, 2 pierces")) << ended.err;
    EXPECT_TRUE(contains(read("part.path.json"), "waterjet_on"));
}

TEST_F(AutopathProgram, ReportsCuttingSpeedOfMaterial) {
    write("part.svg", svg("<rect width='50' height='30'/>"));
    const Ended ended = autopath(
        {"part.svg", "--material", "aluminum", "--thickness", "12", "--report", "-o", "part.path.json"});
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_TRUE(contains(ended.err, "cutting speed")) << ended.err;
    EXPECT_EQ(autopath({"part.svg"}).status, 2);
    EXPECT_TRUE(contains(autopath({"part.svg", "--material", "cheese", "--thickness", "12"}).err, "cheese"));
}

TEST_F(AutopathProgram, ReportsBadGeometryAndWritesNoFile) {
    const std::string line = "0\nLINE\n5\nA1\n8\n0\n10\n0\n20\n0\n11\n10\n21\n0\n";
    expect_refused("part.dxf", dxf(line), "LINE A1 at line 6");
    expect_refused("part.dxf", dxf("0\nLINE\n5\nA2\n10\n3\n20\n4\n11\n3\n21\n4\n"),
                   "LINE A2 at (3, 4) has no length");
    expect_refused("part.dxf", dxf("0\nCIRCLE\n10\n0\n20\nnan\n40\n5\n"), "line 10: 'nan'");
    expect_refused("part.dxf", dxf(line).substr(0, 70), "line");
    expect_refused("part.svg", svg("<path id='p' d='M0 0L10 10L10 0L2 8z'/>"),
                   "path p at line 2 and path p at line 2 meet at (5, 95)");
    expect_refused("part.svg", svg("<path id='p' d='M0 0L10 10L10 0'/>"), "not closed");
    expect_refused("part.svg", svg("<path d='M0 0L10 10L10 0'"), "not valid XML");
    expect_refused("part.txt", "", "neither");
}

TEST_F(AutopathProgram, RejectsMillionEntities) {
    std::string entities;
    for (int i = 0; i < 1'000'000; ++i) entities += "0\nCIRCLE\n10\n0\n20\n0\n40\n5\n";
    expect_refused("part.dxf", dxf(entities), "CIRCLE exceeds the limit of 500000 lines and arcs");
}

}  // namespace

}  // namespace gsim::apps::autopath_test
