// Pages of a nightly check: what they say of two batches.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/batch/pages_fixture.h"

namespace gsim::batch::pages_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(Pages, ReportChanges) {
    batch({{.program = "good.nc"},
           {.program = "breaks.nc"},
           {.program = "mended.nc", .cause = "feed"},
           {.program = "slower.nc", .time_s = 100},
           {.program = "faster.nc", .time_s = 8},
           {.program = "rounded.nc", .time_s = 10},
           {.program = "other.nc", .cause = "axis-limit"},
           {.program = "gone.nc"}});
    batch({{.program = "good.nc"},
           {.program = "breaks.nc", .cause = "collision", .text = "the nozzle meets the clamp"},
           {.program = "mended.nc", .program_sha256 = "3"},
           {.program = "slower.nc", .time_s = 101, .machine_sha256 = "9"},
           {.program = "faster.nc", .time_s = 4, .program_sha256 = "3"},
           {.program = "rounded.nc", .time_s = 10.000001, .version = "v2"},
           {.program = "other.nc", .cause = "zone"},
           {.program = "new.nc"}});
    write_and_read();
    EXPECT_THAT(rows_below("newly-failing"),
                ElementsAre(ElementsAre("breaks.nc", "m.toml", "violations : collision",
                                        "the nozzle meets the clamp  breaks.nc:7", "unknown")));
    EXPECT_THAT(rows_below("fixed"), ElementsAre(ElementsAre("mended.nc", "m.toml", "violations : feed",
                                                             "too far  mended.nc:7", "the program")));
    EXPECT_THAT(
        rows_below("times"),
        ElementsAre(ElementsAre("faster.nc", "m.toml", "8.000", "4.000", "-4 s (-50 %)", "the program"),
                    ElementsAre("slower.nc", "m.toml", "100.000", "101.000", "+1 s (+1 %)", "the machine")));
    EXPECT_THAT(rows_below("findings"), ElementsAre(testing::Contains("violations : zone")));
    EXPECT_THAT(rows_below("new"), ElementsAre(testing::Contains("new.nc")));
    EXPECT_THAT(rows_below("removed"), ElementsAre(testing::Contains("gone.nc")));
    EXPECT_THAT(page_words(front().select_node("//ul").node()), HasSubstr("2 unchanged"));
    EXPECT_EQ(pages_.size(), 9U) << "the front page and eight programs";
    EXPECT_FALSE(pages_.contains(page_name("gone.nc")));
}

TEST_F(Pages, GroupFailuresByCause) {
    batch({{.program = "a.nc", .cause = "feed"},
           {.program = "b.nc", .cause = "axis-limit"},
           {.program = "c.nc", .cause = "axis-limit"},
           {.program = "d.nc"}});
    write_and_read();
    std::vector<std::string> causes;
    for (const auto& each : front().select_nodes("//h2[.='Failures']/following-sibling::h3"))
        causes.push_back(page_words(each.node()));
    EXPECT_THAT(causes, ElementsAre("violations : axis-limit, 2 runs of 2 programs",
                                    "violations : feed, 1 run of 1 program"));
    const std::string all = page_words(front());
    EXPECT_THAT(all, HasSubstr("There is no earlier batch."));
    EXPECT_THAT(page_words(front().select_node("//dl").node()), HasSubstr("Without errors 1 Failed 3"));
    EXPECT_THAT(words_of_page("b.nc"), HasSubstr("b.nc:7 error : too far  [axis-limit]"));
}

TEST_F(Pages, ReportReasonForNewRun) {
    batch({{.program = "a.nc",
            .files = {{"a.nc", "1"},
                      {"m.toml", "2"},
                      {"sub.nc", "1"},
                      {"tools.txt", ""},
                      {"old.stl", "5"},
                      {"same", "6"}}}});
    batch({{.program = "a.nc",
            .time_s = 11,
            .program_sha256 = "7",
            .machine_sha256 = "8",
            .files = {{"a.nc", "7"},
                      {"m.toml", "8"},
                      {"sub.nc", "2"},
                      {"tools.txt", "3"},
                      {"old.stl", ""},
                      {"same", "6"},
                      {"further", "4"}},
            .version = "v2"}});
    write_and_read();
    const std::string reason =
        "the program, the machine, 'old.stl' no longer exists, 'sub.nc', 'tools.txt' now exists, "
        "the version of gsim";
    EXPECT_THAT(rows_below("times"), ElementsAre(testing::Contains(reason)));
    EXPECT_THAT(words_of_page("a.nc"), HasSubstr("Reason for the new run: " + reason));
    EXPECT_THAT(words_of_page("a.nc"), HasSubstr("old.stl not found by the run"));
}

// If a remark was added above, the same finding is on another line.
TEST_F(Pages, MatchSameFindingOnOtherLine) {
    batch({{.program = "a.nc", .cause = "feed"}});
    batch({{.program = "a.nc", .cause = "feed", .program_sha256 = "3"}});
    write_and_read();
    EXPECT_THAT(rows_below("findings"), ElementsAre());
    batch({{.program = "a.nc", .cause = "feed", .program_sha256 = "3", .text = "further"}});
    write_and_read();
    EXPECT_EQ(rows_below("findings").size(), 1U);
}

TEST_F(Pages, CompareWithRequestedBatch) {
    batch({{.program = "a.nc", .time_s = 10}});
    batch({{.program = "a.nc", .time_s = 20}});
    batch({{.program = "a.nc", .time_s = 20}});
    write_and_read();
    EXPECT_THAT(rows_below("times"), ElementsAre());
    write_and_read(1);
    EXPECT_THAT(rows_below("times"), ElementsAre(testing::Contains("+10 s (+100 %)")));
    EXPECT_THAT(write(3).error().message, HasSubstr("there is no batch 3 before the latest one"));
    EXPECT_THAT(write(-1).error().message, HasSubstr("no batch -1"));
}

