// However a controller rounds or merges, no path of a program is lost: random programs under each controller
// model.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <random>

#include <fmt/format.h>

#include "tests/build_files/build_files.h"
#include "tests/lua_lib/ngc_run.h"

namespace gsim::script::driven_length_test {
namespace {

using Eigen::Vector3d;

constexpr double kTurn_rad = 2 * std::numbers::pi;
constexpr int kPrograms = 24;
constexpr double kGrblChord_mm = 0.002;
constexpr double kRounding_mm = 1e-4;  // of the programs' numbers, of all moves together

// One programmed move: its length, and points on it.
struct Way {
    double length_mm = 0;
    double radius_mm = 0;  // of an arc, else 0
    double sweep_rad = 0;
    double tolerance_mm = 0;  // tolerance of G64 P; 0: none
    double merge_mm = 0;      // of G64 Q
    bool rounds = false;      // in G64
    std::vector<Vector3d> points;
};

struct Program {
    std::string text = "G21 G90 G17 G94 F3000\n";
    std::vector<Way> ways;
};

// If lines may be merged, lengths are those of the remaining lines, so that such programs are checked by
// distance.
class Programs {
  public:
    Programs(unsigned seed, bool merges) : random_(seed), merges_(merges) {}

    Program next() {
        program_ = {};
        at_.setZero();
        mode_ = {};
        add_mode();
        for (int i = 0; i < 14; ++i) add_move();
        program_.text += "M2\n";
        return std::move(program_);
    }

  private:
    double number(double scale) { return std::uniform_real_distribution<double>(-scale, scale)(random_); }
    bool chance(double share) { return std::bernoulli_distribution(share)(random_); }
    double size_mm() { return std::pow(10, number(2)); }  // 0.01 to 100

    void add_move() {
        if (chance(0.3)) add_mode();
        const double kind = number(1);
        if (kind < -0.7) {
            program_.text += fmt::format("G1 B{:.4f}\n", number(20));
        } else if (kind < 0) {
            add_line();
        } else {
            add_arc();
        }
    }

    void add_mode() {
        const double kind = number(1);
        mode_ = {};
        if (kind < -0.5) {
            program_.text += kind < -0.75 ? "G61\n" : "G61.1\n";
            return;
        }
        mode_.rounds = true;
        if (kind < 0 && !merges_) {
            program_.text += "G64\n";
            return;
        }
        mode_.tolerance_mm = std::pow(10, number(1) - 1);
        mode_.merge_mm = merges_ ? mode_.tolerance_mm : 0;
        program_.text += fmt::format("G64 P{:.6f}{}\n", mode_.tolerance_mm, merges_ ? "" : " Q0");
    }

    void add_line() {
        const Vector3d start = at_;
        const double size = size_mm();
        at_ += Vector3d(number(size), number(size), number(size));
        program_.text += fmt::format("G1 X{:.6f} Y{:.6f} Z{:.6f}{}\n", at_.x(), at_.y(), at_.z(),
                                     chance(0.2) ? fmt::format(" C{:.4f}", number(20)) : "");
        Way path = mode_;
        path.length_mm = (at_ - start).norm();
        for (int i = 0; i <= 40; ++i) path.points.push_back(start + (at_ - start) * i / 40);
        program_.ways.push_back(std::move(path));
    }

    // Adds up to five turns; half of them end where they begin; half of them climb.
    void add_arc() {
        const double radius = 0.005 + size_mm() / 5, from = number(std::numbers::pi);
        const double part = chance(0.5) ? kTurn_rad : 0.05 + std::abs(number(kTurn_rad - 0.1));
        const int turns = chance(0.5) ? 1 : 1 + static_cast<int>(std::abs(number(4.99)));
        const double sense = chance(0.5) ? 1 : -1, lift = chance(0.5) ? number(size_mm()) : 0;
        const Vector3d center = at_ - radius * Vector3d(std::cos(from), std::sin(from), 0);
        Way path = mode_;
        path.radius_mm = radius;
        path.sweep_rad = part + kTurn_rad * (turns - 1);
        path.length_mm = std::hypot(radius * path.sweep_rad, lift);
        const auto point = [&](double share) {
            const double angle = from + sense * share * path.sweep_rad;
            return Vector3d(center.x() + radius * std::cos(angle), center.y() + radius * std::sin(angle),
                            at_.z() + share * lift);
        };
        for (int i = 0; i <= 200; ++i) path.points.push_back(point(i / 200.0));
        const Vector3d start = at_;
        if (part < kTurn_rad) at_.head<2>() = point(1).head<2>();
        at_.z() += lift;
        program_.text +=
            fmt::format("G{} X{:.6f} Y{:.6f} Z{:.6f} I{:.6f} J{:.6f} P{}\n", sense > 0 ? 3 : 2, at_.x(),
                        at_.y(), at_.z(), center.x() - start.x(), center.y() - start.y(), turns);
        program_.ways.push_back(std::move(path));
    }

    std::mt19937 random_;
    bool merges_;
    Program program_;
    Vector3d at_ = Vector3d::Zero();
    Way mode_;
};

// Returns the max length that rounding a corner removes: the paths to it and from it, as far as both extend;
// within the tolerance it is far less.
double most_cut_mm(const Way& before, const Way& after, double own_tolerance_mm) {
    if (!before.rounds && own_tolerance_mm == 0) return 0;
    const double full = 2 * std::min(before.length_mm, after.length_mm);
    const double tolerance =
        before.tolerance_mm > 0 ? std::max(before.tolerance_mm, own_tolerance_mm) : own_tolerance_mm;
    return tolerance > 0 ? std::min(full, 8 * tolerance) : full;
}

// Returns the max difference of an arc and its chords within the tolerance.
double most_chord_loss_mm(const Way& path) {
    if (path.radius_mm == 0) return 0;
    return path.length_mm * std::min(0.5, 2 * kGrblChord_mm / path.radius_mm);
}

class DrivenLength : public testing::TestWithParam<const char*> {
  protected:
    static bool is(const char* name) { return std::string_view(GetParam()) == name; }
    static bool rounds() { return is("linuxcnc-2.9") || is("blend"); }

