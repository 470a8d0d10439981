// Random paths, written for each controller, translated, run: the tool follows the path, along its lines and
// arcs, to the printed digits.
#include <cmath>
#include <random>
#include <string>

#include <fmt/format.h>

#include "codegen/post/post_file.h"
#include "engine/src/paths/path_program.h"
#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"
#include "tests/lua_lib/run.h"
#include "tests/toolpath/path_distance.h"
#include "tests/toolpath/random_path.h"

namespace gsim::path::round_trip_test {
namespace {

using Eigen::Vector3d;
using simulation::MoveKind;

constexpr int kPrograms = 4;  // for each controller
constexpr double kTolerance_mm = 0.01;
constexpr int kSamples = 5;  // of each segment

machine::Machine with_room(machine::Machine machine) {
    for (machine::Axis& axis : machine.axes) {
        if (axis.kind != machine::AxisKind::linear) continue;
        axis.min = -1e6;
        axis.max = 1e6;
    }
    return machine;
}

machine::Machine without_rotary_axes() {
    return with_room(machine::load_machine(tests::source_path("samples/machines/router3.toml")).value());
}

std::string written(const PathFile& file, const machine::Machine& machine, const codegen::Post& post,
                    const engine::PathProgramOptions& options) {
    const auto program = engine::PathProgram::plan(file, machine, post, options);
    EXPECT_TRUE(program) << program.error().message;
    std::string text;
    if (program) {
        program->write(
            [&text](const std::string&) { return [&text](std::string_view chunk) { text += chunk; }; });
    }
    return text;
}

// Follows a run along a path.
class Follower {
  public:
    Follower(const Program& program, const script::Outcome& run, double resolution_mm, double digit_deg)
        : program_(program), run_(run), digit_mm_(resolution_mm), digit_deg_(digit_deg) {}

    void follow(std::size_t path) {
        for (const Target& target : program_.paths[path].targets) {
            if (const auto* point = std::get_if<Point>(&target)) {
                go_to(*point);
            } else {
                const auto& sub_path = std::get<SubPath>(target);
                for (int i = 0; i < sub_path.repeats; ++i) follow(sub_path.path);
            }
            if (testing::Test::HasFailure()) return;
        }
    }
    /// Returns true if the run has no motion beyond the path.
    bool at_end() const {
        double left_mm = 0;
        for (std::size_t i = next_; i < run_.moves.size(); ++i) left_mm += run_.moves[i].length_mm;
        return left_mm == 0;
    }

  private:
    Vector3d position(const rrs::JointPos& joints) const { return joints.head<3>(); }

    bool has_turned(const rrs::JointPos& joints) const {
        for (const auto& [letter, value_deg] : rotary_) {
            const std::size_t axis = run_.machine.find(letter).value();
            const double value =
                machine::axis_value(run_.machine.axes[axis], joints[static_cast<Eigen::Index>(axis)]);
            if (std::abs(std::remainder(value - value_deg, 360)) > digit_deg_) return false;
        }
        return true;
    }

    void go_to(const Point& point) {
        if (const auto* given = point.orientation ? std::get_if<RotaryAxes>(&*point.orientation) : nullptr) {
            rotary_ = *given;
        }
        std::optional<ArcShape> arc;
        if (point.motion == MotionType::circular) {
            arc = arc_shape({at_.x(), at_.y(), at_.z()}, point).value();
        }
        const Vector3d end = to_eigen(point.position_mm);
        const double length =
            arc ? std::hypot(arc->radius_mm() * arc->turn_rad, arc->rise_mm) : (end - at_).norm();
        double gone = 0;
        // Chords are shorter than their arc, and digits are rounded at both ends of each move.
        const double slack = 1e-4 * length + 20 * digit_mm_;
        const auto arrived = [&] {
            return gone > length - slack && (position(joints_) - end).cwiseAbs().maxCoeff() <= digit_mm_ &&
                   has_turned(joints_);
        };
        while (!arrived() && next_ < run_.moves.size()) {
            const simulation::RecordedMove& move = run_.moves[next_++];
            if (move.info.kind == MoveKind::dwell) continue;
            gone += move.length_mm;
            joints_ = move.end;
            check_path(move, end, arc);
        }
        EXPECT_TRUE(arrived()) << "to " << end.transpose() << "\n" << run_.lua.substr(0, 3000);
        EXPECT_NEAR(gone, length, slack);
        check_feed(point, length);
        at_ = end;
    }

