// Damage by a module to its own process does not affect the program that calls it.

#include "controller/module/rcs_process.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "controller/module/rcs_shell.h"
#include "tests/build_files/build_files.h"
#include "tests/controller/test_module.h"
#include "tests/support/soon.h"

namespace gsim::rrs::rcs_process_test {
namespace {

using tests::soon;

constexpr RcsProcessLimits kSmall{.response_timeout_ms = 500, .memory_bytes = 256U << 20U};
constexpr int kStepsBefore = 50;  // of hostile_module.c
constexpr int kCapacity = 8;      // of small_module.c

/// Returns a path to a module that no other program has, to distinguish its processes from those of parallel
/// tests.
std::string own_path(const std::string& name) {
    static const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / fmt::format("rcs_process_test_{}", ::getpid());
    std::filesystem::create_directory(folder);
    const std::filesystem::path link = folder / (name + ".so");
    std::error_code there;
    std::filesystem::create_symlink(module_path(name), link, there);
    return link;
}

RcsModule begin(const std::string& name, RcsProcessLimits limits = kSmall) {
    return start_rcs_process(tests::program_path("gsim-rcs-host"), own_path(name), slides(), limits).value();
}

/// Returns the processes that were started for a module, with those that it has started itself.
std::vector<pid_t> bound_processes(const std::string& name) {
    std::vector<pid_t> found;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        const std::string number = entry.path().filename().string();
        if (number.find_first_not_of("0123456789") != std::string::npos) continue;
        std::ifstream file(entry.path() / "cmdline");
        const std::string line{std::istreambuf_iterator<char>(file), {}};
        if (line.find("gsim-rcs-host") != std::string::npos && line.find(own_path(name)) != std::string::npos)
            found.push_back(std::stoi(number));
    }
    return found;
}

JointPos at(double x) {
    return Eigen::Vector3d(x, 0, 0);
}

Status queue(RcsShell& shell, double x) {
    return shell.SetNextTarget(1, TargetParam::end, CartPos::Identity(), at(x), "", 0);
}

/// Requests a path of 10 s in steps of 0.01 s.
void ask_for_a_way(RcsShell& shell) {
    shell.Initialize();
    shell.SetCartesianPositionSpeed(1);
    shell.SetInitialPosition(CartPos::Identity(), at(0), "");
    queue(shell, 10);
}

struct Misdeed {
    const char* module;
    const char* message;  // after the name of the module
};

/// Files for the modules' processes, removed at the end.
class OwnPaths : public testing::Environment {
  public:
    void TearDown() override {
        std::filesystem::remove_all(std::filesystem::path(own_path("small_module")).parent_path());
    }
};
const testing::Environment* const own_paths = testing::AddGlobalTestEnvironment(new OwnPaths);

/// Returns the limits for a module: a short one only for those that do not respond, because others may be
/// slow.
RcsProcessLimits limits_for(const Misdeed& misdeed) {
    RcsProcessLimits limits = kSmall;
    if (std::string_view(misdeed.message).find("did not respond") == std::string_view::npos)
        limits.response_timeout_ms = 60'000;
    return limits;
}

class FailingModules : public testing::TestWithParam<Misdeed> {};

TEST_P(FailingModules, ReportErrorWithServiceName) {
#ifdef GSIM_SANITIZED
    if (GetParam().module == std::string("hogs_memory")) GTEST_SKIP() << "memory has no limit there";
#endif
    {
        RcsShell shell(begin(GetParam().module, limits_for(GetParam())), 3);
        ask_for_a_way(shell);
        Status status = Status::RRS_SUCCESS;
        int steps = 0;
        for (JointPos joints; !is_error_status(status); ++steps) {
            CartPos pose;
            double elapsed_s = 0;
            status = shell.GetNextStep(joints, pose, elapsed_s);
        }
        EXPECT_EQ(status, Status::RRS_MODULE_FAULT);
        EXPECT_LE(steps, kStepsBefore + 2);
        ASSERT_TRUE(shell.error());
        EXPECT_EQ(*shell.error(),
                  fmt::format("The controller module {}.so {}.", GetParam().module, GetParam().message));
        EXPECT_EQ(shell.Initialize(), Status::RRS_MODULE_FAULT) << "for good";
    }
    EXPECT_TRUE(soon([] { return bound_processes(GetParam().module).empty(); }));
}

INSTANTIATE_TEST_SUITE_P(
    Modules, FailingModules,
    testing::Values(Misdeed{"crashes", "crashed in GetNextStep (signal 11)"},
                    Misdeed{"aborts", "crashed in GetNextStep (signal 6)"},
                    Misdeed{"exits", "ended its process in GetNextStep (status 3)"},
                    Misdeed{"hangs", "did not respond in GetNextStep within 0.5 s"},
                    Misdeed{"sleeps", "did not respond in GetNextStep within 0.5 s"},
                    Misdeed{"blocks_signals", "did not respond in GetNextStep within 0.5 s"},
                    Misdeed{"hogs_memory", "crashed in GetNextStep (signal 6)"},
                    Misdeed{"closes_descriptors", "closed its connection in GetNextStep"},
                    Misdeed{"writes_everywhere", "closed its connection in GetNextStep"},
                    Misdeed{"leaves_a_child", "crashed in GetNextStep (signal 11)"},
                    Misdeed{"crashes_in_target", "crashed in SetNextTarget (signal 11)"}),
    [](const auto& param) { return std::string(param.param.module); });

/// Result for a caller that has announced its steps.
struct Found {
    int steps = 0;
    int targets = 0;
    std::string loss;
};

Found step_ahead(RcsModule& module, RcsPrefetch prefetch, bool queries_targets) {
    module.announce(prefetch, queries_targets);
    Found found;
    for (;;) {
        gsim_rcs_step step{};
        const std::int32_t status = module.call(GSIM_RCS_GET_NEXT_STEP, nullptr, &step);
        if (status == GSIM_RCS_FAULT || status == GSIM_RCS_NEED_MORE_DATA) break;
        ++found.steps;
        gsim_rcs_target_id target{};
        if (queries_targets &&
            module.call(GSIM_RCS_GET_TARGET_OF_LAST_STEP, nullptr, &target) != GSIM_RCS_SUCCESS)
            break;
        if (queries_targets) ++found.targets;
        if (prefetch == RcsPrefetch::to_target && status == GSIM_RCS_TARGET_REACHED) break;
    }
    found.loss = module.loss().value_or("");
    return found;
}

std::int32_t queue(RcsModule& module, double x) {
    gsim_rcs_target target{};
    target.position.joints = to_rcs(at(x));
    return module.call(GSIM_RCS_SET_NEXT_TARGET, &target, nullptr);
}

void make_ready(RcsModule& module) {
    module.call(GSIM_RCS_INITIALIZE, nullptr, nullptr);
    const gsim_rcs_number speed{1};
    module.call(GSIM_RCS_SET_CARTESIAN_POSITION_SPEED, &speed, nullptr);
}

TEST(RcsProcess, KeepsStepsMadeBeforeCrash) {
    RcsModule module = begin("crashes");
    make_ready(module);
    queue(module, 10);
    const Found found = step_ahead(module, RcsPrefetch::to_end, false);
    EXPECT_EQ(found.steps, kStepsBefore);
    EXPECT_EQ(found.loss, "crashed in GetNextStep (signal 11)");
}

TEST(RcsProcess, KeepsStepsAndTargetsBeforeCrashOfTargetService) {
    RcsModule module = begin("crashes_where_targets_are_told");
    make_ready(module);
    queue(module, 10);
    const Found found = step_ahead(module, RcsPrefetch::to_end, true);
    EXPECT_EQ(found.steps, kStepsBefore + 1);
    EXPECT_EQ(found.targets, kStepsBefore);
    EXPECT_EQ(found.loss, "crashed in GetTargetOfLastStep (signal 11)");
}

/// The module steps a full queue itself, and the target is enqueued there once more.
TEST(RcsProcess, RetriesTargetAfterStepsMakeRoomInQueue) {
    for (const char* const name : {"small_module", "crashes_in_second_try"}) {
        RcsModule module = begin(name);
        make_ready(module);
        for (int i = 1; i <= kCapacity; ++i) ASSERT_EQ(queue(module, 0.045 * i), GSIM_RCS_SUCCESS);
        module.announce(RcsPrefetch::if_full, false);
        EXPECT_EQ(queue(module, 1), GSIM_RCS_QUEUE_FULL);
        const Found found = step_ahead(module, RcsPrefetch::to_target, false);
        EXPECT_EQ(found.steps, 5) << "0.045 mm at 1 mm/s in steps of 0.01 s";
        module.announce(RcsPrefetch::if_full, false);
        const bool crashes = std::string(name) == "crashes_in_second_try";
        EXPECT_EQ(queue(module, 1), crashes ? GSIM_RCS_FAULT : GSIM_RCS_SUCCESS);
        EXPECT_EQ(module.loss().value_or(""), crashes ? "crashed in SetNextTarget (signal 11)" : "");
    }
}

/// Shared memory is not trusted: for any content read there, the caller survives.
TEST(RcsProcess, SurvivesOverwrittenSharedMemory) {
    for (const RcsPrefetch prefetch :
         {RcsPrefetch::unknown, RcsPrefetch::to_target, RcsPrefetch::to_end, RcsPrefetch::if_full}) {
        RcsModule module = begin("fills_shared_memory");
        make_ready(module);
        queue(module, 1);
        const Found found = step_ahead(module, prefetch, false);
        EXPECT_GT(found.steps, 0);
        static_cast<void>(queue(module, 2));
    }
}

TEST(RcsProcess, IgnoresErrorsInDestroy) {
    for (const std::string name : {"crashes_in_destroy", "exits_in_destroy", "hangs_in_destroy"}) {
        {
            RcsModule module = begin(name);
            make_ready(module);
            queue(module, 1);
            EXPECT_EQ(step_ahead(module, RcsPrefetch::to_end, false).loss, "");
        }
        EXPECT_TRUE(bound_processes(name).empty()) << name;
    }
}

TEST(RcsProcess, ReportsKilledProcess) {
    RcsModule module = begin("small_module");
    make_ready(module);
    const std::vector<pid_t> processes = bound_processes("small_module");
    ASSERT_EQ(processes.size(), 1U);
    ::kill(processes.front(), SIGKILL);
    siginfo_t ended{};
    ::waitid(P_PID, static_cast<id_t>(processes.front()), &ended, WEXITED | WNOWAIT);
    EXPECT_EQ(queue(module, 1), GSIM_RCS_FAULT);
    EXPECT_EQ(module.loss().value_or(""), "was terminated between two services (signal 9)");
}

TEST(RcsProcess, TwoModulesRunIndependently) {
    RcsModule one = begin("crashes"), other = begin("small_module");
    for (RcsModule* const module : {&one, &other}) {
        make_ready(*module);
        queue(*module, 1);
    }
    EXPECT_EQ(step_ahead(one, RcsPrefetch::to_end, false).steps, kStepsBefore);
    const Found found = step_ahead(other, RcsPrefetch::to_end, false);
    EXPECT_EQ(found.steps, 100) << "1 mm at 1 mm/s in steps of 0.01 s";
    EXPECT_EQ(found.loss, "");
}

/// A killed program notifies no module; its module may be in a service that does not return.
TEST(RcsProcess, EndsAfterCallerIsKilled) {
    own_path("small_module");  // the folder's name is this process's
    for (const std::string name : {"hangs", "blocks_signals", "small_module"}) {
        const pid_t caller = ::fork();
        if (caller == 0) {
            RcsModule module = begin(name, {.response_timeout_ms = 600'000});
            make_ready(module);
            queue(module, 10);
            step_ahead(module, RcsPrefetch::to_end, false);
            for (;;) ::pause();
        }
        EXPECT_TRUE(soon([&] { return !bound_processes(name).empty(); })) << name;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        ::kill(caller, SIGKILL);
        ::waitpid(caller, nullptr, 0);
        EXPECT_TRUE(soon([&] { return bound_processes(name).empty(); })) << name;
    }
}

TEST(RcsProcess, ReportsMissingOrInvalidHostProgram) {
    const auto none = start_rcs_process("/there/is/none", module_path("small_module"), slides());
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().message, "cannot run /there/is/none: No such file or directory");
    const auto other = start_rcs_process("/bin/true", module_path("small_module"), slides());
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().message,
              "the controller module small_module.so ended its process (status 0) while it was loaded");
}

}  // namespace
}  // namespace gsim::rrs::rcs_process_test
