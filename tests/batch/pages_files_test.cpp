// Pages of a nightly check: what they do to the folder that they are in.

#include <fstream>
#include <map>
#include <string>

#include <gmock/gmock.h>

#include "tests/batch/pages_fixture.h"

namespace gsim::batch::pages_test {
namespace {

using testing::HasSubstr;

TEST_F(Pages, HaveStableNames) {
    EXPECT_EQ(page_name("mill/dome.nc"), page_name("mill/dome.nc"));
    EXPECT_THAT(page_name("mill/dome.nc"), testing::MatchesRegex("mill-dome-nc-[0-9a-f]{16}\\.html"));
    EXPECT_NE(page_name("mill/dome.nc"), page_name("mill-dome.nc"));
    EXPECT_THAT(page_name(""), testing::StartsWith("program-"));
}

TEST_F(Pages, AreUntouchedIfNothingChanged) {
    batch({{.program = "a.nc"}, {.program = "b.nc", .cause = "feed"}});
    write_and_read();
    std::map<std::string, std::pair<std::string, fs::file_time_type>> before;
    for (const auto& entry : fs::directory_iterator(site_))
        before[entry.path().string()] = {text_in(entry), entry.last_write_time()};
    write_and_read();
    for (const auto& [file, content] : before) {
        EXPECT_EQ(text_in(file), content.first);
        EXPECT_EQ(fs::last_write_time(file), content.second) << file;
    }
}

TEST_F(Pages, AreRemovedWithProgramButOtherFilesStay) {
    batch({{.program = "a.nc"}, {.program = "b.nc"}});
    write_and_read();
    fs::copy_file(site_ / page_name("b.nc"), site_ / "kept.html");
    std::ofstream(site_ / "notes.html") << "<p>mine</p>";
    std::ofstream(site_ / "programs.zip") << "zip";
    fs::create_directory(site_ / "folder.html");
    batch({{.program = "a.nc"}});
    ASSERT_TRUE(write());
    EXPECT_TRUE(fs::exists(site_ / page_name("a.nc")));
    EXPECT_FALSE(fs::exists(site_ / page_name("b.nc")));
    for (const char* name : {"kept.html", "notes.html", "programs.zip", "folder.html"})
        EXPECT_TRUE(fs::exists(site_ / name)) << name;
}

TEST_F(Pages, DoNotOverwriteOtherFiles) {
    batch({{.program = "a.nc"}});
    fs::create_directory(site_);
    std::ofstream(site_ / "index.html") << "my front page";
    const auto written = write();
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().message, HasSubstr("index.html' is not a page written by --pages"));
    EXPECT_EQ(text_in(site_ / "index.html"), "my front page");
    fs::remove(site_ / "index.html");
    fs::create_directory(site_ / "index.html");
    EXPECT_THAT(write().error().message, HasSubstr("cannot write"));
}

TEST_F(Pages, NeedFolderAndBatch) {
    auto results = Results::open(file_);
    auto empty = Database::open(file_, true);
    EXPECT_THAT(write_pages(*empty, {.folder = site_.string()}).error().message,
                HasSubstr("contains no batch"));
    EXPECT_FALSE(fs::exists(site_));
    batch({{.program = "a.nc"}});
    const auto written = write_pages(*empty, {.folder = file_ + "/site"});
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().message, HasSubstr("r.sqlite/site"));
}

// In a file of results that machines share, a writer waits for readers that have not finished.
TEST_F(Pages, LeaveResultsUnlocked) {
    batch({{.program = "a.nc"}});
    ASSERT_TRUE(Results::open(file_, Journal::rollback));
    auto reader = Database::open(file_, true);
    ASSERT_TRUE(write_pages(*reader, {.folder = site_.string()}));
    auto results = Results::open(file_, Journal::rollback);
    ASSERT_TRUE(results->begin_batch("plan.toml", 1, "v"));
    EXPECT_TRUE(results->end_batch(false));
}

}  // namespace
}  // namespace gsim::batch::pages_test
