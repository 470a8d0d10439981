#include "base/os/temporary_name.h"

#include <csignal>
#include <fstream>
#include <functional>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/os/file_lock.h"
#include "base/os/output_file.h"

namespace gsim::os::temporary_name_test {
namespace {

namespace fs = std::filesystem;

class TemporaryNameTest : public testing::Test {
  protected:
    TemporaryNameTest() {
        std::string name = (fs::temp_directory_path() / "temporary_name_test_XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
        std::ofstream(folder_ / "a") << "old";
    }
    ~TemporaryNameTest() override { fs::remove_all(folder_); }

    std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_), {}); }
    std::string text() const {
        std::ifstream file(folder_ / "a");
        return {std::istreambuf_iterator<char>(file), {}};
    }
    /// The status of a child that does this, as of waitpid().
    static int child(const std::function<void()>& work) {
        const pid_t pid = ::fork();
        if (pid == 0) {
            for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU})
                std::signal(signal, SIG_DFL);
            const rlimit none{};
            ::setrlimit(RLIMIT_CORE, &none);
            work();
            ::_exit(0);
        }
        int status = 0;
        ::waitpid(pid, &status, 0);
        return status;
    }

    fs::path folder_;
};

TEST_F(TemporaryNameTest, SignalRemovesTemporariesAndEndsProgram) {
    for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU}) {
        const int status = child([&] {
            remove_temporaries_at_signals();
            auto file = OutputFile::open(folder_ / "a");
            file->write("new");
            const auto lock = FileLock::get(folder_ / "a", std::chrono::milliseconds(0));
            if (files() != 3) ::_exit(1);
            ::raise(signal);
        });
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
        EXPECT_EQ(files(), 1) << signal;
        EXPECT_EQ(text(), "old");
    }
}

TEST_F(TemporaryNameTest, IgnoredSignalStaysIgnored) {
    const int status = child([&] {
        std::signal(SIGHUP, SIG_IGN);
        remove_temporaries_at_signals();
        auto file = OutputFile::open(folder_ / "a");
        file->write("new");
        ::raise(SIGHUP);
        ::_exit(file->commit() ? 0 : 1);
    });
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    EXPECT_EQ(text(), "new");
    EXPECT_EQ(files(), 1);
}

TEST_F(TemporaryNameTest, SignalInChildKeepsFilesOfParent) {
    const int status = child([&] {
        remove_temporaries_at_signals();
        auto file = OutputFile::open(folder_ / "a");
        file->write("new");
        const pid_t forked = ::fork();
        if (forked == 0) {
            ::raise(SIGINT);
            ::_exit(0);
        }
        ::waitpid(forked, nullptr, 0);
        ::_exit(file->commit() ? 0 : 1);
    });
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    EXPECT_EQ(text(), "new");
}

TEST_F(TemporaryNameTest, ReportsFileAboveSizeLimit) {
    const int status = child([&] {
        remove_temporaries_at_signals();
        const rlimit limit{1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        const auto written = write_file(folder_ / "a", std::string(100'000, 'a'));
        ::_exit(!written && written.error().message.ends_with(": File too large") ? 0 : 1);
    });
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    EXPECT_EQ(text(), "old");
    EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace gsim::os::temporary_name_test