TEST_F(Pages, HaveHistoryOfProgram) {
    batch({{.program = "a.nc", .time_s = 10}});
    batch({{.program = "a.nc", .time_s = 10}});
    batch({{.program = "b.nc"}});
    batch({{.program = "a.nc", .time_s = 12, .cause = "feed"}});
    write_and_read();
    const std::string words = words_of_page("a.nc");
    EXPECT_THAT(words, HasSubstr("It was last without errors in batch 2"));
    const pugi::xml_node svg = pages_.at(page_name("a.nc")).select_node("//svg").node();
    EXPECT_EQ(svg.select_nodes("circle/title").size(), 2U);
    EXPECT_THAT(page_words(svg.select_node("path/title").node()), HasSubstr("violations 12.000 s"));
    std::vector<std::string> batches;
    for (const auto& each :
         pages_.at(page_name("a.nc")).select_nodes("//table[@aria-label='History']/tbody/tr/th"))
        batches.push_back(page_words(each.node()));
    EXPECT_THAT(batches, ElementsAre("4", "1 to 2")) << "a run that was found again is one row";
    EXPECT_THAT(words, HasSubstr("+2 s (+20 %)"));
}

TEST_F(Pages, ReportIncompleteBatch) {
    batch({{.program = "a.nc"}, {.program = "b.nc"}});
    batch({{.program = "a.nc"}}, false, "other.toml");
    write_and_read();
    const std::string words = page_words(front());
    EXPECT_THAT(words, HasSubstr("the batch was interrupted, or is running"));
    EXPECT_THAT(words, HasSubstr("Removed, or not run yet"));
    EXPECT_THAT(words, HasSubstr("That batch used another plan: plan.toml."));
}

TEST_F(Pages, AcceptAnyName) {
    const std::vector<std::string> names{"a<b>&\"c'.nc",
                                         "../x.nc",
                                         "/etc/passwd",
                                         "räder/größe 1.nc",
                                         "räder/größe-1.nc",
                                         "räder/größe/1.nc",
                                         "<script>alert(1)</script>",
                                         "javascript:alert(1)",
                                         "]]>",
                                         "...",
                                         "{}{0}%n",
                                         "A.nc",
                                         "a.nc",
                                         std::string(300, 'x') + ".nc",
                                         "index.html",
                                         "-rf.nc"};
    std::vector<Told> runs;
    runs.reserve(names.size());
    for (const std::string& name : names)
        runs.push_back({.program = name, .cause = "<i>\"", .machine = name, .text = "<b>" + name});
    batch(runs);
    write_and_read();
    EXPECT_EQ(pages_.size(), names.size() + 1);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2)
        << "results and site, and nothing beside";
    for (const auto& [name, page] : pages_) EXPECT_FALSE(page.select_node("//script | //b | //i")) << name;
    for (const std::string& name : names) {
        EXPECT_LT(page_name(name).size(), 100U);
        EXPECT_EQ(page_words(pages_.at(page_name(name)).select_node("//h1").node()), name);
    }
    // Characters that turn the direction of a text, or move a cursor, are written out.
    batch({{.program = "\u202egnp.nc"}});
    write_and_read();
    EXPECT_EQ(page_words(pages_.at(page_name("\u202egnp.nc")).select_node("//h1").node()), "\\u202egnp.nc");
}

TEST_F(Pages, AreSplitForManyRuns) {
    std::vector<Told> runs;
    for (int i = 0; i < 700; ++i) {
        for (const char* machine : {"m.toml", "n.toml", "o.toml"})
            runs.push_back({.program = fmt::format("p{}.nc", i), .cause = "feed", .machine = machine});
    }
    batch(runs);
    write_and_read();
    ASSERT_TRUE(pages_.contains("runs-2.html"));
    EXPECT_EQ(front().select_nodes("//table[@aria-label='All runs']/tbody/tr").size(), 2000U);
    EXPECT_EQ(pages_.at("runs-2.html").select_nodes("//table/tbody/tr").size(), 100U);
    batch({runs.front()});
    write_and_read();
    EXPECT_FALSE(pages_.contains("runs-2.html"));
    EXPECT_THAT(page_words(front()), HasSubstr("1899 more are not shown here.")) << "of 2,099 that are gone";
}

// The failed ones of 60 variants have their details, at any position.
TEST_F(Pages, HaveDetailsOfFailedVariants) {
    std::vector<Told> runs;
    for (int i = 0; i < 60; ++i)
        runs.push_back({.program = "a.nc",
                        .cause = i == 59 ? "feed" : "",
                        .settings = {{"option.feed_override_percent", i + 1}}});
    batch(runs);
    write_and_read();
    const pugi::xml_document& page = pages_.at(page_name("a.nc"));
    EXPECT_TRUE(page.select_node("//section[@id='case-60']"));
    EXPECT_EQ(page.select_nodes("//section").size(), 40U);
    EXPECT_EQ(page.select_nodes("//table[1]/tbody/tr[th/a]").size(), 40U);
    EXPECT_THAT(words_of_page("a.nc"), HasSubstr("option.feed_override_percent = 60"));
    EXPECT_THAT(words_of_page("a.nc"), HasSubstr("20 more are shown only as a row above."));
}

}  // namespace
}  // namespace gsim::batch::pages_test
