// Pages of a nightly check: the pages of finished runs.

#include <fstream>
#include <string>

#include <gmock/gmock.h>

#include "tests/batch/pages_fixture.h"

namespace gsim::batch::pages_test {
namespace {

using testing::HasSubstr;

/// Makes pages of finished runs as gsim does, as far as files go, and counts them.
class Views : public Pages {
  protected:
    Views() {
        const std::string maker = (folder_ / "maker").string();
        std::ofstream(maker) << "#!/bin/sh\necho \"<title>gsim studio</title> $*\" > \"$3\"\necho x >> '"
                             << (folder_ / "made").string() << "'\nexit 1\n";
        fs::permissions(maker, fs::perms::owner_all);
        views_ = ViewGenerator{.program = maker, .version = "v1"};
    }

    std::size_t view_count() const { return text_in(folder_ / "made").size() / 2; }
    std::string view_file_of(const std::string& program) const {
        return pages_.at(page_name(program))
            .select_node("//a[.='The finished run']")
            .node()
            .attribute("href")
            .value();
    }
    /// As it is on the disk.
    ReadFile file(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
        return {(folder_ / name).string(), InputFiles().file_hash((folder_ / name).string())};
    }
};

TEST_F(Views, ShowFailedAndChangedRuns) {
    const Told failing{.program = "fails.nc", .cause = "feed", .files = {file("fails.nc", "G1")}};
    batch({failing, {.program = "good.nc"}});
    write_and_read();
    ASSERT_THAT(view_file_of("fails.nc"), testing::MatchesRegex("views/run-[0-9a-f]{16}\\.html"));
    EXPECT_THAT(text_in(site_ / view_file_of("fails.nc")), HasSubstr("run --view"));
    EXPECT_THAT(text_in(site_ / view_file_of("fails.nc")), HasSubstr("--machine m.toml fails.nc"));
    EXPECT_EQ(view_file_of("good.nc"), "");
    write_and_read();
    EXPECT_EQ(view_count(), 1U) << "what is there is not made again";
    batch({failing, {.program = "good.nc", .time_s = 11, .program_sha256 = "3"}});
    write_and_read();
    EXPECT_NE(view_file_of("good.nc"), "");
    EXPECT_EQ(view_count(), 2U);
}

TEST_F(Views, AreOmittedIfRunCannotBeRepeated) {
    const ReadFile changed = file("changed.nc", "G1");
    file("changed.nc", "G0");
    batch({{.program = "changed.nc", .cause = "feed", .files = {changed}},
           {.program = "old.nc", .cause = "feed", .version = "v0"},
           {.program = "edited.nc", .cause = "feed", .settings = {{"machine.axis.X.max_mm", 5}}},
           {.program = "refused.nc", .cause = "syntax", .status = "refused"}});
    write_and_read();
    EXPECT_EQ(view_count(), 0U);
    EXPECT_THAT(words_of_page("changed.nc"), HasSubstr("changed.nc' has changed since the run."));
    EXPECT_THAT(words_of_page("old.nc"), HasSubstr("it was run by another version of gsim."));
    EXPECT_THAT(words_of_page("edited.nc"), HasSubstr("gsim run has no option for machine.axis.X.max_mm."));
    EXPECT_THAT(words_of_page("refused.nc"), HasSubstr("the program was not run."));
}

TEST_F(Views, AreRemovedIfObsoleteButOtherFilesStay) {
    batch({{.program = "a.nc", .cause = "feed"}});
    write_and_read();
    const fs::path view = site_ / view_file_of("a.nc"), other = site_ / "views/run-0123456789abcdef.html";
    std::ofstream(other) << "mine";
    std::ofstream(site_ / "views/kept.html") << text_in(view);
    batch({{.program = "a.nc"}});
    batch({{.program = "a.nc"}});
    write_and_read();
    EXPECT_FALSE(fs::exists(view));
    EXPECT_TRUE(fs::exists(other));
    EXPECT_TRUE(fs::exists(site_ / "views/kept.html"));
}

TEST_F(Views, ReportReasonIfNotCreated) {
    views_->program = (folder_ / "none").string();
    batch({{.program = "a.nc", .cause = "feed"}});
    write_and_read();
    EXPECT_THAT(words_of_page("a.nc"),
                HasSubstr("The page of the finished run is not available: cannot run"));
}

}  // namespace
}  // namespace gsim::batch::pages_test
