#include "base/os/rooted_directory.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/os/safe_name.h"

namespace gsim::os {
namespace {

namespace fs = std::filesystem;
using Kind = DirectoryError::Kind;
using testing::ElementsAre;

constexpr std::size_t kMax = 1000;
constexpr std::size_t kLarge = std::size_t{1} << 20U;

/// Folder with another one next to it that must not be accessed.
class RootedDirectoryTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "bound-XXXXXX").string();
        around_ = ::mkdtemp(name.data());
        fs::create_directories(around_ / "in" / "sub");
        write_file("in/part.nc", "G1 X1\n");
        write_file("in/sub/deep.nc", "G0\n");
        write_file("secret.txt", "secret");
        auto folder = RootedDirectory::open(around_ / "in");
        ASSERT_TRUE(folder) << folder.error().message;
        folder_.emplace(*std::move(folder));
    }
    void TearDown() override { fs::remove_all(around_); }

    void write_file(const std::string& name, const std::string& text) const {
        std::ofstream(around_ / name) << text;
    }
    std::string get(const std::string& name) const {
        std::ifstream file(around_ / name);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    tl::expected<ContentTag, DirectoryError> write(const std::string& name, const ContentTag& before,
                                                   const std::string& text) const {
        return folder_->write(name, before,
                              [&](const RootedDirectory::WriteChunk& chunk) { return chunk(text); });
    }
    std::vector<std::string> names() const {
        bool cut = false;
        std::vector<std::string> found;
        for (const FileEntry& file : folder_->list(kMax, cut)) found.push_back(file.name);
        return found;
    }

    fs::path around_;
    std::optional<RootedDirectory> folder_;
};

TEST_F(RootedDirectoryTest, ListsFilesWithoutHiddenFilesAndLinks) {
    write_file("in/.hidden", "");
    fs::create_symlink(around_ / "secret.txt", around_ / "in/link.txt");
    fs::create_directory_symlink(around_, around_ / "in/up");
    EXPECT_THAT(names(), ElementsAre("part.nc", "sub/deep.nc"));
    bool cut = false;
    EXPECT_EQ(folder_->list(1, cut).size(), 1U);
    EXPECT_TRUE(cut);
}

TEST_F(RootedDirectoryTest, PrefersUpperFoldersIfListIsCut) {
    fs::create_directories(around_ / "in/a/b");
    for (const char* name : {"in/a/1.nc", "in/a/2.nc", "in/a/b/1.nc", "in/z.nc"}) write_file(name, "");
    const auto listed = [&](std::size_t max, bool& cut) {
        std::vector<std::string> found;
        for (const FileEntry& file : folder_->list(max, cut)) found.push_back(file.name);
        return found;
    };
    bool cut = false;
    EXPECT_THAT(listed(6, cut),
                ElementsAre("a/1.nc", "a/2.nc", "a/b/1.nc", "part.nc", "sub/deep.nc", "z.nc"));
    EXPECT_FALSE(cut);
    EXPECT_THAT(listed(5, cut), ElementsAre("a/1.nc", "a/2.nc", "part.nc", "sub/deep.nc", "z.nc"));
    EXPECT_TRUE(cut);
    EXPECT_THAT(listed(3, cut), ElementsAre("a/1.nc", "part.nc", "z.nc"));
    EXPECT_TRUE(cut);
}

TEST_F(RootedDirectoryTest, ReportsCutListIfFoldersAreTooDeepOrMany) {
    bool cut = false;
    fs::path deep = "in/sub";
    for (int depth = 2; depth <= 32; ++depth) deep /= "d";
    fs::create_directories(around_ / deep);
    write_file((deep / "deepest.nc").string(), "");
    EXPECT_EQ(folder_->list(kMax, cut).size(), 3U);
    EXPECT_FALSE(cut);
    fs::create_directory(around_ / deep / "d");
    EXPECT_EQ(folder_->list(kMax, cut).size(), 3U);
    EXPECT_TRUE(cut);
    fs::remove_all(around_ / "in/sub");
    for (int i = 0; i < 20; ++i) fs::create_directory(around_ / "in" / std::to_string(i));
    EXPECT_EQ(folder_->list(20, cut).size(), 1U);
    EXPECT_TRUE(cut);
    EXPECT_EQ(folder_->list(21, cut).size(), 1U);
    EXPECT_FALSE(cut);
}

TEST_F(RootedDirectoryTest, RejectsUnsafeNames) {
    for (const char* name : {"", "/etc/passwd", "../secret.txt", "sub/../../secret.txt", "./part.nc",
                             "sub/./deep.nc", "sub//deep.nc", "sub/", ".hidden", "..", "a\\b", "a\nb"}) {
        const auto read = folder_->read(name, kLarge);
        ASSERT_FALSE(read) << name;
        EXPECT_EQ(read.error().kind, Kind::name) << name;
        const auto written = write(name, "", "x");
        ASSERT_FALSE(written) << name;
        EXPECT_EQ(written.error().kind, Kind::name) << name;
    }
    EXPECT_FALSE(safe_name_parts(std::string("a\0b", 3)));
    EXPECT_EQ(get("secret.txt"), "secret");
}

