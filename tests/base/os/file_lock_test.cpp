#include "base/os/file_lock.h"

#include <fstream>
#include <optional>

#include <gtest/gtest.h>
#include <unistd.h>

namespace gsim::os::file_lock_test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class FileLockTest : public testing::Test {
  protected:
    FileLockTest() {
        std::string name = (fs::temp_directory_path() / "file_lock_test_XXXXXX").string();
        folder_ = fs::canonical(::mkdtemp(name.data()));
        std::ofstream(file_ = folder_ / "d.txt") << "data";
    }
    ~FileLockTest() override { fs::remove_all(folder_); }

    fs::path folder_;
    fs::path file_;
};

TEST_F(FileLockTest, RejectsSecondHolder) {
    std::optional<FileLock> first;
    {
        auto got = FileLock::get(file_, 0ms);
        ASSERT_TRUE(got) << got.error().message;
        first.emplace(*std::move(got));
    }
    const auto second = FileLock::get(file_, 0ms);
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().message,
              "cannot change '" + file_.string() +
                  "': another program is changing it, and has not finished within 0 s (its lock is '" +
                  (folder_ / ".d.txt.lock").string() + "')");
    EXPECT_TRUE(FileLock::get(folder_ / "other", 0ms)) << "another file's";
    first.reset();
    EXPECT_TRUE(FileLock::get(file_, 0ms));
}

TEST_F(FileLockTest, HoldsForSymbolicLinksAndReplacedFile) {
    fs::create_symlink("d.txt", folder_ / "link");
    const auto lock = FileLock::get(folder_ / "link", 0ms);
    ASSERT_TRUE(lock);
    EXPECT_FALSE(FileLock::get(file_, 0ms));
    std::ofstream(folder_ / "new") << "new";
    fs::rename(folder_ / "new", file_);
    EXPECT_FALSE(FileLock::get(file_, 0ms)) << "the file was replaced";
}

TEST_F(FileLockTest, ReusesStaleLockAndRemovesIt) {
    std::ofstream(folder_ / ".d.txt.lock") << "";
    EXPECT_TRUE(FileLock::get(file_, 0ms));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(FileLockTest, DevicesAreNotLocked) {
    const auto lock = FileLock::get("/dev/null", 0ms);
    EXPECT_TRUE(lock);
    EXPECT_TRUE(FileLock::get("/dev/null", 0ms));
}

TEST_F(FileLockTest, ErrorNamesFile) {
    const auto lock = FileLock::get(folder_ / "no" / "d.txt", 0ms);
    ASSERT_FALSE(lock);
    EXPECT_EQ(lock.error().message,
              "cannot write '" + (folder_ / "no" / "d.txt").string() + "': No such file or directory");
}

}  // namespace
}  // namespace gsim::os::file_lock_test
