#include "controller/module/rcs_shell.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/controller/test_module.h"

namespace gsim::rrs::rcs_shell_test {
namespace {

RcsShell ready(HostProcess place, const std::string& name) {
    RcsShell shell(module_at(place, name).value(), 3);
    shell.Initialize();
    return shell;
}

JointPos at(double x, double y, double z) {
    return Eigen::Vector3d(x, y, z);
}

struct Step {
    Status status = Status::RRS_SUCCESS;
    JointPos joints = at(-1, -1, -1);
    CartPos pose = CartPos::Identity();
    double elapsed_s = -1;
};

Step next(RcsShell& shell) {
    Step step;
    step.status = shell.GetNextStep(step.joints, step.pose, step.elapsed_s);
    return step;
}

std::string message(RcsShell& shell) {
    std::string text;
    shell.GetMessage(text);
    return text;
}

/// Wherever the module runs, it is the same.
class Modules : public testing::TestWithParam<HostProcess> {
  protected:
    static RcsShell ready(const std::string& name) { return rcs_shell_test::ready(GetParam(), name); }
};

INSTANTIATE_TEST_SUITE_P(Places, Modules, both_places(), place_name);

TEST_P(Modules, MoveAsRequested) {
    RcsShell shell = ready("small_module");
    shell.SetCartesianPositionSpeed(100);
    shell.SetInitialPosition(CartPos::Identity(), at(1, 2, 3), "");
    shell.SetNextTarget(1, TargetParam::end, CartPos::Identity(), at(1, 6, 6), "", 0);  // 5 mm
    EXPECT_EQ(shell.SetInterpolationTime(0.02), Status::RRS_SUCCESS);
    Step step = next(shell);
    EXPECT_EQ(step.status, Status::RRS_SUCCESS);
    EXPECT_TRUE(step.joints.isApprox(at(1, 3.6, 4.2)));
    EXPECT_DOUBLE_EQ(step.elapsed_s, 0.02);
    next(shell);
    step = next(shell);
    EXPECT_EQ(step.status, Status::RRS_TARGET_REACHED);
    EXPECT_EQ(step.joints, at(1, 6, 6));
    EXPECT_NEAR(step.elapsed_s, 0.01, 1e-12);
    EXPECT_EQ(next(shell).status, Status::RRS_NEED_MORE_DATA);
    EXPECT_FALSE(shell.error());
}

TEST_P(Modules, ReportMissingServiceWithoutModuleError) {
    RcsShell shell = ready("small_module");
    EXPECT_EQ(shell.StopMotion(), Status::RRS_SERVICE_NOT_SUPPORTED);
    EXPECT_EQ(message(shell), "small_module.so does not support the service StopMotion.");
    EXPECT_EQ(shell.SetNextTarget(1, TargetParam::end, CartPos::Identity(), at(0, 0, 0), "", 0),
              Status::RRS_ZERO_SPEED);
    EXPECT_EQ(message(shell), "No speed is programmed.");
    EXPECT_FALSE(shell.error());
}

/// A module that was compiled before a service got its opcode does not know it.
TEST_P(Modules, ReportNewerOpcodesAsMissingServices) {
    RcsShell shell = ready("small_module");
    const double value = 1;
    EXPECT_EQ(shell.SetRampMode(RampMode::s_curve), Status::RRS_SERVICE_NOT_SUPPORTED);
    EXPECT_EQ(shell.SetJointRampLimits(RampLimit::jerk, {}, {&value, 1}), Status::RRS_SERVICE_NOT_SUPPORTED);
    EXPECT_EQ(shell.DefinePathEvent(1, 1, -5), Status::RRS_SERVICE_NOT_SUPPORTED);
    EXPECT_EQ(message(shell), "small_module.so does not support the service DefinePathEvent.");
    EXPECT_FALSE(shell.error());
}

TEST_P(Modules, RejectTooLongInputBeforeModule) {
    RcsShell shell = ready("small_module");
    EXPECT_EQ(shell.ModifyCellFrame(std::string(GSIM_RCS_NAME_SIZE, 'n'), CartPos::Identity()),
              Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(message(shell), "The name of the frame is too long.");
    EXPECT_EQ(shell.SetJointSpeeds({}, std::vector<double>(17, 1.0)), Status::RRS_INVALID_PARAMETER);
    EXPECT_EQ(message(shell), "SetJointSpeeds accepts at most 16 values.");
}

struct BadAnswer {
    const char* module;
    const char* expected_text;  // after the name of the module
};

class RcsShellErrors : public testing::TestWithParam<std::tuple<BadAnswer, HostProcess>> {};

TEST_P(RcsShellErrors, InvalidStepResponseIsPermanentError) {
    const auto& [bad, place] = GetParam();
    RcsShell shell = ready(place, bad.module);
    shell.SetCartesianPositionSpeed(100);
    shell.SetNextTarget(1, TargetParam::end, CartPos::Identity(), at(5, 0, 0), "", 0);
    EXPECT_EQ(next(shell).status, Status::RRS_MODULE_FAULT);
    const std::string expected_text =
        fmt::format("The controller module {}.so {}", bad.module, bad.expected_text);
    EXPECT_THAT(message(shell), testing::StartsWith(expected_text));
    EXPECT_EQ(shell.SetCartesianPositionSpeed(1), Status::RRS_MODULE_FAULT);
    EXPECT_EQ(shell.Initialize(), Status::RRS_MODULE_FAULT);
    EXPECT_THAT(*shell.error(), testing::StartsWith(expected_text));
}

INSTANTIATE_TEST_SUITE_P(
    Modules, RcsShellErrors,
    testing::Combine(
        testing::Values(
            BadAnswer{"nan_answer", "responded to GetNextStep with the value nan for joint 2"},
            BadAnswer{"backwards", "responded to GetNextStep with a time that decreases by 0.01 s"},
            BadAnswer{"fewer_joints", "responded to GetNextStep with 1 joint values; the machine has 3"},
            BadAnswer{"no_status", "responded to GetNextStep with 77, which is not a status"},
            BadAnswer{"leaves_output", "responded to GetNextStep with a time of nan s"},
            BadAnswer{"breaks_down", "failed in GetNextStep: out of memory"}),
        both_places()),
    [](const auto& param) {
        return fmt::format("{}_{}", std::get<0>(param.param).module,
                           place_name({std::get<1>(param.param), 0}));
    });

TEST_P(Modules, ReportStatusOfOtherServiceAsError) {
    RcsShell shell = ready("wrong_status");
    EXPECT_EQ(shell.SelectTargetType(TargetType::joint), Status::RRS_MODULE_FAULT);
    EXPECT_EQ(message(shell),
              "The controller module wrong_status.so responded to SelectTargetType with RRS_TARGET_REACHED, "
              "which is not a valid response.");
}

}  // namespace
}  // namespace gsim::rrs::rcs_shell_test
