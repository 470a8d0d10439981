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

Kind kind_of(MoveKind kind) {
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

std::string shown(const Point& point) {
    return text::joined(point, " ", "{:.6f}");
}

void expect_arc(const Move& wanted, const simulation::RecordedMove& found) {
    ASSERT_TRUE(found.arc);
    const Eigen::Vector3d& normal = found.info.normal;
    const Eigen::Vector3d axis = found.info.kind == MoveKind::arc_ccw ? normal : Eigen::Vector3d(-normal);
    EXPECT_LT((axis - wanted.axis).norm(), kTolerance)
        << "found  " << axis.transpose() << "\nwanted " << wanted.axis.transpose();
    EXPECT_EQ(normal, simulation::told_normal(normal));
    EXPECT_EQ(found.info.turns, wanted.turns);
    const Eigen::Vector3d apart = found.arc->center - wanted.centre;
    EXPECT_LT((apart - apart.dot(axis) * axis).norm(), kTolerance);
}

void expect_move(const Move& wanted, const script::Outcome& run, std::size_t n) {
    const simulation::RecordedMove& found = run.moves[n];
    ASSERT_EQ(kind_of(found.info.kind), wanted.kind);
    if (wanted.time_s) {
        EXPECT_NEAR(run.seconds(n), *wanted.time_s, kTolerance * (1 + *wanted.time_s));
    }
    if (wanted.kind == Kind::dwell) return;
    const Point end = end_of(run, n);
    EXPECT_LT((end - wanted.end).cwiseAbs().maxCoeff(), kTolerance)
        << "found  " << shown(end) << "\nwanted " << shown(wanted.end);
    EXPECT_NEAR(found.length_mm, wanted.length_mm, kTolerance * (1 + wanted.length_mm * 1e-3));
    if (wanted.kind == Kind::arc) expect_arc(wanted, found);
    if (wanted.kind != Kind::rapid) {
        EXPECT_NEAR(found.info.feed_per_min, wanted.feed_per_min, kTolerance * (1 + wanted.feed_per_min));
    }
}

void expect_same(const Reading& wanted, const script::Outcome& run) {
    ASSERT_TRUE(run.completed()) << run.line() << ": " << run.message();
    const std::vector<std::size_t> found = real_moves(run);
    for (std::size_t i = 0; i < std::min(found.size(), wanted.moves.size()); ++i) {
        SCOPED_TRACE(fmt::format("move {} in line {}", i + 1, run.moves[found[i]].info.place.line));
        expect_move(wanted.moves[i], run, found[i]);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_EQ(found.size(), wanted.moves.size());
}

// GSIM_ROUNDTRIP_PROGRAMS requests more of them than the test needs day by day.
unsigned programs() {
    const char* const wanted = std::getenv("GSIM_ROUNDTRIP_PROGRAMS");
    return wanted == nullptr ? kPrograms : static_cast<unsigned>(std::strtoul(wanted, nullptr, 10));
}

void run_all(Dialect dialect) {
    const unsigned count = programs();
    std::size_t moves = 0, left_out = 0;
    const std::array<Point, 9> systems = stored_systems();
    for (unsigned seed = 1; seed <= count; ++seed) {
        const Program program = random_program(dialect, seed);
        const std::string text = program_text(program, seed);
        const Reading wanted = read(program, systems);
        if (wanted.fragile || wanted.too_long) {
            ++left_out;
            continue;
        }
        const script::Outcome found = script::run(text, conditions(dialect));
        SCOPED_TRACE(fmt::format("seed {}\n{}\n{}", seed, text, found.lua));
        expect_same(wanted, found);
        if (testing::Test::HasFailure()) return;
        moves += wanted.moves.size();
    }
    EXPECT_LT(left_out, 1 + count / 10);
    EXPECT_GT(moves, count * 20);
}

TEST(RoundTrip, AllenBradley) {
    run_all(Dialect::ab9);
}

TEST(RoundTrip, Rs274Ngc) {
    run_all(Dialect::ngc);
}

}  // namespace
}  // namespace gsim::roundtrip::roundtrip_test
