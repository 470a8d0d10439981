// Each kind of malformed path has its message and its source location.
#include "toolpath/model/validate.h"

#include <limits>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace gsim::path::validate_test {
namespace {

Point at(double x, double y, double z) {
    Point point;
    point.position_mm = {x, y, z};
    return point;
}

Point arc_to(const Vector& end, const Vector& via) {
    Point point;
    point.motion = MotionType::circular;
    point.position_mm = end;
    point.arc = ViaPoint{via};
    return point;
}

Point turn_to(const Vector& end, const Vector& center, double turn_deg) {
    Point point;
    point.motion = MotionType::circular;
    point.position_mm = end;
    point.arc = CenterArc{center, {0, 0, 1}, turn_deg};
    return point;
}

Program of(std::vector<Target> targets) {
    return {"n", {{"root", std::move(targets)}}, 0};
}

// Path i uses path i + 1.
Program chain(std::size_t paths) {
    Program program;
    for (std::size_t i = 0; i < paths; ++i) {
        program.paths.push_back({fmt::format("p{}", i), {at(1, 2, 3)}});
        if (i + 1 < paths) program.paths.back().targets.emplace_back(SubPath{i + 1, 1});
    }
    return program;
}

void expect_fault(const Program& program, const TargetId& where, const std::string& part) {
    const auto error = validate(program);
    ASSERT_TRUE(error) << part;
    EXPECT_EQ(error->where, where) << error->message;
    EXPECT_NE(error->message.find(part), std::string::npos) << error->message;
}

TEST(ValidatePath, AllowsEightLevelsBelowRoot) {
    EXPECT_FALSE(validate(chain(9)));
    expect_fault(chain(10), {8, 1}, "deeper than 8");
    EXPECT_TRUE(validate(chain(20'000)));
}

TEST(ValidatePath, ReportsCycleAtClosingSubPath) {
    Program program = chain(3);
    program.paths[2].targets.emplace_back(SubPath{1, 1});
    expect_fault(program, {2, 1}, "'p1' contains itself");
    program.paths[2].targets.back() = SubPath{2, 1};
    expect_fault(program, {2, 1}, "'p2' contains itself");
}

TEST(ValidatePath, ChecksRepeatedSubPathOnce) {
    // Unrolled it would be 50^8 points.
    Program program = chain(9);
    for (std::size_t i = 0; i < 8; ++i) {
        program.paths[i].targets.assign(50, SubPath{i + 1, 1'000'000});
    }
    EXPECT_FALSE(validate(program));
}

TEST(ValidatePath, RejectsInvalidArcs) {
    EXPECT_FALSE(validate(of({at(0, 0, 0), arc_to({10, 0, 0}, {5, 5, 0})})));
    expect_fault(of({at(0, 0, 0), arc_to({10, 0, 0}, {5, 0, 0})}), {0, 1}, "via point is on the line");
    expect_fault(of({at(0, 0, 0), arc_to({10, 0, 0}, {10, 0, 0})}), {0, 1}, "via point is on the line");
    expect_fault(of({at(0, 0, 0), arc_to({0, 0, 0}, {5, 5, 0})}), {0, 1}, "must not end at its start");
    expect_fault(of({arc_to({10, 0, 0}, {5, 5, 0})}), {0, 0}, "its start is unknown");
    EXPECT_FALSE(validate(of({at(10, 0, 0), turn_to({0, 10, 5}, {0, 0, 0}, 90)})));
    EXPECT_FALSE(validate(of({at(10, 0, 0), turn_to({0, 10, 5}, {0, 0, 0}, 450)})));
    EXPECT_FALSE(validate(of({at(10, 0, 0), turn_to({10, 0, 0}, {0, 0, 0}, 360)})));
    expect_fault(of({at(10, 0, 0), turn_to({0, 10, 0}, {0, 0, 0}, 80)}), {0, 1}, "90 would");
    expect_fault(of({at(10, 0, 0), turn_to({0, 11, 0}, {0, 0, 0}, 90)}), {0, 1}, "11 mm from it");
    expect_fault(of({at(0, 0, 0), turn_to({0, 0, 0}, {0, 0, 0}, 90)}), {0, 1}, "starts at its centre");
    expect_fault(of({at(10, 0, 0), turn_to({0, 10, 0}, {0, 0, 0}, -90)}), {0, 1}, "'turn_deg'");
}

TEST(ValidatePath, ChecksInitialArcOfSubPathForEachUse) {
    Program program = of({at(0, 0, 0), SubPath{1, 1}, at(10, 0, 0), SubPath{1, 1}});
    program.paths.push_back({"sub", {arc_to({10, 10, 0}, {5, 8, 0})}});
    EXPECT_FALSE(validate(program));
    program.paths[0].targets[2] = at(0, 6, 0);  // the second time start, via and end are in line
    expect_fault(program, {1, 0}, "via point is on the line");
    program.paths[0].targets = {at(0, 0, 0), SubPath{1, 2}};  // the second time its start is its end
    expect_fault(program, {1, 0}, "must not end at its start");
}

TEST(ValidatePath, RejectsInvalidValues) {
    const auto with = [](auto change) {
        Point point = at(1, 2, 3);
        change(point);
        return of({point});
    };
    expect_fault(with([](Point& p) { p.position_mm[1] = std::numeric_limits<double>::quiet_NaN(); }), {0, 0},
                 "'position_mm'");
    expect_fault(with([](Point& p) { p.feed_mm_min = 0; }), {0, 0}, "'feed_mm_min'");
    expect_fault(with([](Point& p) { p.feed_deg_min = -1; }), {0, 0}, "'feed_deg_min'");
    expect_fault(with([](Point& p) { p.duration_s = 1e300; }), {0, 0}, "'duration_s'");
    expect_fault(with([](Point& p) { p.dwell_s = -1; }), {0, 0}, "'dwell_s'");
    expect_fault(with([](Point& p) { p.orientation = ToolAxis{{0, 0, 0}}; }), {0, 0}, "'tool_axis'");
    expect_fault(with([](Point& p) { p.actions = {""}; }), {0, 0}, "action");
    expect_fault(with([](Point& p) { p.actions = {"a\nb"}; }), {0, 0}, "control characters");
    expect_fault(with([](Point& p) {
                     p.actions = {
                         "Stra\xdf"
                         "e"};
                 }),
                 {0, 0}, "is not in UTF-8");
    expect_fault(of({SubPath{7, 1}}), {0, 0}, "sub-path does not exist");
    expect_fault(of({}), {0, std::nullopt}, "has no targets");
    Program program = of({at(1, 2, 3)});
    program.paths.push_back(program.paths[0]);
    expect_fault(program, {1, std::nullopt}, "two paths have the name 'root'");
}

}  // namespace
}  // namespace gsim::path::validate_test
