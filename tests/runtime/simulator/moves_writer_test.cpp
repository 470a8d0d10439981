#include "runtime/outputs/moves_writer.h"

#include <numbers>

#include <gtest/gtest.h>

#include "base/text/json.h"
#include "tests/runtime/simulator/string_stream.h"
#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::moves_writer_test {
namespace {

class MovesWriterTest : public testing::Test {
  protected:
    std::string written(const RecordedMove& move) {
        writer.on_move(move);
        return stream.text();
    }

    machine::Machine machine = af5();
    std::vector<std::string> files{"part.nc"};
    StringStream stream;
    MovesWriter writer{stream.out(), machine, files};
};

RecordedMove move(MoveKind kind) {
    RecordedMove move;
    move.n = 3;
    move.info.kind = kind;
    move.info.location = {0, 12};
    move.info.feed_per_min = 6350;
    move.start_s = 1.5;
    move.end_s = 4;
    move.limited_by = motion::LimitCause{motion::LimitKind::joint_speed, 3};
    move.end = joints(100, -0.0, 1.0 / 3, std::numbers::pi / 2, -1e-15);
    return move;
}

TEST_F(MovesWriterTest, WritesLine) {
    EXPECT_EQ(written(move(MoveKind::linear)),
              R"({"n":3,"file":"part.nc","line":12,"kind":"linear",)"
              R"("to":{"X":100,"Y":0,"Z":0.333333333,"B":90,"C":0},"feed":6350,"start_s":1.5,"end_s":4,)"
              R"("limited_by":"rotary B speed"})"
              "\n");
}

TEST_F(MovesWriterTest, WritesDeviationOfRoundedCorner) {
    RecordedMove recorded = move(MoveKind::linear);
    recorded.deviation_mm = 0.0125;
    EXPECT_EQ(text::parse_json<nlohmann::json>(written(recorded))["deviation_mm"], 0.0125);
}

TEST_F(MovesWriterTest, RapidAndDwellHaveNoFeed) {
    for (const MoveKind kind : {MoveKind::rapid, MoveKind::dwell}) {
        StringStream other;
        MovesWriter(other.out(), machine, files).on_move(move(kind));
        EXPECT_EQ(text::parse_json<nlohmann::json>(other.text())["feed"], nullptr);
    }
}

TEST_F(MovesWriterTest, DwellHasNoLimit) {
    RecordedMove recorded = move(MoveKind::dwell);
    recorded.limited_by.reset();
    EXPECT_EQ(text::parse_json<nlohmann::json>(written(recorded))["limited_by"], nullptr);
}

TEST_F(MovesWriterTest, ArcHasCentreInMachineCoordinates) {
    machine.axes[1].zero = 50;
    RecordedMove recorded = move(MoveKind::arc_cw);
    recorded.info.normal = plane_normal(Plane::zx);
    recorded.info.turns = 2;
    const motion::Segment segment = arc(1, 0, 500, 600, 100, 0, 90);
    recorded.arc = segment.arc;
    recorded.position_joints = segment.position_joints;
    const auto json = text::parse_json<nlohmann::json>(written(recorded));
    EXPECT_EQ(json["kind"], "arc_cw");
    EXPECT_EQ(json["center"], (nlohmann::json{{"X", 500}, {"Y", 650}, {"Z", 0}}));
    EXPECT_EQ(json["plane"], "zx");
    EXPECT_EQ(json["normal"], (nlohmann::json{{"X", 0}, {"Y", 1}, {"Z", 0}}));
    EXPECT_EQ(json["turns"], 2);
}

TEST_F(MovesWriterTest, ObliqueArcHasNormalAndNoPlane) {
    RecordedMove recorded = move(MoveKind::arc_ccw);
    recorded.info.normal = {-0.6, 0.8, 0};
    const auto json = text::parse_json<nlohmann::json>(written(recorded));
    EXPECT_EQ(json["plane"], nullptr);
    EXPECT_EQ(json["normal"], (nlohmann::json{{"X", -0.6}, {"Y", 0.8}, {"Z", 0}}));
}

TEST(ArcNormal, HasPositiveLargestComponent) {
    MoveInfo info;
    set_axis(info, Eigen::Vector3d(0, 0, -3));
    EXPECT_EQ(info.kind, MoveKind::arc_cw);
    EXPECT_EQ(info.normal, Eigen::Vector3d::UnitZ());
    set_axis(info, Eigen::Vector3d(-4, 3, 0));
    EXPECT_EQ(info.kind, MoveKind::arc_cw);
    EXPECT_LT((info.normal - Eigen::Vector3d(0.8, -0.6, 0)).norm(), 1e-12);
    // If parts are equal, the last one counts, whatever rounding makes of them.
    const Eigen::Vector3d uniform = Eigen::Vector3d(-1 - 1e-12, 1, 0).normalized();
    EXPECT_GT(canonical_normal(uniform)[1], 0);
    EXPECT_GT(canonical_normal(-uniform)[1], 0);
    EXPECT_EQ(main_plane(Eigen::Vector3d(0, -1, 1e-12)), Plane::zx);
    EXPECT_EQ(main_plane(Eigen::Vector3d(0, 1, 1e-6).normalized()), std::nullopt);
}

TEST_F(MovesWriterTest, AcceptsLateFilesAndSpecialCharacters) {
    RecordedMove recorded = move(MoveKind::linear);
    recorded.info.location.file = 1;
    files.push_back("a\"\\\n\xff\xc3\xbc.nc");
    EXPECT_EQ(text::parse_json<nlohmann::json>(written(recorded))["file"], "a\"\\\n\ufffd\u00fc.nc");
}

TEST_F(MovesWriterTest, UnknownFileIsNull) {
    RecordedMove recorded = move(MoveKind::linear);
    recorded.info.location.file = 7;
    EXPECT_EQ(text::parse_json<nlohmann::json>(written(recorded))["file"], nullptr);
}

}  // namespace
}  // namespace gsim::simulation::moves_writer_test
