// Fixed and reference points: their reading, the path to them, and the rotary axes after them.
#include <random>

#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "tests/toolpath/random_path.h"
#include "toolpath/json/json_reader.h"
#include "toolpath/json/json_writer.h"
#include "toolpath/rotary/axis_moves.h"

namespace gsim::path::machine_points_test {
namespace {

using Steps = std::vector<std::map<char, double>>;

std::string path_of(const std::string& targets) {
    return R"({"paths": [{"name": "p", "targets": [)" + targets + "]}]}";
}

std::string error_of(const std::string& targets) {
    const auto file = read_json(path_of(targets), "f");
    return file ? "no error" : file.error().message;
}

MachinePoint fixed(std::map<char, double> axes) {
    MachinePoint point;
    point.number = 1;
    point.axes = std::move(axes);
    return point;
}

Point rapid(const Vector& position, std::optional<Orientation> orientation = {}) {
    Point point;
    point.motion = MotionType::rapid;
    point.position_mm = position;
    point.orientation = std::move(orientation);
    return point;
}

TEST(MachinePoints, RoundTripsThroughJson) {
    const auto file =
        read_json(path_of(R"({"fixed": "CLAMP1", "name": "left", "dwell_s": 1.5, "actions": ["a", "b"]},
                   {"fixed": 12}, {"reference": 4}, {"reference": "DOCK"})"),
                  "f");
    ASSERT_TRUE(file) << file.error().message;
    const std::vector<Target>& targets = file->program.paths[0].targets;
    MachinePoint left;
    left.name = "left";
    left.alias = "CLAMP1";
    left.dwell_s = 1.5;
    left.actions = {"a", "b"};
    EXPECT_EQ(std::get<MachinePoint>(targets[0]), left);
    EXPECT_EQ(std::get<MachinePoint>(targets[1]).number, 12);
    EXPECT_EQ(std::get<MachinePoint>(targets[2]).kind, MachinePoint::Kind::reference);
    EXPECT_EQ(std::get<MachinePoint>(targets[3]).alias, "DOCK");
    EXPECT_EQ(read_json(to_json(file->program), "f").value().program, file->program);
}

TEST(MachinePoints, RejectsInvalidPoints) {
    EXPECT_EQ(error_of(R"({"fixed": 1, "reference": 1})"),
              "f:1:38: 'fixed' and 'reference' are two points; a target may have only one of them");
    EXPECT_EQ(error_of(R"({"reference": 1, "feed_mm_min": 1})"),
              "f:1:38: a target with the key 'reference' is a point of the machine, which is reached by a "
              "rapid; it cannot have 'feed_mm_min'");
    EXPECT_EQ(error_of(R"({"path": "p", "fixed": 1})"),
              "f:1:38: a target with the key 'path' is a sub-path and cannot have 'fixed'");
    EXPECT_EQ(error_of(R"({"fixed": true})"),
              "f:1:48: 'fixed' must be a name or a number, not true or false");
    EXPECT_EQ(error_of(R"({"reference": ""})"),
              "f:1:38: 'reference' must be the number of a reference point, or its name: a letter first, "
              "then letters, digits and _");
    EXPECT_EQ(error_of(R"({"reference": 1.5})"),
              "f:1:52: 'reference' must be an integer from 1 to 4; it is 1.5");
    EXPECT_EQ(error_of(R"({"fixed": 0})"), "f:1:48: 'fixed' must be an integer from 1 to 99999; it is 0");
    EXPECT_EQ(error_of(R"({"fixed": "a-b"})"),
              "f:1:38: 'fixed' must be the number of a fixed point, or its name: a letter first, then "
              "letters, digits and _");
    EXPECT_EQ(error_of(R"({"fixed": 1, "dwell_s": -1})"),
              "f:1:38: 'dwell_s' must be 0 or greater and at most 1e6; it is -1");
}

// The rapid comes directly after the point, after a sub-path that ends there, and at the beginning of a
// repeated sub-path.
TEST(MachinePoints, FirstMotionAfterPointMustBeRapid) {
    const std::string message =
        "the first motion after a fixed or reference point must be a rapid, because the position of that "
        "point in the work is unknown";
    const std::string line = R"({"position_mm": [1, 2, 3], "feed_mm_min": 1})";
    const std::string arc = R"({"motion": "circular", "position_mm": [1, 2, 3], "via_mm": [4, 5, 6]})";
    const std::string none = R"({"motion": "none", "position_mm": [1, 2, 3]})";
    for (const std::string& motion : {line, arc, none})
        EXPECT_EQ(error_of(R"({"fixed": 1},)" + motion), "f:1:51: " + message);
    const auto with_park = [](const std::string& targets, const std::string& park) {
        const auto file = read_json(R"({"root": "p", "paths": [{"name": "q", "targets": [)" + park +
                                        "]},\n{\"name\": \"p\", \"targets\": [" + targets + "]}]}",
                                    "f");
        return file ? "no error" : file.error().message;
    };
    EXPECT_EQ(with_park(R"({"path": "q"},)" + line, R"({"fixed": 1})"), "f:2:41: " + message);
    EXPECT_EQ(with_park(R"({"path": "q", "repeats": 2})", line + R"(,{"fixed": 1})"), "f:1:51: " + message);
    EXPECT_EQ(with_park(R"({"path": "q"})", line + R"(,{"fixed": 1})"), "no error");
}

TEST(MachinePoints, RejectsPointsInRecordedPath) {
    const auto file = read_json(
        R"({"work_offsets": {"54": {}}, "paths": [{"name": "p", "targets": [{"fixed": 1}]}]})", "f");
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().message,
              "f:1:66: a path that was recorded from a run has no fixed or reference points");
}

TEST(MachinePoints, MovesZFirstIfUpward) {
    const auto steps = [](std::map<char, double> axes) {
        return plan_approach(fixed(std::move(axes)), 100).steps;
    };
    EXPECT_EQ(steps({{'X', 1}, {'Y', 2}, {'Z', 100}, {'B', 3}}),
              (Steps{{{'Z', 100}}, {{'X', 1}, {'Y', 2}, {'B', 3}}}));
    EXPECT_EQ(steps({{'X', 1}, {'Z', 99}}), (Steps{{{'X', 1}}, {{'Z', 99}}}));
    EXPECT_EQ(steps({{'B', 1}}), (Steps{{{'B', 1}}}));
    EXPECT_FALSE(plan_approach(fixed({{'X', 1}, {'Z', 100}}), 100).retract_first);
    EXPECT_TRUE(plan_approach(fixed({{'X', 1}, {'Z', 99}}), 100).retract_first);
    EXPECT_TRUE(plan_approach(fixed({{'X', 1}, {'Z', 99}}), std::nullopt).retract_first)
        << "nobody knows what is up";
    EXPECT_TRUE(plan_approach(fixed({{'X', 1}}), 100).retract_first);
    MachinePoint home;
    home.kind = MachinePoint::Kind::reference;
    home.number = 3;
    const MachineApproach machine_path = plan_approach(home, 100);
    EXPECT_EQ(machine_path.reference, 3);
    EXPECT_FALSE(machine_path.retract_first);
    EXPECT_EQ(machine_path.steps, (Steps{{{'Z', 0}}, {{'X', 0}, {'Y', 0}}}));
}

class MachinePointPlan : public testing::Test {
  protected:
    void plan(Program program) {
        program_ = std::move(program);
        const MachineSpace space = MachineSpace::make(machine_).value();
        const States states(program_);
        turns_ = plan_rotary(program_, space, states, {});
        if (turns_) entries_ = rotary_entries(program_, states, *turns_);
    }
    double b(std::size_t path, std::size_t target) const { return (*turns_)[path].at(target)[0]; }