    static Conditions conditions() {
        std::ifstream file(tests::source_path("samples/machines/linuxcnc-router.toml"));
        std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        const std::string model = "model = \"linuxcnc-2.9\"";
        text.replace(text.find(model), model.size(), fmt::format("model = \"{}\"", GetParam()));
        Conditions setup = ngc_conditions();
        setup.machine = machine::read_machine(text, "router.toml").value();
        return setup;
    }

    static double driven_mm(const Outcome& run) {
        return run.report.distances.rapid_mm + run.report.distances.feed_mm;
    }

    static double lost_at_most_mm(const std::vector<Way>& ways) {
        double lost = kRounding_mm;
        for (std::size_t i = 0; i < ways.size(); ++i) {
            if (is("grbl-1.1")) lost += most_chord_loss_mm(ways[i]);
            if (rounds() && i > 0) lost += most_cut_mm(ways[i - 1], ways[i], 0);
        }
        return lost;
    }
};

double programmed_mm(const std::vector<Way>& ways) {
    double length = 0;
    for (const Way& path : ways) length += path.length_mm;
    return length;
}

// Returns the driven path as chords, each of 1/40 of a segment.
std::vector<Vector3d> driven(const Outcome& run) {
    std::vector<Vector3d> points{Vector3d::Zero()};
    for (const motion::Segment& segment : run.segments) {
        const int steps = segment.kind == motion::SegmentKind::linear && !segment.superimposed ? 1 : 200;
        for (int i = 1; i <= steps; ++i)
            points.push_back(segment.position_at(segment.duration_s * i / steps).head<3>());
    }
    return points;
}

double distance_mm(const Vector3d& point, const std::vector<Vector3d>& chain) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < chain.size(); ++i) {
        const Vector3d path = chain[i] - chain[i - 1];
        const double square = path.squaredNorm();
        const double share = square > 0 ? std::clamp((point - chain[i - 1]).dot(path) / square, 0.0, 1.0) : 0;
        nearest = std::min(nearest, (chain[i - 1] + share * path - point).norm());
    }
    return nearest;
}

/// The driven length is the programmed one, less at most what rounded corners and chords may take.
TEST_P(DrivenLength, MatchesProgramExceptForCornersAndChords) {
    Programs programs(11, false);
    for (int i = 0; i < kPrograms; ++i) {
        const Program program = programs.next();
        const Outcome run = run_ngc(program.text, conditions());
        ASSERT_TRUE(run.completed()) << run.message() << program.text;
        const double programmed = programmed_mm(program.ways), lost = lost_at_most_mm(program.ways);
        ASSERT_GE(driven_mm(run), programmed - lost) << program.text;
        ASSERT_LE(driven_mm(run), programmed + kRounding_mm) << program.text;
    }
}

/// If lines are merged, too, each programmed point is within the tolerances of a driven one. Arcs that are
/// too large to count as lines are driven with all their turns.
TEST_P(DrivenLength, MergedLinesStayNearEachProgrammedPoint) {
    Programs programs(12, true);
    for (int i = 0; i < kPrograms; ++i) {
        const Program program = programs.next();
        const Outcome run = run_ngc(program.text, conditions());
        ASSERT_TRUE(run.completed()) << run.message() << program.text;
        const std::vector<Vector3d> chain = driven(run);
        double min = 0, tolerance = 0.1;
        for (const Way& path : program.ways) tolerance = std::max(tolerance, path.tolerance_mm);
        for (const Way& path : program.ways) {
            if (path.radius_mm > 2 * path.merge_mm && path.sweep_rad > std::numbers::pi)
                min += path.length_mm - most_chord_loss_mm(path) - 16 * tolerance;
            for (const Vector3d& point : path.points)
                ASSERT_LE(distance_mm(point, chain), 3 * tolerance + 0.01 * path.radius_mm) << program.text;
        }
        ASSERT_GE(driven_mm(run), min) << program.text;
    }
}

INSTANTIATE_TEST_SUITE_P(Models, DrivenLength,
                         testing::Values("exact-stop", "linuxcnc-2.9", "ab9", "blend", "grbl-1.1"),
                         [](const auto& model) {
                             std::string name = model.param;
                             std::erase_if(name, [](char c) { return !std::isalnum(c); });
                             return name;
                         });

/// LinuxCNC 2.9 drives it: its recorded runs of such arcs have all turns.
TEST(MultiTurnArcs, KeepAllTurns) {
    const auto machine = machine::load_machine(
        std::filesystem::path(tests::source_path("samples/machines/linuxcnc-router.toml")));
    for (int turns = 1; turns <= 6; ++turns) {
        Conditions setup = ngc_conditions();
        setup.machine = machine.value();
        const Outcome run =
            run_ngc(fmt::format("G64 P0.05\nG1 X5 F3000\nG2 X5 Y0 I0 J5 P{}\nG1 X10\nM2\n", turns), setup);
        EXPECT_NEAR(run.report.distances.feed_mm, 10 + 10 * std::numbers::pi * turns, 0.2) << turns;
    }
}

}  // namespace
}  // namespace gsim::script::driven_length_test
