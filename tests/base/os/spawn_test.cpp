#include "base/os/spawn.h"

#include <csignal>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/os/file_handle.h"
#include "base/os/memory_file.h"

namespace gsim::os {
namespace {

/// Returns the output of a program that is started.
std::string said_by(const std::vector<std::string>& command, ProcessGroup group = ProcessGroup::inherited) {
    const FileHandle output = open_memory_file("output");
    SpawnActions actions;
    actions.redirect(::fileno(output.get()), STDOUT_FILENO);
    const auto child = spawn(command, actions, group);
    EXPECT_TRUE(child);
    if (child) wait_for(*child);
    std::rewind(output.get());
    std::string said;
    for (int c = std::fgetc(output.get()); c != EOF; c = std::fgetc(output.get()))
        said += static_cast<char>(c);
    return said;
}

/// Bit n - 1 is signal n.
std::map<std::string, unsigned long long> signals_of_child() {
    std::istringstream lines(said_by({"cat", "/proc/self/status"}));
    std::map<std::string, unsigned long long> signals;
    for (std::string line; std::getline(lines, line);) {
        const std::string name = line.substr(0, line.find(':'));
        if (name == "SigBlk" || name == "SigIgn")
            signals[name] = std::stoull(line.substr(name.size() + 1), nullptr, 16);
    }
    return signals;
}

constexpr unsigned long long bit(int signal) {
    return 1ULL << static_cast<unsigned>(signal - 1);
}

/// As a server holds its signals.
class SpawnTest : public testing::Test {
  protected:
    void SetUp() override {
        sigset_t blocked_signals;
        sigemptyset(&blocked_signals);
        for (const int each : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&blocked_signals, each);
        ::pthread_sigmask(SIG_BLOCK, &blocked_signals, &before_);
        std::signal(SIGPIPE, SIG_IGN);
        std::signal(SIGHUP, SIG_IGN);
    }
    void TearDown() override {
        std::signal(SIGPIPE, SIG_DFL);
        std::signal(SIGHUP, SIG_DFL);
        ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }

    sigset_t before_{};
};

TEST_F(SpawnTest, ChildGetsUnblockedSignalsAndDefaultSigpipe) {
    auto signals = signals_of_child();
    ASSERT_EQ(signals.size(), 2U);
    EXPECT_EQ(signals["SigBlk"], 0U);
    EXPECT_EQ(signals["SigIgn"] & bit(SIGPIPE), 0U);
    EXPECT_NE(signals["SigIgn"] & bit(SIGHUP), 0U) << "as nohup wants it";
}

TEST_F(SpawnTest, ChildGetsRequestedProcessGroup) {
    const std::vector<std::string> command{"/bin/sh", "-c", "echo $$ $(cut -d ' ' -f 5 /proc/$$/stat)"};
    const auto numbers = [&](ProcessGroup group) {
        std::istringstream said(said_by(command, group));
        pid_t child = 0;
        pid_t its_group = 0;
        said >> child >> its_group;
        return std::pair(child, its_group);
    };
    EXPECT_EQ(numbers(ProcessGroup::inherited).second, ::getpgrp());
    const auto [child, its_group] = numbers(ProcessGroup::separate);
    EXPECT_EQ(its_group, child);
}

}  // namespace
}  // namespace gsim::os