    machine::Machine machine_ = machine::read_machine(machine::built_in_machine_toml(), "m").value();
    Program program_;
    tl::expected<std::vector<RotarySchedule>, TargetError> turns_ = tl::unexpected(TargetError{});
    std::vector<std::optional<AxisValues>> entries_;
};

TEST_F(MachinePointPlan, ContinuesFromAxisPositionsOfPoint) {
    const auto leaning = [](double b) { return RotaryAxes{{'B', b}, {'C', 0}}; };
    plan({"n",
          {{"p",
            {rapid({1, 1, 100}, leaning(0)), fixed({{'X', 1}, {'Y', 1}, {'Z', 1}, {'B', 170}, {'C', 0}}),
             rapid({2, 1, 100}, leaning(-150)), fixed({{'X', 1}, {'Y', 1}, {'Z', 1}}), rapid({3, 1, 100})}}},
          0});
    ASSERT_TRUE(turns_) << turns_.error().message;
    EXPECT_EQ(b(0, 1), 170);
    EXPECT_EQ(b(0, 2), 210) << "-150 by the short way";
    EXPECT_EQ(b(0, 3), 210) << "it names no rotary axis";
    EXPECT_EQ(b(0, 4), 210);
    EXPECT_TRUE((*turns_)[0].unwindings.empty());
}

// A path of such points alone has no values of its own; its users continue with theirs.
TEST_F(MachinePointPlan, PathsWithoutRotaryAxesPassThemOn) {
    const MachinePoint park = fixed({{'X', 1}, {'Y', 1}, {'Z', 1}});
    plan(
        {"n",
         {{"p", {SubPath{1}, rapid({1, 1, 100}, RotaryAxes{{'B', 30}, {'C', 0}}), SubPath{1, 2}, SubPath{2}}},
          {"park", {park, park}},
          {"q", {park, rapid({1, 1, 100}, RotaryAxes{{'B', 50}, {'C', 0}})}}},
         0});
    ASSERT_TRUE(turns_) << turns_.error().message;
    EXPECT_FALSE((*turns_)[0].is_known(0));
    EXPECT_EQ(b(0, 1), 30);
    EXPECT_EQ(b(0, 2), 30);
    EXPECT_EQ(b(0, 3), 50);
    EXPECT_FALSE((*turns_)[1].is_known(1));
    EXPECT_FALSE((*turns_)[2].is_known(0));
    EXPECT_EQ(b(2, 1), 50);
    EXPECT_FALSE(entries_[1]) << "not known, and 30";
    ASSERT_TRUE(entries_[2]);
    EXPECT_EQ((*entries_[2])[0], 30);
}

// The machine as it is driven, sub-paths included.
struct Driven : MoveSink {
    Driven(const AxisMoves& moves, const machine::Machine& machine) : moves_(moves), machine_(machine) {}

