// Random programs of both dialects: translated and run, they make the moves that a plain evaluator of the
// same programs, written a second time from the manuals, says they make.

#include <cstdlib>

#include <fmt/format.h>

#include "base/text/format.h"
#include "tests/lua_lib/ngc_run.h"
#include "tests/lua_lib/roundtrip/roundtrip_generator.h"
#include "tests/lua_lib/roundtrip/roundtrip_interpreter.h"
#include "tests/lua_lib/roundtrip/roundtrip_text.h"

namespace gsim::roundtrip::roundtrip_test {
namespace {

using simulation::MoveKind;

constexpr double kTolerance = 1e-6;
constexpr double kStill = 1e-7;  // a shorter move counts as none
constexpr unsigned kPrograms = 150;

constexpr const char* kSystems[] = {"54", "55", "56", "57", "58", "59", "59.1", "59.2", "59.3"};

// Returns the stored values of the work coordinate systems: those of the first ones.
std::array<Point, 9> stored_systems() {
    std::array<Point, 9> systems;
    for (std::size_t i = 0; i < systems.size(); ++i) {
        systems[i].setZero();
        if (i < 5)
            systems[i].head<4>() << 10.0 * static_cast<double>(i), -7.5, 3.25, 5.0 * static_cast<double>(i);
    }
    return systems;
}

script::Conditions conditions(Dialect dialect) {
    script::Conditions setup = script::ngc_conditions();
    setup.options.dialect = dialect == Dialect::ab9 ? "ab9" : "rs274ngc";
    setup.options.data.tools.clear();
    for (int tool = 1; tool <= 3; ++tool) setup.options.data.tools[tool] = {};
    const std::array<Point, 9> systems = stored_systems();
    for (std::size_t i = 0; i < systems.size(); ++i)
        for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
            setup.options.data.offsets[kSystems[i]][kAxes[axis]] =
                systems[i][static_cast<Eigen::Index>(axis)];
    return setup;
}

Kind program_kind(MoveKind kind) {
    if (kind == MoveKind::rapid) return Kind::rapid;
    if (kind == MoveKind::linear) return Kind::linear;
    if (kind == MoveKind::dwell) return Kind::dwell;
    EXPECT_TRUE(kind == MoveKind::arc_cw || kind == MoveKind::arc_ccw);
    return Kind::arc;
}

Point end_of(const script::Outcome& run, std::size_t n) {
    Point point;
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
        point[static_cast<Eigen::Index>(axis)] = run.to(n, kAxes[axis]);
    return point;
}

// The moves that go anywhere, by their numbers.
std::vector<std::size_t> real_moves(const script::Outcome& run) {
    std::vector<std::size_t> real;
    Point at = Point::Zero();
    for (std::size_t n = 0; n < run.moves.size(); ++n) {
        const Point end = end_of(run, n);
        const MoveKind kind = run.moves[n].info.kind;
        const bool is_line = kind == MoveKind::rapid || kind == MoveKind::linear;
        if (!is_line || (end - at).norm() >= kStill) real.push_back(n);
        at = end;
    }
    return real;
}

std::string display_text(const Point& point) {
    return text::joined(point, " ", "{:.6f}");
}

void expect_arc(const Move& expected_value, const simulation::RecordedMove& found) {
    ASSERT_TRUE(found.arc);
    const Eigen::Vector3d& normal = found.info.normal;
    const Eigen::Vector3d axis = found.info.kind == MoveKind::arc_ccw ? normal : Eigen::Vector3d(-normal);
    EXPECT_LT((axis - expected_value.axis).norm(), kTolerance)
        << "found  " << axis.transpose() << "\nwanted " << expected_value.axis.transpose();
    EXPECT_EQ(normal, simulation::canonical_normal(normal));
    EXPECT_EQ(found.info.turns, expected_value.turns);
    const Eigen::Vector3d apart = found.arc->center - expected_value.centre;
    EXPECT_LT((apart - apart.dot(axis) * axis).norm(), kTolerance);
}

void expect_move(const Move& expected_value, const script::Outcome& run, std::size_t n) {
    const simulation::RecordedMove& found = run.moves[n];
    ASSERT_EQ(program_kind(found.info.kind), expected_value.kind);
    if (expected_value.time_s) {
        EXPECT_NEAR(run.seconds(n), *expected_value.time_s, kTolerance * (1 + *expected_value.time_s));
    }
    if (expected_value.kind == Kind::dwell) return;
    const Point end = end_of(run, n);
    EXPECT_LT((end - expected_value.end).cwiseAbs().maxCoeff(), kTolerance)
        << "found  " << display_text(end) << "\nwanted " << display_text(expected_value.end);
    EXPECT_NEAR(found.length_mm, expected_value.length_mm,
                kTolerance * (1 + expected_value.length_mm * 1e-3));
    if (expected_value.kind == Kind::arc) expect_arc(expected_value, found);
    if (expected_value.kind != Kind::rapid) {
        EXPECT_NEAR(found.info.feed_per_min, expected_value.feed_per_min,
                    kTolerance * (1 + expected_value.feed_per_min));
    }
}

void expect_same(const Reading& expected_value, const script::Outcome& run) {
    ASSERT_TRUE(run.completed()) << run.line() << ": " << run.message();
    const std::vector<std::size_t> found = real_moves(run);
    for (std::size_t i = 0; i < std::min(found.size(), expected_value.moves.size()); ++i) {
        SCOPED_TRACE(fmt::format("move {} in line {}", i + 1, run.moves[found[i]].info.location.line));
        expect_move(expected_value.moves[i], run, found[i]);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_EQ(found.size(), expected_value.moves.size());
}

// GSIM_ROUNDTRIP_PROGRAMS requests more of them than the test needs day by day.
unsigned programs() {
    const char* const expected_value = std::getenv("GSIM_ROUNDTRIP_PROGRAMS");
    return expected_value == nullptr ? kPrograms
                                     : static_cast<unsigned>(std::strtoul(expected_value, nullptr, 10));
}

void run_all(Dialect dialect) {
    const unsigned count = programs();
    std::size_t moves = 0, left_out = 0;
    const std::array<Point, 9> systems = stored_systems();
    for (unsigned seed = 1; seed <= count; ++seed) {
        const Program program = random_program(dialect, seed);
        const std::string text = program_text(program, seed);
        const Reading expected_value = read(program, systems);
        if (expected_value.fragile || expected_value.too_long) {
            ++left_out;
            continue;
        }
        const script::Outcome found = script::run(text, conditions(dialect));
        SCOPED_TRACE(fmt::format("seed {}\n{}\n{}", seed, text, found.lua));
        expect_same(expected_value, found);
        if (testing::Test::HasFailure()) return;
        moves += expected_value.moves.size();
    }
    EXPECT_LT(left_out, 1 + count / 10);
    EXPECT_GT(moves, count * 20);
}

TEST(RoundTrip, RandomAb9ProgramsMatchEvaluator) {
    run_all(Dialect::ab9);
}

TEST(RoundTrip, RandomRs274NgcProgramsMatchEvaluator) {
    run_all(Dialect::ngc);
}

}  // namespace
}  // namespace gsim::roundtrip::roundtrip_test