    void check_feed(const Point& point, double length_mm) {
        if (point.feed_mm_min) feed_mm_min_ = *point.feed_mm_min;
        if (point.motion == MotionType::rapid || length_mm < 1) return;
        std::size_t last = next_ - 1;
        while (run_.moves[last].info.kind == MoveKind::dwell || run_.moves[last].length_mm == 0) --last;
        const double expected_value = point.duration_s ? length_mm * 60 / *point.duration_s : feed_mm_min_;
        EXPECT_NEAR(run_.moves[last].info.feed_per_min, expected_value, 0.02);
    }

    void check_path(const simulation::RecordedMove& move, const Vector3d& end,
                    const std::optional<ArcShape>& arc) {
        while (segment_ < run_.segments.size() && run_.segments[segment_].end_s() < move.start_s + 1e-9)
            ++segment_;
        for (std::size_t i = segment_; i < run_.segments.size(); ++i) {
            const motion::Segment& segment = run_.segments[i];
            if (segment.start_s > move.end_s - 1e-9) break;
            for (int k = 0; k <= kSamples; ++k) {
                const double t = segment.start_s + segment.duration_s * k / kSamples;
                EXPECT_LT(off_the_way(position(segment.position_at(t)), at_, end, arc),
                          kTolerance_mm + 3 * digit_mm_);
            }
        }
    }

    const Program& program_;
    const script::Outcome& run_;
    double digit_mm_, digit_deg_;
    Vector3d at_ = Vector3d::Zero();
    rrs::JointPos joints_ = rrs::JointPos::Constant(5, 1e9);
    RotaryAxes rotary_;
    double feed_mm_min_ = 0;
    std::size_t next_ = 0, segment_ = 0;
};

struct Controller {
    std::string post;
    bool rotary_axes = true;
    bool inch = false;
    bool verbose = false;
    double resolution_mm = 0.001, digit_deg = 0.001;
};

class RoundTrip : public testing::TestWithParam<Controller> {};

TEST_P(RoundTrip, ToolFollowsPath) {
    const Controller& controller = GetParam();
    const codegen::Post post = codegen::find_post(controller.post).value();
    const machine::Machine machine =
        controller.rotary_axes ? with_room(script::built_in_machine()) : without_rotary_axes();
    std::mt19937 random(7);
    int done = 0;
    for (int i = 0; i < kPrograms; ++i) {
        RandomPathOptions kind;
        kind.orientations = controller.rotary_axes;
        const PathFile file{random_program(random, kind), "f", {}, {}};
        engine::PathProgramOptions options;
        options.continue_on_unknown = true;  // random paths have actions that are no words
        options.words = {controller.inch, controller.verbose};
        options.tolerance_mm = kTolerance_mm;
        options.name = "part";
        const std::string text = written(file, machine, post, options);
        script::Conditions conditions;
        conditions.machine = machine;
        conditions.options.dialect = post.dialect;
        const script::Outcome run = script::run(text, conditions);
        ASSERT_TRUE(run.completed()) << run.message() << "\n" << text;
        Follower follower(file.program, run, controller.resolution_mm, controller.digit_deg);
        follower.follow(file.program.root);
        EXPECT_TRUE(follower.at_end());
        ASSERT_FALSE(HasFailure()) << text.substr(0, 4000);
        ++done;
    }
    EXPECT_EQ(done, kPrograms);
}

INSTANTIATE_TEST_SUITE_P(All, RoundTrip,
                         testing::Values(Controller{"ab9"}, Controller{"fanuc"}, Controller{"rs274ngc"},
                                         Controller{"ab9", true, true, false, 0.003},
                                         Controller{"rs274ngc", true, false, true}, Controller{"grbl", false},
                                         Controller{"grbl", false, true, false, 0.001}));

}  // namespace
}  // namespace gsim::path::round_trip_test