TEST_F(RootedDirectoryTest, DoesNotFollowLinks) {
    fs::create_symlink(around_ / "secret.txt", around_ / "in/link.txt");
    fs::create_directory_symlink(around_, around_ / "in/up");
    for (const char* name : {"link.txt", "up/secret.txt"}) {
        const auto read = folder_->read(name, kLarge);
        ASSERT_FALSE(read) << name;
        EXPECT_EQ(read.error().kind, Kind::name) << read.error().message;
        EXPECT_FALSE(write(name, "", "x")) << name;
        EXPECT_FALSE(write(name, "1-2-3", "x")) << name;
    }
    EXPECT_FALSE(write("up/new.txt", "", "x"));
    EXPECT_EQ(get("secret.txt"), "secret");
    EXPECT_FALSE(fs::exists(around_ / "new.txt"));
}

TEST_F(RootedDirectoryTest, ReadsOnlyRegularFiles) {
    ASSERT_EQ(::mkfifo((around_ / "in/pipe").c_str(), 0600), 0);
    EXPECT_FALSE(folder_->read("pipe", kLarge));
    EXPECT_FALSE(folder_->read("sub", kLarge));
    const auto absent = folder_->read("none.nc", kLarge);
    ASSERT_FALSE(absent);
    EXPECT_EQ(absent.error().kind, Kind::absent);
    EXPECT_FALSE(folder_->read("part.nc", 2));
}

TEST_F(RootedDirectoryTest, WritesFileAndKeepsPermissions) {
    fs::permissions(around_ / "in/part.nc", fs::perms(0640));
    ContentTag tag;
    ASSERT_EQ(folder_->read("part.nc", kLarge, &tag), "G1 X1\n");
    const auto written = write("part.nc", tag, "G1 X2\n");
    ASSERT_TRUE(written) << written.error().message;
    EXPECT_EQ(get("in/part.nc"), "G1 X2\n");
    EXPECT_EQ(folder_->content_tag("part.nc"), *written);
    EXPECT_NE(tag, *written);
    EXPECT_EQ(fs::status(around_ / "in/part.nc").permissions(), fs::perms(0640));
    EXPECT_EQ(std::distance(fs::directory_iterator(around_ / "in"), {}), 2);  // no other file remains in it
}

TEST_F(RootedDirectoryTest, CreatesNewFileWithItsFolders) {
    ASSERT_TRUE(write("new/of/mine.nc", "", "G4\n"));
    EXPECT_EQ(get("in/new/of/mine.nc"), "G4\n");
}

TEST_F(RootedDirectoryTest, KeepsFileChangedByAnotherProgram) {
    const auto tag = folder_->content_tag("part.nc");
    write_file("in/part.nc", "G1 X99\n");
    const auto late = write("part.nc", *tag, "G1 X2\n");
    ASSERT_FALSE(late);
    EXPECT_EQ(late.error().kind, Kind::conflict);
    EXPECT_EQ(late.error().tag, folder_->content_tag("part.nc"));
    EXPECT_EQ(get("in/part.nc"), "G1 X99\n");

    const auto taken = write("part.nc", "", "G1 X2\n");  // not new any more
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().kind, Kind::conflict);
    fs::remove(around_ / "in/part.nc");
    const auto gone = write("part.nc", *tag, "G1 X2\n");
    ASSERT_FALSE(gone);
    EXPECT_EQ(gone.error().kind, Kind::conflict);
    EXPECT_EQ(gone.error().tag, "");
    EXPECT_FALSE(fs::exists(around_ / "in/part.nc"));
}

// The other program saves between the check of the file and its renaming.
TEST_F(RootedDirectoryTest, KeepsFileChangedDuringWrite) {
    for (const bool is_new : {false, true}) {
        const std::string name = is_new ? "fresh.nc" : "part.nc";
        const auto tag = is_new ? ContentTag() : *folder_->content_tag(name);
        const auto late = folder_->write(name, tag, [&](const RootedDirectory::WriteChunk& chunk) {
            write_file("in/other", "theirs\n");
            fs::rename(around_ / "in/other", around_ / "in" / name);
            return chunk("ours\n");
        });
        ASSERT_FALSE(late) << name;
        EXPECT_EQ(late.error().kind, Kind::conflict);
        EXPECT_EQ(get("in/" + name), "theirs\n");
    }
    EXPECT_THAT(names(), ElementsAre("fresh.nc", "part.nc", "sub/deep.nc"));
}

TEST_F(RootedDirectoryTest, IncompleteContentKeepsOldFile) {
    const auto tag = *folder_->content_tag("part.nc");
    const auto broken = folder_->write("part.nc", tag, [&](const RootedDirectory::WriteChunk& chunk) {
        chunk("G1 ");
        return false;
    });
    EXPECT_FALSE(broken);
    EXPECT_EQ(get("in/part.nc"), "G1 X1\n");
    EXPECT_EQ(std::distance(fs::directory_iterator(around_ / "in"), {}), 2);
}

TEST_F(RootedDirectoryTest, RejectsInvalidRoot) {
    EXPECT_FALSE(RootedDirectory::open(around_ / "secret.txt"));
    EXPECT_FALSE(RootedDirectory::open(around_ / "nowhere"));
}

}  // namespace
}  // namespace gsim::os
