#include "engine/cancel.h"

#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/run.h"
#include "tests/engine/memory_files.h"

namespace gsim::engine::cancel_test {
namespace {

using testing::HasSubstr;

TEST(Cancel, EndsRunFromAnotherThread) {
    Request request =
        make_request("part.lua", {{"part.lua", "require 'gsim'\nwhile true do G4{p=0.001} end\n"}});
    request.limits.machine_s = 1e12;
    request.limits.blocks = 1'000'000'000'000;
    engine::Run run = engine::Run::open(request).value();
    ASSERT_TRUE(run.prepare());
    std::thread other([cancel = request.cancel]() mutable {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        cancel.now();
    });
    const Report report = run.go().value();
    other.join();
    EXPECT_EQ(report.status, RunStatus::stopped);
    EXPECT_THAT(report.alarm->message, HasSubstr("cancelled"));
    EXPECT_EQ(report.alarm->location.line, 2U);
}

TEST(Cancel, EndsLoopWithoutMotion) {
    Request request =
        make_request("part.lua", {{"part.lua", "require 'gsim'\nG0{x=5}\nwhile true do end\n"}});
    request.limits.steps = 1'000'000'000'000;
    engine::Run run = engine::Run::open(request).value();
    ASSERT_TRUE(run.prepare());
    std::thread other([cancel = request.cancel]() mutable {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        cancel.now();
    });
    EXPECT_EQ(run.go().value().status, RunStatus::stopped);
    other.join();
}

TEST(Cancel, EndsTranslation) {
    Request request = make_request("part.nc", {{"part.nc", std::string(1 << 20, '\n') + "G0 X1\nM2\n"}});
    request.cancel.now();
    engine::Run run = engine::Run::open(request).value();
    const auto rejected = run.prepare();
    ASSERT_FALSE(rejected);
    EXPECT_THAT(run.make_report(rejected.error()).alarm->message, HasSubstr("cancelled"));
}

TEST(Cancel, EndsRunFromMovesCallback) {
    std::string program = "F6000\n";
    for (int i = 0; i < 5000; ++i) program += i % 2 == 0 ? "G1 X10\n" : "G1 X0\n";
    Request request = make_request("part.nc", {{"part.nc", program}});
    engine::Run run = engine::Run::open(request).value();
    ASSERT_TRUE(run.prepare());
    run.on_moves([&](std::span<const Move>) { request.cancel.now(); });
    const Report report = run.go().value();
    EXPECT_EQ(report.status, RunStatus::stopped);
    EXPECT_LT(report.counts.moves, 5000U);
}

}  // namespace
}  // namespace gsim::engine::cancel_test