    void move(const AxisMove& move) override {
        for (Eigen::Index i = 0; i < move.axes.size() && at.size() > 0 && !move.rapid; ++i) {
            if (machine_.axes[static_cast<std::size_t>(i)].kind != machine::AxisKind::rotary) continue;
            most_turned_deg = std::max(most_turned_deg, std::abs(move.axes[i] - at[i]));
            ++lines;
        }
        at = move.axes;
        behind_point = false;
    }
    void retract() override { ups += behind_point ? 1 : 0; }
    void go_to(const MachineApproach& machine_path) override {
        for (const auto& step : machine_path.steps) {
            for (const auto& [letter, value] : step)
                if (at.size() > 0) at[static_cast<Eigen::Index>(*machine_.find(letter))] = value;
        }
        behind_point = true;
    }
    void dwell(double) override {}
    void acceleration(double) override {}
    void action(const std::string&) override {}
    void call(const SubPath& use) override {
        for (int i = 0; i < use.repeats; ++i) take(moves_.run(use.path, *this));
    }
    void note(const TargetId&, std::string_view) override {}

    void take(const tl::expected<void, TargetError>& done) {
        if (!done && error.empty()) error = done.error().message;
    }

    AxisValues at;
    std::string error;
    double most_turned_deg = 0;
    int lines = 0, ups = 0;
    bool behind_point = false;

  private:
    const AxisMoves& moves_;
    const machine::Machine& machine_;
};

// Programs without a jet cut with each line, so that axes take the short path. It starts from their true
// positions, wherever points of the machine have left them.
TEST_F(MachinePointPlan, LinesTurnAtMostHalfTurnFromActualPositions) {
    std::mt19937 random(11);
    int driven = 0, lines = 0, ups = 0;
    for (int i = 0; i < 400; ++i) {
        RandomPathOptions options;
        options.machine_points = true;
        options.extras = options.tilted_arcs = false;
        Program program = random_program(random, options);
        const auto below = [&](int end) { return std::uniform_int_distribution<int>(0, end - 1)(random); };
        for (Path& path : program.paths) {
            for (Target& target : path.targets) {
                auto* point = std::get_if<MachinePoint>(&target);
                if (point == nullptr) continue;
                point->axes = {{'X', 10}, {'Y', 20}, {'Z', 30}};
                const int named = below(3);
                if (named > 0) point->axes['B'] = below(340) - 170;
                if (named > 1) point->axes['C'] = below(160) - 80;
            }
        }
        ASSERT_FALSE(validate(program));
        plan(program);
        if (!turns_ && turns_.error().message.starts_with("out of reach")) continue;
        ASSERT_TRUE(turns_) << turns_.error().message << to_json(program_);
        const MachineSpace space = MachineSpace::make(machine_).value();
        const States states(program_);
        const AxisMoves moves(program_, space, states, *turns_, {});
        Driven machine(moves, machine_);
        machine.take(moves.run(program_.root, machine));
        if (machine.error.starts_with("out of reach")) continue;
        ASSERT_EQ(machine.error, "") << to_json(program_);
        ++driven;
        lines += machine.lines;
        ups += machine.ups;
        EXPECT_LE(machine.most_turned_deg, 180 + 1e-6) << to_json(program_);
    }
    EXPECT_GT(driven, 100);
    EXPECT_GT(lines, 1000);
    EXPECT_GT(ups, 100);
}

}  // namespace
}  // namespace gsim::path::machine_points_test
