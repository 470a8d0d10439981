// Random paths for machines with a TCP that moves when axes turn: after writing, translation and run, the TCP
// follows the path, at its points and between them.
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

namespace gsim::path::coupled_round_trip_test {
namespace {

using Eigen::Vector3d;
using simulation::MoveKind;

constexpr double kTolerance_mm = 0.01;
constexpr int kSamples = 40;  // of each segment
constexpr int kPoints = 12;

struct Coupled {
    std::string machine, post;
    Vector3d middle;  ///< Centre of a reachable box in the work frame.
    double resolution_mm, digit_deg;
};

/// Lines and arcs about the middle, the tool's axis up to 25 degrees off the vertical.
Program random_path(std::mt19937& random, const Vector3d& middle) {
    const auto number = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto point = [&] {
        Point new_point;
        new_point.position_mm = {middle.x() + number(-40, 40), middle.y() + number(-40, 40),
                                 middle.z() + number(-15, 15)};
        const double tilt = number(0.02, 0.4);
        const double azimuth = number(-3, 3);
        new_point.orientation = ToolAxis{
            {std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt)}};
        new_point.feed_mm_min = std::round(number(500, 3000));
        return new_point;
    };
    std::vector<Target> targets{point()};
    std::get<Point>(targets[0]).motion = MotionType::rapid;
    for (int i = 1; i < kPoints; ++i) {
        Point next = point();
        const Vector& before = std::get<Point>(targets.back()).position_mm;
        if (i % 3 == 0) {
            next.motion = MotionType::circular;
            Vector via{};
            for (std::size_t k = 0; k < 3; ++k)
                via[k] = (before[k] + next.position_mm[k]) / 2 + number(-9, 9);
            next.arc = ViaPoint{via};
        }
        if (i % 4 == 1) next.orientation.reset();
        targets.emplace_back(next);
    }
    return {"n", {{"root", std::move(targets)}}, 0};
}

void expect_tip_on_path(const PathFile& file, const Coupled& setup) {
    const machine::Machine machine =
        machine::load_machine(tests::source_path("samples/machines/") + setup.machine + ".toml").value();
    const codegen::Post post = codegen::find_post(setup.post).value();
    const double digits = 2 * setup.resolution_mm + 400 * setup.digit_deg * std::numbers::pi / 180;
    engine::PathProgramOptions options;
    options.tolerance_mm = kTolerance_mm;
    options.name = "part";
    const auto program = engine::PathProgram::plan(file, machine, post, options);
    ASSERT_TRUE(program) << program.error().message;
    EXPECT_FALSE(program->notes().empty()) << "pieces are told of";
    std::string text;
    program->write(
        [&text](const std::string&) { return [&text](std::string_view chunk) { text += chunk; }; });
    script::Conditions conditions;
    conditions.machine = machine;
    conditions.options.dialect = post.dialect;
    const script::Outcome run = script::run(text, conditions);
    ASSERT_TRUE(run.completed()) << run.message();

    const auto kinematics = machine::make_kinematics(run.machine);
    const auto tcp = [&](const rrs::JointPos& joints) {
        return Vector3d(kinematics->forward(joints).translation());
    };
    const std::vector<Target>& targets = file.program.paths[0].targets;
    Vector3d at = to_eigen(std::get<Point>(targets[0]).position_mm);
    Vector3d axis = Vector3d::UnitZ();
    std::size_t target = 0, segment = 0;
    for (const simulation::RecordedMove& move : run.moves) {
        if (move.info.kind == MoveKind::dwell) continue;
        const Point& point = std::get<Point>(targets.at(target));
        const Vector3d end = to_eigen(point.position_mm);
        std::optional<ArcShape> arc;
        if (point.motion == MotionType::circular) arc = arc_shape({at.x(), at.y(), at.z()}, point).value();
        for (; segment < run.segments.size() && run.segments[segment].start_s < move.end_s - 1e-9;
             ++segment) {
            const motion::Segment& each = run.segments[segment];
            for (int k = 0; target > 0 && k <= kSamples; ++k) {
                const Vector3d position = tcp(each.position_at(each.duration_s * k / kSamples));
                ASSERT_LT(off_the_way(position, at, end, arc), 1.2 * kTolerance_mm + digits) << target;
            }
        }
        if ((tcp(move.end) - end).norm() > digits) continue;
        if (point.orientation) axis = to_eigen(std::get<ToolAxis>(*point.orientation).direction);
        EXPECT_LT((kinematics->forward(move.end).linear().col(2) - axis).norm(), 0.1 * setup.digit_deg)
            << target;
        at = end;
        ++target;
        if (target == targets.size()) break;
    }
    EXPECT_EQ(target, targets.size()) << text.substr(0, 3000);
}

class CoupledRoundTrip : public testing::TestWithParam<Coupled> {};

TEST_P(CoupledRoundTrip, TcpFollowsPath) {
    std::mt19937 random(11);
    expect_tip_on_path({random_path(random, GetParam().middle), "f", {}, {}}, GetParam());
}

// The TCP reaches its feed in each part, while axes on ramps of their own would be out of proportion.
TEST(TurningHead, KeepsTcpOnLine) {
    std::vector<Target> targets(2, Point{});
    auto& start = std::get<Point>(targets[0]);
    auto& end = std::get<Point>(targets[1]);
    start.motion = MotionType::rapid;
    start.position_mm = {1000, 1000, 300};
    end.position_mm = {1300, 1100, 300};
    start.orientation.emplace(ToolAxis{{0, 0, 1}});
    end.orientation.emplace(ToolAxis{{0.36, 0.48, 0.8}});
    end.feed_mm_min = 2000;
    expect_tip_on_path({{"n", {{"root", std::move(targets)}}, 0}, "f", {}, {}},
                       {"gantry-offset-head", "rs274ngc", {}, 1e-4, 1e-4});
}

INSTANTIATE_TEST_SUITE_P(
    All, CoupledRoundTrip,
    testing::Values(Coupled{"gantry-offset-head", "rs274ngc", {1200, 1000, 300}, 1e-4, 1e-4},
                    Coupled{"gantry-offset-head", "ab9", {1200, 1000, 300}, 1e-3, 1e-3},
                    Coupled{"mill-head-table", "rs274ngc", {0, 0, 100}, 1e-4, 1e-4},
                    Coupled{"mill-table-table", "rs274ngc", {0, 0, 60}, 1e-4, 1e-4},
                    Coupled{"mill-table-table", "fanuc", {0, 0, 60}, 1e-3, 1e-3}));

}  // namespace
}  // namespace gsim::path::coupled_round_trip_test
