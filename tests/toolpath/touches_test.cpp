// Touches that find a work frame: read ones are written, and impossible ones are reported.
#include "toolpath/json/touches.h"

#include <gtest/gtest.h>

#include "toolpath/json/json_reader.h"
#include "toolpath/json/json_writer.h"

namespace gsim::path::touches_test {
namespace {

const std::string kWay = R"("from_mm": [1, 2, 30], "to_mm": -4, "surface_mm": 0, "feed_mm_min": 60)";
const std::string kRapid = R"({"motion": "rapid", "position_mm": [1, 2, 3]})";

Result<PathFile> read(const std::string& keys, const std::string& targets = kRapid) {
    return read_json(R"({"paths": [{"name": "p", )" + keys + R"(, "targets": [)" + targets + "]}]}", "f");
}
std::string error_of(const std::string& keys, const std::string& targets = kRapid) {
    const auto file = read(keys, targets);
    return file ? "no error" : file.error().message;
}
std::string error_of_touch(const std::string& touch) {
    return error_of(R"("work_offset": "G55", "probe_offset": [{)" + touch + "}]");
}

TEST(Touches, RoundTripsThroughJson) {
    const auto file = read(
        R"("work_offset": "G55", "set_offset_mm": [1, 2, 3], "tool": 1, "probe_offset": [{"axis": "Z", )" +
            kWay +
            R"(, "tool": 9}, {"axis": "X", "from_mm": [-9, 0, 1.5], "to_mm": 3, "surface_mm": 1, "feed_mm_min": 5,
                "probe_radius_mm": 2.5}])",
        R"({"path": "q", "work_offset": "56", "probe_offset": [{"axis": "Z", )" + kWay +
            R"(}]}]}, {"name": "q", "targets": [)" + kRapid);
    ASSERT_TRUE(file) << file.error().message;
    const WorkFrame& frame = file->program.paths[0].frame;
    ASSERT_EQ(frame.touches.size(), 2U);
    EXPECT_EQ(frame.touches[0], (Touch{'Z', {1, 2, 30}, -4, 0, 60, 0, 9}));
    EXPECT_EQ(frame.touches[1], (Touch{'X', {-9, 0, 1.5}, 3, 1, 5, 2.5, std::nullopt}));
    EXPECT_EQ(std::get<SubPath>(file->program.paths[0].targets[0]).frame.touches.size(), 1U);
    EXPECT_EQ(read_json(to_json(file->program), "f").value().program, file->program);
}

// The ball touches with its side: its middle is a radius before the surface, from either direction.
TEST(Touches, ContactIsProbeRadiusBeforeSurface) {
    EXPECT_EQ(contact_mm({'X', {-9, 0, 0}, 5, 1, 60, 2, {}}), -1);
    EXPECT_EQ(contact_mm({'Y', {0, 9, 0}, -5, 1, 60, 2, {}}), 3);
    EXPECT_EQ(contact_mm({'Z', {0, 0, 9}, -5, 1, 60, 0, {}}), 1);
}

TEST(Touches, RejectsInvalidTouches) {
    EXPECT_EQ(error_of_touch(kWay), "f:1:65: a touch lacks the key 'axis'");
    EXPECT_EQ(error_of_touch(R"("axis": "B", )" + kWay),
              "f:1:74: 'axis' of a touch must be \"X\", \"Y\" or \"Z\"");
    EXPECT_NE(error_of_touch(R"("axes": "X")").find("unknown key 'axes' in a touch; did you mean 'axis'?"),
              std::string::npos);
    EXPECT_NE(error_of_touch(R"("axis": 1)").find("'axis' must be a string, not a number"),
              std::string::npos);
    EXPECT_NE(
        error_of_touch(R"("from_mm": [1, 2])").find("'from_mm' must contain three numbers; it contains 2"),
        std::string::npos);
    EXPECT_NE(
        error_of_touch(R"("from_mm": 1)").find("'from_mm' must be an array of three numbers, not a number"),
        std::string::npos);
    EXPECT_NE(error_of_touch(R"("to_mm": 1, "to_mm": 1)").find("'to_mm' is given twice"), std::string::npos);
    EXPECT_EQ(
        error_of_touch(
            R"("axis": "Z", "from_mm": [0, 0, 9], "to_mm": 1, "surface_mm": 0, "feed_mm_min": 60)"),
        "f:1:12: along Z the touch moves from 9 to 1 and expects the surface at 0, which must be in between");
    EXPECT_NE(error_of_touch(R"("axis": "Z", "probe_radius_mm": 1, )" + kWay)
                  .find("'probe_radius_mm' is only for touches along X and Y"),
              std::string::npos);
    EXPECT_NE(error_of(R"("work_offset": "G55", "probe_offset": [])")
                  .find("'probe_offset' must contain at least one touch"),
              std::string::npos);
    EXPECT_NE(error_of(R"("probe_offset": [{"axis": "Z", )" + kWay + "}]")
                  .find("'probe_offset' requires 'work_offset'"),
              std::string::npos);
    EXPECT_NE(error_of(R"("work_offset": "G55", "probe_offset": 1)")
                  .find("must be an array of touches, not a number"),
              std::string::npos);
    EXPECT_NE(error_of(R"("work_offset": "G55", "probe_offset": [1])")
                  .find("'probe_offset' must contain objects, each a touch"),
              std::string::npos);
    EXPECT_EQ(error_of(R"("work_offset": "G55", "probe_offset": [{"axis": "Z", )" + kWay + "}]",
                       R"({"position_mm": [1, 2, 3], "feed_mm_min": 1})")
                  .substr(9),
              "the first motion after the touches of 'probe_offset' must be a rapid");
    const std::string otherwise =
        error_of(R"("work_offset": "G55", "tool": 3, "probe_offset": [{"axis": "Z", )" + kWay + "}]",
                 R"({"path": "q", "work_offset": "55", "probe_offset": [{"axis": "Z", "tool": 1, )" + kWay +
                     R"(}]}]}, {"name": "q", "targets": [)" + kRapid);
    EXPECT_NE(otherwise.find("the work offset '55' is measured in two ways"), std::string::npos) << otherwise;
}

}  // namespace
}  // namespace gsim::path::touches_test
