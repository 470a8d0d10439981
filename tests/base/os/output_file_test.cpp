#include "base/os/output_file.h"

#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace gsim::os::output_file_test {
namespace {

namespace fs = std::filesystem;

class OutputFileTest : public testing::Test {
  protected:
    OutputFileTest() {
        std::string name = (fs::temp_directory_path() / "output_file_test_XXXXXX").string();
        folder = ::mkdtemp(name.data());
    }
    ~OutputFileTest() override { fs::remove_all(folder); }

    static std::string content(const fs::path& path) {
        std::ifstream file(path);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    static void write(const fs::path& path, std::string_view text) { std::ofstream(path) << text; }
    std::size_t file_count() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
    }

    fs::path folder;
};

TEST_F(OutputFileTest, AppearsOnlyAfterCommit) {
    auto file = OutputFile::open(folder / "a");
    ASSERT_TRUE(file) << file.error().message;
    std::fputs("new", file->stream());
    EXPECT_FALSE(fs::exists(folder / "a"));
    EXPECT_TRUE(file->commit());
    EXPECT_EQ(content(folder / "a"), "new");
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(OutputFileTest, KeepsOldFileWithoutCommit) {
    write(folder / "a", "old");
    {
        auto file = OutputFile::open(folder / "a");
        ASSERT_TRUE(file) << file.error().message;
        std::fputs("new", file->stream());
    }
    EXPECT_EQ(content(folder / "a"), "old");
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(OutputFileTest, KeepsPermissionsAndSymbolicLinks) {
    write(folder / "a", "old");
    fs::permissions(folder / "a", fs::perms(0640));
    fs::create_symlink("a", folder / "link");
    auto file = OutputFile::open(folder / "link");
    ASSERT_TRUE(file) << file.error().message;
    std::fputs("new", file->stream());
    ASSERT_TRUE(file->commit());
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(content(folder / "a"), "new");
    EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms(0640));
}

TEST_F(OutputFileTest, ErrorNamesFile) {
    const auto missing = OutputFile::open(folder / "no" / "a");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().message,
              "cannot write '" + (folder / "no" / "a").string() + "': No such file or directory");
    const auto directory = OutputFile::open(folder);
    ASSERT_FALSE(directory);
    EXPECT_EQ(directory.error().message, "cannot write '" + folder.string() + "': Is a directory");
}

TEST_F(OutputFileTest, KeepPolicyNeverReplacesFile) {
    auto file = OutputFile::open(folder / "a", ExistingFilePolicy::keep);
    ASSERT_TRUE(file) << file.error().message;
    file->write("new");
    write(folder / "a", "somebody else's");
    const auto committed = file->commit();
    ASSERT_FALSE(committed);
    EXPECT_EQ(committed.error().message, "cannot write '" + (folder / "a").string() + "': File exists");
    EXPECT_EQ(content(folder / "a"), "somebody else's");
    EXPECT_TRUE(OutputFile::open(folder / "b", ExistingFilePolicy::keep)->commit());
    EXPECT_TRUE(fs::exists(folder / "b"));
}

TEST_F(OutputFileTest, WritesFileWithDiskDurability) {
    EXPECT_TRUE(write_file(folder / "a", "new", Durability::disk));
    EXPECT_EQ(content(folder / "a"), "new");
    EXPECT_TRUE(write_file("/dev/null", "new", Durability::disk));
}

// The buffer of the stream is empty again when commit() checks it.
TEST(OutputFile, ReportsFirstWriteError) {
    auto file = OutputFile::open("/dev/full");
    if (!file) GTEST_SKIP() << file.error().message;
    file->write(std::string(1 << 20, 'a'));
    const auto committed = file->commit();
    ASSERT_FALSE(committed);
    EXPECT_EQ(committed.error().message, "cannot write '/dev/full': No space left on device");
}

TEST(OutputFile, DoesNotReplaceDevice) {
    auto file = OutputFile::open("/dev/null");
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_TRUE(file->commit());
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(OutputFile, WritesPipeDirectly) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    auto file = OutputFile::open("/dev/fd/" + std::to_string(ends[1]));
    ASSERT_TRUE(file) << file.error().message;
    std::fputs("text", file->stream());
    EXPECT_TRUE(file->commit());
    char text[5] = {};
    EXPECT_EQ(::read(ends[0], text, 4), 4);
    EXPECT_STREQ(text, "text");
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST(OutputFile, ReportsFullDisk) {
    auto file = OutputFile::open("/dev/full");
    if (!file) GTEST_SKIP() << file.error().message;
    std::fputs("text", file->stream());
    const auto committed = file->commit();
    ASSERT_FALSE(committed);
    EXPECT_EQ(committed.error().message, "cannot write '/dev/full': No space left on device");
}

}  // namespace
}  // namespace gsim::os::output_file_test
