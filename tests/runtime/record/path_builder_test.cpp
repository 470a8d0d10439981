// Calls that share a path, and calls that do not.
#include "runtime/record/path_builder.h"

#include <gtest/gtest.h>

#include "toolpath/model/validate.h"

namespace gsim::record::path_builder_test {
namespace {

using path::Point;
using path::Program;
using path::SubPath;

Point at(double x) {
    Point point;
    point.motion = path::MotionType::rapid;
    point.position_mm = {x, 0, 0};
    return point;
}

void call(PathBuilder& builder, const std::string& name, double x) {
    builder.begin_call(name);
    builder.add(at(x));
    builder.end_call();
}

std::vector<SubPath> calls_of_root(const Program& program) {
    std::vector<SubPath> calls;
    for (const path::Target& target : program.paths[program.root].targets) {
        if (const auto* each = std::get_if<SubPath>(&target)) calls.push_back(*each);
    }
    return calls;
}

TEST(PathBuilder, EqualCallsShareOnePath) {
    PathBuilder builder;
    for (int i = 0; i < 3; ++i) {
        call(builder, "O2", 5);
        builder.add(at(i));
    }
    const Program program = builder.finish("main");
    EXPECT_EQ(program.paths.size(), 2U);
    EXPECT_EQ(calls_of_root(program), (std::vector<SubPath>{{0, 1}, {0, 1}, {0, 1}}));
    EXPECT_EQ(program.paths[0].name, "O2");
    EXPECT_EQ(program.paths[program.root].name, "main");
    EXPECT_FALSE(path::validate(program));
}

TEST(PathBuilder, ConsecutiveCallsBecomeRepeats) {
    PathBuilder builder;
    for (int i = 0; i < 4; ++i) call(builder, "O2", 5);
    EXPECT_EQ(calls_of_root(builder.finish("main")), (std::vector<SubPath>{{0, 4}}));
}

TEST(PathBuilder, DifferentCallsGetSeparateNames) {
    PathBuilder builder;
    call(builder, "O2", 5);
    call(builder, "O2", 6);
    call(builder, "O2 (2)", 7);
    call(builder, "O2", 5);
    call(builder, "main", 5);
    const Program program = builder.finish("main");
    ASSERT_EQ(program.paths.size(), 5U);
    EXPECT_EQ(calls_of_root(program), (std::vector<SubPath>{{0, 1}, {1, 1}, {2, 1}, {0, 1}, {3, 1}}));
    EXPECT_FALSE(path::validate(program)) << "names must differ";
}

TEST(PathBuilder, CallsDependingOnStartAreSharedPerStart) {
    PathBuilder builder;
    for (const double x : {0.0, 1.0, 0.0}) {
        builder.add(at(x));
        builder.begin_call("O2");
        builder.depends_on({{x, 0, 0}, {}});
        builder.add(at(5));
        builder.end_call();
    }
    EXPECT_EQ(calls_of_root(builder.finish("main")), (std::vector<SubPath>{{0, 1}, {1, 1}, {0, 1}}));
}

TEST(PathBuilder, DropsCallsWithoutTargets) {
    PathBuilder builder;
    builder.begin_call("O2");
    builder.begin_call("O3");
    builder.end_call();
    builder.end_call();
    EXPECT_FALSE(builder.has_targets());
    builder.add(at(1));
    EXPECT_EQ(builder.finish("main").paths.size(), 1U);
}

TEST(PathBuilder, MergesDeeperCallsIntoEighthLevel) {
    PathBuilder builder;
    builder.add(at(-1));
    for (int i = 0; i < 20; ++i) {
        builder.begin_call("O2");
        builder.add(at(i));
    }
    for (int i = 0; i < 10; ++i) builder.end_call();
    builder.add(at(100));
    const Program program = builder.finish("main");  // which ends the others
    EXPECT_FALSE(path::validate(program));
    EXPECT_EQ(program.paths.size(), 9U);
    EXPECT_EQ(program.paths[0].targets.size(), 14U) << "levels 8 to 20, and what came behind";
}

TEST(PathBuilder, IgnoresEndWithoutBegin) {
    PathBuilder builder;
    builder.end_call();
    builder.add(at(1));
    builder.end_call();
    EXPECT_EQ(builder.finish("main").paths.size(), 1U);
}

}  // namespace
}  // namespace gsim::record::path_builder_test
