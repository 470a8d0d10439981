#include "controller/module/rcs_trial.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace gsim::rrs::rcs_trial_test {
namespace {

constexpr int kPlenty_ms = 10'000;

TEST(RcsTrial, ReturnsResultWithoutSideEffects) {
    int changed = 0;
    const std::string text = fmt::format("one line\nand another {:x>20000}", "");
    const auto said = run_trial(
        [&] {
            changed = 1;
            return text;
        },
        kPlenty_ms);
    ASSERT_TRUE(said.has_value());
    EXPECT_EQ(*said, text);
    EXPECT_EQ(changed, 0);
    EXPECT_EQ(run_trial([] { return std::string(); }, kPlenty_ms).value(), "");
}

TEST(RcsTrial, CrashEndsChildOnly) {
    const auto crash = [](int signal) {
        return run_trial(
            [signal]() -> std::string {
                std::raise(signal);
                return "";
            },
            kPlenty_ms);
    };
    EXPECT_EQ(crash(SIGSEGV).error().message, "crashed (signal 11)");
    EXPECT_EQ(crash(SIGABRT).error().message, "crashed (signal 6)");
}

TEST(RcsTrial, ReportsExitOrException) {
    EXPECT_EQ(run_trial([]() -> std::string { std::_Exit(0); }, kPlenty_ms).error().message,
              "ended the program");
    EXPECT_EQ(run_trial([]() -> std::string { std::exit(0); }, kPlenty_ms).error().message,
              "ended the program");
    EXPECT_EQ(run_trial([]() -> std::string { throw 1; }, kPlenty_ms).error().message, "ended the program");
}

TEST(RcsTrial, StopsEndlessWorkAfterTimeout) {
    const auto said = run_trial(
        []() -> std::string {
            for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
        },
        100);
    ASSERT_FALSE(said.has_value());
    EXPECT_EQ(said.error().message, "did not respond within 0.1 s");
}

}  // namespace
}  // namespace gsim::rrs::rcs_trial_test
