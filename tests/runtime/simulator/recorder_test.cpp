#include "runtime/report/recorder.h"

#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/services/default_planner.h"
#include "runtime/simulator/make_planner_setup.h"
#include "tests/runtime/simulator/test_segments.h"

namespace gsim::simulation::recorder_test {
namespace {

using testing::ElementsAre;

class ListOutput : public RunOutput {
  public:
    void begin(const rrs::JointPos& start) override { started_at = start; }
    void on_segment(const motion::Segment&, const MoveInfo& info) override {
        segment_ids.push_back(info.target_id);
    }
    void on_move(const RecordedMove& move) override { moves.push_back(move); }
    void end(double end_s) override { ended_at_s = end_s; }

    rrs::JointPos started_at;
    std::vector<rrs::TargetId> segment_ids;
    std::vector<RecordedMove> moves;
    double ended_at_s = -1;
};

MoveInfo info(rrs::TargetId id, MoveKind kind, bool process_on = false) {
    return {.target_id = id,
            .kind = kind,
            .location = {0, static_cast<std::uint32_t>(id)},
            .process_on = process_on};
}

class RecorderTest : public testing::Test {
  protected:
    RecorderTest() { recorder.add_output(output); }

    Report finish() {
        Report report;
        recorder.finish(report);
        return report;
    }

