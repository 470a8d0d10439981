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
constexpr WalkBounds kAlways{.most_files = 3, .least_pause = milliseconds(0), .pause_of_walk = 0};

class FolderChangesTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "changes-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
        put("a.nc", "G0\n");
        put("b.nc", "G0\n");
    }
    void TearDown() override { fs::remove_all(folder_); }

    /// Another content has another length here, as a clock may not have moved on.
    void put(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    FolderChanges changes(const WalkBounds& bounds = kAlways) const {
        return FolderChanges(*os::BoundFolder::open(folder_), bounds);
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

TEST_F(FolderChangesTest, TellsWhatHasChangedSinceAnAnswer) {
    FolderChanges changes = this->changes();
    const ChangesAnswer first = changes.since(std::nullopt);
    EXPECT_TRUE(first.again);
    EXPECT_THAT(first.changes, IsEmpty());
    EXPECT_EQ(changes.since(first.at).at, first.at);
    EXPECT_FALSE(changes.since(first.at).again);
    put("b.nc", "G0 X1\n");
    put("c.nc", "");
    const ChangesAnswer second = changes.since(first.at);
    EXPECT_FALSE(second.again);
    EXPECT_THAT(second.changes, ElementsAre(is_there("b.nc"), is_there("c.nc")));
    EXPECT_EQ(second.changes[0].tag, os::BoundFolder::open(folder_)->tag_of("b.nc"));
    fs::remove(folder_ / "a.nc");
    EXPECT_THAT(changes.since(second.at).changes, ElementsAre(is_gone("a.nc")));
    EXPECT_THAT(changes.since(first.at).changes,
                ElementsAre(is_gone("a.nc"), is_there("b.nc"), is_there("c.nc")))
        << "of another tab, which asks later";
    put("a.nc", "G1\n");
    EXPECT_THAT(changes.since(first.at).changes,
                ElementsAre(is_there("a.nc"), is_there("b.nc"), is_there("c.nc")));
}

TEST_F(FolderChangesTest, AnAnswerThatIsUnknownIsAnsweredWithAll) {
    FolderChanges changes = this->changes();
    const std::uint64_t at = changes.since(std::nullopt).at;
    for (const std::uint64_t unknown : {at + 1, std::uint64_t{0}, ~std::uint64_t{0}})
        EXPECT_TRUE(changes.since(unknown).again) << unknown;
}

TEST_F(FolderChangesTest, FilesThatAreGoneAreNotKeptForEver) {
    FolderChanges changes = this->changes();
    const std::uint64_t first = changes.since(std::nullopt).at;
    std::uint64_t at = first;
    for (const char* name : {"1", "2", "3"}) {
        put(name, "");
        at = changes.since(at).at;
        fs::remove(folder_ / name);
        at = changes.since(at).at;
    }
    EXPECT_EQ(changes.since(first).changes.size(), 3U);
    put("4", "");
    at = changes.since(at).at;
    fs::remove(folder_ / "4");
    EXPECT_TRUE(changes.since(first).again) << "four are more than three";
    EXPECT_TRUE(changes.since(at).again) << "it has not heard of the last one";
    at = changes.since(std::nullopt).at;
    EXPECT_FALSE(changes.since(at).again);
    put("a.nc", "G1 X1\n");
    EXPECT_THAT(changes.since(at).changes, ElementsAre(is_there("a.nc")));
}

TEST_F(FolderChangesTest, AFileBeyondThoseThatAreListedIsNotSaidToBeGone) {
    put("c.nc", "");
    FolderChanges changes = this->changes();
    const std::uint64_t at = changes.since(std::nullopt).at;
    put("a2.nc", "");
    EXPECT_THAT(changes.since(at).changes, ElementsAre(is_there("a2.nc")));
    fs::remove(folder_ / "b.nc");
    EXPECT_THAT(changes.since(at).changes, ElementsAre(is_there("a2.nc"), is_gone("b.nc"), is_there("c.nc")));
}

TEST_F(FolderChangesTest, TheFolderIsWalkedSeldomWhereAWalkTakesLong) {
    constexpr std::chrono::hours kLong{24};
    constexpr milliseconds kNone{0};
    constexpr int kHuge = 1'000'000'000;
    const auto is_walked_again = [&](const WalkBounds& bounds) {
        FolderChanges changes = this->changes(bounds);
        const std::uint64_t at = changes.since(std::nullopt).at;
        put("a.nc", content_ += "G0\n");
        return changes.since(at).at != at;
    };
    EXPECT_FALSE(is_walked_again({.least_pause = kLong, .most_pause = kLong, .pause_of_walk = 0}));
    EXPECT_FALSE(is_walked_again({.least_pause = kNone, .most_pause = kLong, .pause_of_walk = kHuge}));
    EXPECT_TRUE(is_walked_again({.least_pause = kNone, .most_pause = kNone, .pause_of_walk = kHuge}));
    EXPECT_TRUE(is_walked_again({.least_pause = kNone, .most_pause = kLong, .pause_of_walk = 0}));
}

}  // namespace
}  // namespace gsim::studio
