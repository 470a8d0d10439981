#include "studio/server/folder_changes.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsim::studio {

static void PrintTo(const FolderChange& change, std::ostream* stream) {
    *stream << change.name << (change.tag ? "" : " is gone");
}

namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;

/// Checks on each request.
constexpr ScanLimits kAlways{.max_files = 3, .min_pause = milliseconds(0), .pause_per_scan = 0};

class FolderChangesTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "changes-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
        write_file("a.nc", "G0\n");
        write_file("b.nc", "G0\n");
    }
    void TearDown() override { fs::remove_all(folder_); }

    /// Another content has another length here, as a clock may not have moved on.
    void write_file(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    FolderChanges changes(const ScanLimits& bounds = kAlways) const {
        return FolderChanges(*os::RootedDirectory::open(folder_), bounds);
    }

    fs::path folder_;
    std::string content_ = "G0\n";
};

testing::Matcher<FolderChange> is_there(const std::string& name) {
    return testing::AllOf(Field(&FolderChange::name, name),
                          Field(&FolderChange::tag, testing::Ne(std::nullopt)));
}

testing::Matcher<FolderChange> is_gone(const std::string& name) {
    return testing::AllOf(Field(&FolderChange::name, name), Field(&FolderChange::tag, std::nullopt));
}

TEST_F(FolderChangesTest, ReportsChangesSinceResponse) {
    FolderChanges changes = this->changes();
    const FolderChangesResult first = changes.since(std::nullopt);
    EXPECT_TRUE(first.is_incomplete);
    EXPECT_THAT(first.changes, IsEmpty());
    EXPECT_EQ(changes.since(first.at).at, first.at);
    EXPECT_FALSE(changes.since(first.at).is_incomplete);
    write_file("b.nc", "G0 X1\n");
    write_file("c.nc", "");
    const FolderChangesResult second = changes.since(first.at);
    EXPECT_FALSE(second.is_incomplete);
    EXPECT_THAT(second.changes, ElementsAre(is_there("b.nc"), is_there("c.nc")));
    EXPECT_EQ(second.changes[0].tag, os::RootedDirectory::open(folder_)->content_tag("b.nc"));
    fs::remove(folder_ / "a.nc");
    EXPECT_THAT(changes.since(second.at).changes, ElementsAre(is_gone("a.nc")));
    EXPECT_THAT(changes.since(first.at).changes,
                ElementsAre(is_gone("a.nc"), is_there("b.nc"), is_there("c.nc")))
        << "of another tab, which asks later";
    write_file("a.nc", "G1\n");
    EXPECT_THAT(changes.since(first.at).changes,
                ElementsAre(is_there("a.nc"), is_there("b.nc"), is_there("c.nc")));
}

TEST_F(FolderChangesTest, ReportsIncompleteForUnknownResponse) {
    FolderChanges changes = this->changes();
    const std::uint64_t at = changes.since(std::nullopt).at;
    for (const std::uint64_t unknown : {at + 1, std::uint64_t{0}, ~std::uint64_t{0}})
        EXPECT_TRUE(changes.since(unknown).is_incomplete) << unknown;
}

TEST_F(FolderChangesTest, ForgetsOldestDeletedFiles) {
    FolderChanges changes = this->changes();
    const std::uint64_t first = changes.since(std::nullopt).at;
    std::uint64_t at = first;
    for (const char* name : {"1", "2", "3"}) {
        write_file(name, "");
        at = changes.since(at).at;
        fs::remove(folder_ / name);
        at = changes.since(at).at;
    }
    EXPECT_EQ(changes.since(first).changes.size(), 3U);
    write_file("4", "");
    at = changes.since(at).at;
    fs::remove(folder_ / "4");
    EXPECT_TRUE(changes.since(first).is_incomplete) << "four are more than three";
    EXPECT_TRUE(changes.since(at).is_incomplete) << "it has not heard of the last one";
    at = changes.since(std::nullopt).at;
    EXPECT_FALSE(changes.since(at).is_incomplete);
    write_file("a.nc", "G1 X1\n");
    EXPECT_THAT(changes.since(at).changes, ElementsAre(is_there("a.nc")));
}

TEST_F(FolderChangesTest, UnlistedFileIsNotReportedAsDeleted) {
    write_file("c.nc", "");
    FolderChanges changes = this->changes();
    const std::uint64_t at = changes.since(std::nullopt).at;
    write_file("a2.nc", "");
    EXPECT_THAT(changes.since(at).changes, ElementsAre(is_there("a2.nc")));
    fs::remove(folder_ / "b.nc");
    EXPECT_THAT(changes.since(at).changes, ElementsAre(is_there("a2.nc"), is_gone("b.nc"), is_there("c.nc")));
}

TEST_F(FolderChangesTest, ScansFolderRarelyIfScanIsSlow) {
    constexpr std::chrono::hours kLong{24};
    constexpr milliseconds kNoPause{0};
    constexpr int kHuge = 1'000'000'000;
    const auto is_walked_again = [&](const ScanLimits& bounds) {
        FolderChanges changes = this->changes(bounds);
        const std::uint64_t at = changes.since(std::nullopt).at;
        write_file("a.nc", content_ += "G0\n");
        return changes.since(at).at != at;
    };
    EXPECT_FALSE(is_walked_again({.min_pause = kLong, .max_pause = kLong, .pause_per_scan = 0}));
    EXPECT_FALSE(is_walked_again({.min_pause = kNoPause, .max_pause = kLong, .pause_per_scan = kHuge}));
    EXPECT_TRUE(is_walked_again({.min_pause = kNoPause, .max_pause = kNoPause, .pause_per_scan = kHuge}));
    EXPECT_TRUE(is_walked_again({.min_pause = kNoPause, .max_pause = kLong, .pause_per_scan = 0}));
}

}  // namespace
}  // namespace gsim::studio