    machine::Machine machine = af5();
    Recorder recorder{machine, joints(0, 0)};
    ListOutput output;
};

// 100 mm at 50 mm/s and 100 mm/s2: two ramps of 0.5 s with 12.5 mm each, 75 mm at speed, 2.5 s in all.
TEST_F(RecorderTest, SumsTimesAndLengthsByKind) {
    recorder.expect(info(1, MoveKind::rapid));
    recorder.expect(info(2, MoveKind::linear, true));
    recorder.expect(info(3, MoveKind::dwell));
    recorder.expect(info(4, MoveKind::linear));
    recorder.on_segment(line(1, 0, joints(0, 0), joints(100, 0)));
    recorder.on_segment(line(2, 2.5, joints(100, 0), joints(100, 200)));  // 4.5 s
    recorder.on_segment(standstill(3, 7, joints(100, 200), 0.75));
    recorder.on_segment(line(4, 7.75, joints(100, 200), joints(200, 200)));
    const Report report = finish();
    EXPECT_EQ(report.source.machine, machine.name);
    EXPECT_DOUBLE_EQ(report.cycle_time_s, 10.25);
    EXPECT_DOUBLE_EQ(report.times.rapid_s, 2.5);
    EXPECT_DOUBLE_EQ(report.times.feed_s, 7);
    EXPECT_DOUBLE_EQ(report.times.dwell_s, 0.75);
    EXPECT_DOUBLE_EQ(report.distances.rapid_mm, 100);
    EXPECT_DOUBLE_EQ(report.distances.feed_mm, 300);
    EXPECT_DOUBLE_EQ(report.distances.process_on_mm, 200);
    EXPECT_EQ(report.counts.moves, 4u);
    EXPECT_DOUBLE_EQ(output.ended_at_s, 10.25);
    ASSERT_EQ(output.moves.size(), 4u);
    EXPECT_DOUBLE_EQ(output.moves[2].start_s, 7);
    EXPECT_DOUBLE_EQ(output.moves[2].end_s, 7.75);
    EXPECT_EQ(output.moves[3].n, 4u);
    EXPECT_EQ(output.moves[3].end, joints(200, 200));
}

TEST_F(RecorderTest, SegmentsOfTargetAreOneMoveAndStandstillIsDwell) {
    recorder.expect(info(1, MoveKind::linear));
    recorder.on_segment(line(1, 0, joints(0, 0), joints(100, 0)));
    recorder.on_segment(standstill(1, 2.5, joints(100, 0), 1));
    const Report report = finish();
    EXPECT_DOUBLE_EQ(report.times.feed_s, 2.5);
    EXPECT_DOUBLE_EQ(report.times.dwell_s, 1);
    ASSERT_EQ(output.moves.size(), 1u);
    EXPECT_DOUBLE_EQ(output.moves[0].end_s, 3.5);
    EXPECT_DOUBLE_EQ(output.moves[0].length_mm, 100);
}

TEST_F(RecorderTest, CountsDwellButNotMoveToSamePosition) {
    recorder.expect(info(1, MoveKind::linear));
    recorder.expect(info(2, MoveKind::dwell));
    recorder.expect(info(3, MoveKind::linear));
    recorder.on_segment(line(1, 0, joints(0, 0), joints(0, 0)));
    recorder.on_segment(standstill(2, 0, joints(0, 0), 0));
    recorder.on_segment(line(3, 0, joints(0, 0), joints(100, 0)));
    EXPECT_EQ(finish().counts.moves, 2u);
    ASSERT_EQ(output.moves.size(), 2u);
    EXPECT_EQ(output.moves[0].info.target_id, 2);
    EXPECT_EQ(output.moves[1].n, 2u);
}

TEST_F(RecorderTest, SkipsTargetsWithoutSegment) {
    for (rrs::TargetId id = 1; id <= 4; ++id) recorder.expect(info(id, MoveKind::linear));
    recorder.on_segment(line(3, 0, joints(0, 0), joints(100, 0)));
    EXPECT_EQ(finish().counts.moves, 1u);
    EXPECT_THAT(output.segment_ids, ElementsAre(3));
}

TEST_F(RecorderTest, UnexpectedSegmentCountsOnlyInTime) {
    recorder.expect(info(2, MoveKind::rapid));
    recorder.on_segment(line(99, 0, joints(0, 0), joints(100, 0)));
    recorder.on_segment(line(2, 2.5, joints(100, 0), joints(0, 0)));
    const Report report = finish();
    EXPECT_DOUBLE_EQ(report.times.feed_s, 2.5);
    EXPECT_DOUBLE_EQ(report.times.rapid_s, 2.5);
    EXPECT_EQ(report.counts.moves, 1u);
}

TEST_F(RecorderTest, LimitOfLongestSegmentIsLimitOfMove) {
    using motion::LimitKind;
    const auto on_segment = [&](double start_s, double x0, double x1, motion::LimitCause limited_by) {
        motion::Segment segment = line(1, start_s, joints(x0, 0), joints(x1, 0));
        segment.limited_by = limited_by;
        recorder.on_segment(segment);
    };
    recorder.expect(info(1, MoveKind::linear));
    recorder.expect(info(2, MoveKind::dwell));
    on_segment(0, 0, 100, {LimitKind::corner, -1});          // 2.5 s
    on_segment(2.5, 100, 300, {LimitKind::joint_speed, 0});  // 4.5 s
    on_segment(7, 300, 400, {LimitKind::acceleration, 0});   // 2.5 s
    recorder.on_segment(standstill(1, 9.5, joints(400, 0), 100));
    recorder.on_segment(standstill(2, 109.5, joints(400, 0), 1));
    const Report report = finish();
    ASSERT_EQ(output.moves.size(), 2u);
    EXPECT_EQ(output.moves[0].limited_by, (motion::LimitCause{LimitKind::joint_speed, 0}));
    EXPECT_FALSE(output.moves[1].limited_by);
    EXPECT_EQ(report.slowest[0].limited_by, "joint X speed");
    EXPECT_EQ(report.slowest[1].limited_by, "");
}

TEST_F(RecorderTest, EmptyRunHasNoTimeAndNoMoves) {
    const Report report = finish();
    EXPECT_EQ(report.cycle_time_s, 0);
    EXPECT_EQ(report.counts.moves, 0u);
    EXPECT_TRUE(report.slowest.empty());
    EXPECT_EQ(output.ended_at_s, 0);
    ASSERT_EQ(report.bounds.size(), 5u);
    EXPECT_EQ(report.bounds[1].limit_max, 2438.4);
}

// An arc from 45 deg over 180 deg passes the top and the leftmost point of its circle; neither is an end.
TEST_F(RecorderTest, BoundsIncludeQuadrantsOfArc) {
    recorder.expect(info(1, MoveKind::arc_ccw));
    recorder.on_segment(arc(1, 0, 500, 600, 100, 45, 180));
    const Report report = finish();
    const double half = 100 * std::sqrt(0.5);
    EXPECT_NEAR(report.bounds[0].min, 0, 1e-12);  // the start position
    EXPECT_NEAR(report.bounds[0].max, 500 + half, 1e-9);
    EXPECT_NEAR(report.bounds[1].max, 700, 1e-9);
    ASSERT_TRUE(output.moves[0].arc);
    EXPECT_EQ(output.moves[0].arc->center.x(), 500);
}

TEST(Recorder, BoundsIncludeFullCircleAndStartPosition) {
    const machine::Machine machine = af5();
    Recorder recorder(machine, joints(600, 600));
    recorder.expect(info(1, MoveKind::arc_ccw));
    recorder.on_segment(arc(1, 0, 500, 600, 100, 0, 360));
    Report report;
    recorder.finish(report);
    EXPECT_NEAR(report.bounds[0].min, 400, 1e-9);
    EXPECT_NEAR(report.bounds[0].max, 600, 1e-9);
    EXPECT_NEAR(report.bounds[1].min, 500, 1e-9);
    EXPECT_NEAR(report.bounds[1].max, 700, 1e-9);
    EXPECT_EQ(report.bounds[2].min, 0);
    EXPECT_EQ(report.bounds[2].max, 0);
}

TEST(Recorder, BoundsAreAxisValuesFromAxisZero) {
    machine::Machine machine = af5();
    machine.axes[0].zero = 1000;
    machine.axes[3].zero = -10;
    Recorder recorder(machine, joints(0, 0));
    recorder.expect(info(1, MoveKind::linear));
    recorder.on_segment(line(1, 0, joints(0, 0), joints(-100, 0, 0, std::numbers::pi / 2)));
    Report report;
    recorder.finish(report);
    EXPECT_NEAR(report.bounds[0].min, 900, 1e-9);
    EXPECT_NEAR(report.bounds[0].max, 1000, 1e-9);
    EXPECT_TRUE(report.bounds[3].rotary);
    EXPECT_NEAR(report.bounds[3].min, -10, 1e-9);
    EXPECT_NEAR(report.bounds[3].max, 80, 1e-9);
}

TEST_F(RecorderTest, ListsTenSlowestWithEarlierOfEqualsFirst) {
    double start_s = 0;
    for (rrs::TargetId id = 1; id <= 15; ++id) {
        recorder.expect(info(id, MoveKind::dwell));
        const double duration_s = static_cast<double>(id % 8);  // 1 .. 7, 0, 1 .. 7
        recorder.on_segment(standstill(id, start_s, joints(0, 0), duration_s));
        start_s += duration_s;
    }
    const Report report = finish();
    std::vector<std::uint32_t> lines;
    for (const SlowBlock& block : report.slowest) lines.push_back(block.location.line);
    EXPECT_THAT(lines, ElementsAre(7, 15, 6, 14, 5, 13, 4, 12, 3, 11));
    EXPECT_EQ(report.slowest[0].duration_s, 7);
}

TEST_F(RecorderTest, SumsOfManyMovesDoNotDrift) {
    constexpr int kCount = 200000;
    for (int i = 0; i < kCount; ++i) {
        recorder.expect(info(i, MoveKind::dwell));
        recorder.on_segment(standstill(i, i * 0.1, joints(0, 0), 0.1));
    }
    EXPECT_DOUBLE_EQ(finish().times.dwell_s, kCount * 0.1);
}

// The planner's own segments: 300 mm of rapid at 508 mm/s and 490.33 mm/s2 do not reach full speed.
TEST(Recorder, RecordsSegmentsOfPlanner) {
    const machine::Machine machine = af5();
    Recorder recorder(machine, joints(0, 0));
    motion::DefaultPlanner planner(make_planner_setup(machine), &recorder);
    ASSERT_EQ(planner.Initialize(), rrs::Status{});
    planner.SelectTargetType(rrs::TargetType::joint);
    planner.SetInitialPosition(rrs::CartPos::Identity(), joints(0, 0), "");
    planner.SelectMotionType(rrs::MotionType::linear);
    planner.SetCartesianPositionSpeed(100);
    const auto go = [&](rrs::TargetId id, MoveKind kind, const rrs::JointPos& to) {
        planner.SetRapid(kind == MoveKind::rapid);
        recorder.expect(info(id, kind));
        const rrs::Status status =
            planner.SetNextTarget(id, rrs::TargetParam::end, rrs::CartPos::Identity(), to, "", 0);
        EXPECT_EQ(status, rrs::Status{}) << planner.last_error().message;
    };
    go(1, MoveKind::rapid, joints(300, 0));
    go(2, MoveKind::rapid, joints(300, 0));
    go(3, MoveKind::linear, joints(300, 200));
    planner.flush();
    Report report;
    recorder.finish(report);
    const double a = 490.33;
    EXPECT_NEAR(report.times.rapid_s, 2 * std::sqrt(300 / a), 1e-9);
    EXPECT_NEAR(report.times.feed_s, 200 / 100.0 + 100 / a, 1e-9);
    EXPECT_NEAR(report.cycle_time_s, report.times.rapid_s + report.times.feed_s, 1e-9);
    EXPECT_EQ(report.counts.moves, 2u);
    EXPECT_NEAR(report.bounds[1].max, 200, 1e-12);
}

}  // namespace
}  // namespace gsim::simulation::recorder_test
