#include "base/os/confinement.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/os/descriptor.h"

namespace gsim::os {
namespace {

namespace fs = std::filesystem;

/// Returns the errno of opening a file, or 0 on success.
int error_of_opening(const fs::path& path, int flags) {
    const Descriptor opened(::open(path.c_str(), flags | O_CLOEXEC, 0600));
    return opened.number() < 0 ? errno : 0;
}

void write_text(const fs::path& path) {
    std::FILE* const file = std::fopen(path.c_str(), "w");
    ASSERT_NE(file, nullptr);
    std::fputs("text", file);
    std::fclose(file);
}

/// Confinement of a separate process, because it cannot be undone.
class Confinement : public testing::Test {
  protected:
    Confinement() {
        std::string name = (fs::temp_directory_path() / "gsim_confinement_XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
        for (const char* part : {"read", "changed", "other"}) {
            fs::create_directory(folder_ / part);
            write_text(folder_ / part / "file");
        }
        allowed_.read = {folder_ / "read", folder_ / "not there"};
        allowed_.changed = {folder_ / "changed"};
        allowed_.written = {"/dev/null"};
    }
    ~Confinement() override { fs::remove_all(folder_); }

    /// Returns the result of `look` in a process that is confined to allowed_, or -1 if the system cannot
    /// confine.
    int confined(const std::function<int()>& look) const {
        const pid_t child = ::fork();
        if (child == 0) {
            const auto done = confine(allowed_);
            if (!done) ::_exit(254);
            ::_exit(*done ? look() : 255);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        const int ended = WIFEXITED(status) ? WEXITSTATUS(status) : 253;
        return ended == 255 ? -1 : ended;
    }

    fs::path folder_;
    SandboxPolicy allowed_;
};

#define GSIM_SKIP_WITHOUT_CONFINEMENT \
    if (confined([] { return 0; }) == -1) GTEST_SKIP() << "this system confines no process"

TEST_F(Confinement, AllowsReadingOnlyListedPaths) {
    GSIM_SKIP_WITHOUT_CONFINEMENT;
    EXPECT_EQ(confined([&] { return error_of_opening(folder_ / "read" / "file", O_RDONLY); }), 0);
    EXPECT_EQ(confined([&] { return error_of_opening(folder_ / "changed" / "file", O_RDONLY); }), 0);
    EXPECT_EQ(confined([&] { return error_of_opening(folder_ / "other" / "file", O_RDONLY); }), EACCES);
    EXPECT_EQ(confined([&] { return error_of_opening("/etc/passwd", O_RDONLY); }), EACCES);
    EXPECT_EQ(confined([&] { return error_of_opening("/proc/self/environ", O_RDONLY); }), EACCES);
}

TEST_F(Confinement, AllowsWritingOnlyListedPaths) {
    GSIM_SKIP_WITHOUT_CONFINEMENT;
    constexpr int kMake = O_WRONLY | O_CREAT | O_EXCL;
    EXPECT_EQ(confined([&] { return error_of_opening(folder_ / "changed" / "new", kMake); }), 0);
    EXPECT_TRUE(fs::exists(folder_ / "changed" / "new"));
    EXPECT_EQ(confined([&] { return error_of_opening(folder_ / "read" / "new", kMake); }), EACCES);
    EXPECT_EQ(confined([&] { return error_of_opening(folder_ / "read" / "file", O_WRONLY); }), EACCES);
    EXPECT_EQ(confined([&] { return error_of_opening(folder_ / "other" / "file", O_WRONLY); }), EACCES);
    EXPECT_EQ(confined([&] { return error_of_opening("/dev/null", O_WRONLY); }), 0);
    EXPECT_EQ(confined([&] { return error_of_opening("/dev/full", O_WRONLY); }), EACCES);
}

TEST_F(Confinement, RenamesAndRemovesOnlyInWritableFolders) {
    GSIM_SKIP_WITHOUT_CONFINEMENT;
    const auto rename = [&](const char* from, const char* to) {
        return confined(
            [&] { return ::rename((folder_ / from).c_str(), (folder_ / to).c_str()) == 0 ? 0 : errno; });
    };
    EXPECT_EQ(rename("changed/file", "changed/renamed"), 0);
    EXPECT_NE(rename("changed/renamed", "other/file"), 0);
    EXPECT_NE(rename("other/file", "changed/renamed"), 0);
    EXPECT_EQ(confined([&] { return ::unlink((folder_ / "read" / "file").c_str()) == 0 ? 0 : errno; }),
              EACCES);
}

TEST_F(Confinement, StartsNoProgram) {
    GSIM_SKIP_WITHOUT_CONFINEMENT;
    EXPECT_EQ(confined([] {
                  ::execl("/bin/true", "true", nullptr);
                  return errno;
              }),
              EACCES);
}

// Landlock confines connections from its version 4 on (Linux 6.7).
TEST_F(Confinement, ConnectsToNoPort) {
    GSIM_SKIP_WITHOUT_CONFINEMENT;
    constexpr long kFirstVersionWithNetwork = 4;
    constexpr unsigned kQueryVersion = 1;  // LANDLOCK_CREATE_RULESET_VERSION
    if (::syscall(SYS_landlock_create_ruleset, nullptr, std::size_t{0}, kQueryVersion) <
        kFirstVersionWithNetwork)
        GTEST_SKIP() << "this system confines no connections";
    const Descriptor listener(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto* const general = reinterpret_cast<sockaddr*>(&address);
    socklen_t size = sizeof address;
    ASSERT_EQ(::bind(listener.number(), general, size), 0);
    ASSERT_EQ(::listen(listener.number(), 4), 0);
    ASSERT_EQ(::getsockname(listener.number(), general, &size), 0);
    const auto connect = [&] {
        const Descriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
        return ::connect(socket.number(), general, size) == 0 ? 0 : errno;
    };
    EXPECT_EQ(connect(), 0);
    EXPECT_EQ(confined(connect), EACCES);
}

TEST_F(Confinement, OpenFilesStayUsable) {
    GSIM_SKIP_WITHOUT_CONFINEMENT;
    const Descriptor opened(::open((folder_ / "other" / "file").c_str(), O_RDWR | O_CLOEXEC));
    EXPECT_EQ(confined([&] {
                  char byte = 0;
                  return ::pread(opened.number(), &byte, 1, 0) == 1 &&
                                 ::pwrite(opened.number(), "T", 1, 0) == 1
                             ? 0
                             : errno;
              }),
              0);
}

}  // namespace
}  // namespace gsim::os
