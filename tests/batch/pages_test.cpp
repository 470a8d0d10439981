// Pages of a nightly check: what they say of two batches, and what they do to the folder that they are in.

#include "batch/pages/pages.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <pugixml.hpp>
#include <unistd.h>

#include "batch/pages/page_name.h"
#include "batch/store/results.h"

namespace gsim::batch::pages_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Run as a test describes it; two equal descriptions are one run.
struct Told {
    std::string program;
    double time_s = 10;
    std::string cause = {};
    std::string program_sha256 = "1", machine_sha256 = "2";
    std::vector<ReadFile> files = {};
    std::string version = "v1", machine = "m.toml";
    std::string status = {};
    std::string text = "too far";
    std::vector<SettingValue> settings = {};

    auto operator<=>(const Told& other) const { return key() <=> other.key(); }
    std::string key() const {
        std::string all =
            fmt::format("{} {} {} {} {} {} {} {} {} {}", program, time_s, cause, program_sha256,
                        machine_sha256, version, machine, status, text, settings_json(settings).dump());
        for (const ReadFile& file : files) all += file.name + file.sha256;
        return all;
    }
};

RunRow run_row(const Told& reported) {
    RunRow row{.status = reported.status,
               .cause = reported.cause,
               .machine = "M",
               .controller = "exact-stop",
               .cycle_time_s = reported.time_s,
               .extents = R"({"X":[0,10]})",
               .findings = "[]",
               .files = reported.files};
    if (row.status.empty()) row.status = reported.cause.empty() ? "completed" : "violations";
    if (reported.cause.empty()) return row;
    row.message = reported.text;
    row.file = reported.program;
    row.line = 7;
    row.violations = 1;
    row.findings = nlohmann::json::array({{{"severity", "error"},
                                           {"code", reported.cause},
                                           {"file", reported.program},
                                           {"line", 7},
                                           {"text", reported.text}}})
                       .dump();
    return row;
}

std::string text_in(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Returns all text below a node, parts separated by a blank.
std::string page_words(const pugi::xml_node& node) {
    std::string words;
    if (node.type() == pugi::node_pcdata) words = node.value();
    for (const pugi::xml_node& child : node.children()) {
        const std::string more = page_words(child);
        if (!more.empty()) words += (words.empty() ? "" : " ") + more;
    }
    return words;
}

class Pages : public testing::Test {
  protected:
    Pages() { fs::create_directories(folder_); }
    ~Pages() override { fs::remove_all(folder_); }

    void batch(const std::vector<Told>& runs, bool complete = true, const std::string& plan = "plan.toml") {
        auto results = Results::open(file_);
        ASSERT_TRUE(results) << results.error();
        ASSERT_TRUE(results->begin_batch(plan, runs.size(), "v"));
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const Job job{.number = i,
                          .program = runs[i].program,
                          .machine = runs[i].machine,
                          .options = nlohmann::json::object(),
                          .settings = runs[i].settings};
            const auto known = runs_.find(runs[i]);
            const std::int64_t run =
                known != runs_.end() ? known->second
                                     : results
                                           ->add(job, {"k", runs[i].program_sha256, runs[i].machine_sha256},
                                                 run_row(runs[i]), runs[i].version)
                                           .value();
            ASSERT_TRUE(results->record(i, run, known != runs_.end()));
            runs_[runs[i]] = run;
        }
        ASSERT_TRUE(results->end_batch(complete));
    }

    tl::expected<void, std::string> write(std::int64_t since = 0) {
        auto results = Database::open(file_, true);
        EXPECT_TRUE(results) << results.error();
        return write_pages(*results, {.folder = site_.string(), .since = since, .views = views_});
    }

    void write_and_read(std::int64_t since = 0) {
        const auto written = write(since);
        ASSERT_TRUE(written) << written.error();
        pages_.clear();
        for (const auto& entry : fs::directory_iterator(site_)) {
            if (entry.is_directory()) continue;
            const auto read = pages_[entry.path().filename().string()].load_file(entry.path().c_str());
            ASSERT_TRUE(read) << entry.path() << ": " << read.description() << " at " << read.offset;
        }
        expect_that_links_lead_somewhere();
    }

    void expect_that_links_lead_somewhere() const {
        for (const auto& [name, page] : pages_) {
            for (const auto& each : page.select_nodes("//a")) {
                const std::string address = each.node().attribute("href").value();
                if (address.starts_with("views/")) {
                    EXPECT_TRUE(fs::exists(site_ / address)) << address;
                    continue;
                }
                const std::size_t hash = address.find('#');
                const std::string file = address.substr(0, hash);
                const auto there = pages_.find(file.empty() ? name : file);
                ASSERT_NE(there, pages_.end()) << address << " of " << name;
                if (hash == std::string::npos) continue;
                const std::string place = "//*[@id='" + address.substr(hash + 1) + "']";
                EXPECT_TRUE(there->second.select_node(place.c_str())) << address << " of " << name;
            }
        }
    }

    const pugi::xml_document& front() const { return pages_.at("index.html"); }
    std::string words_of_page(const std::string& program) const {
        return page_words(pages_.at(page_name(program)).select_node("//main").node());
    }

    /// The rows of the list below a heading of the front page, cell by cell.
    std::vector<std::vector<std::string>> rows_below(const std::string& id) const {
        std::vector<std::vector<std::string>> rows;
        const auto heading = front().select_node(("//h3[@id='" + id + "']").c_str()).node();
        for (const auto& each : heading.next_sibling("div").select_nodes("table/tbody/tr")) {
            std::vector<std::string>& row = rows.emplace_back();
            for (const pugi::xml_node& cell : each.node().children()) row.push_back(page_words(cell));
        }
        return rows;
    }

    fs::path folder_ = fs::temp_directory_path() / ("gsim-pages-" + std::to_string(::getpid()));
    fs::path site_ = folder_ / "site";
    std::string file_ = (folder_ / "r.sqlite").string();
    std::optional<ViewMaker> views_;
    std::map<Told, std::int64_t> runs_;
    std::map<std::string, pugi::xml_document> pages_;
};

TEST_F(Pages, TellWhatHasChanged) {
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
    EXPECT_THAT(
        rows_below("newly-failing"),
        ElementsAre(ElementsAre("breaks.nc", "m.toml", "violations : collision",
                                "the nozzle meets the clamp  breaks.nc:7", "nothing that is known of")));
    EXPECT_THAT(rows_below("mended"), ElementsAre(ElementsAre("mended.nc", "m.toml", "violations : feed",
                                                              "too far  mended.nc:7", "the program")));
    EXPECT_THAT(
        rows_below("times"),
        ElementsAre(ElementsAre("faster.nc", "m.toml", "8.000", "4.000", "-4 s (-50 %)", "the program"),
                    ElementsAre("slower.nc", "m.toml", "100.000", "101.000", "+1 s (+1 %)", "the machine")));
    EXPECT_THAT(rows_below("findings"), ElementsAre(testing::Contains("violations : zone")));
    EXPECT_THAT(rows_below("new"), ElementsAre(testing::Contains("new.nc")));
    EXPECT_THAT(rows_below("gone"), ElementsAre(testing::Contains("gone.nc")));
    EXPECT_THAT(page_words(front().select_node("//ul").node()), HasSubstr("2 as before"));
    EXPECT_EQ(pages_.size(), 9U) << "the front page and eight programs";
    EXPECT_FALSE(pages_.contains(page_name("gone.nc")));
}

TEST_F(Pages, TellWhatFailsByItsCause) {
    batch({{.program = "a.nc", .cause = "feed"},
           {.program = "b.nc", .cause = "axis-limit"},
           {.program = "c.nc", .cause = "axis-limit"},
           {.program = "d.nc"}});
    write_and_read();
    std::vector<std::string> causes;
    for (const auto& each : front().select_nodes("//h2[.='What fails']/following-sibling::h3"))
        causes.push_back(page_words(each.node()));
    EXPECT_THAT(causes, ElementsAre("violations : axis-limit, 2 runs of 2 programs",
                                    "violations : feed, 1 run of 1 program"));
    const std::string all = page_words(front());
    EXPECT_THAT(all, HasSubstr("There is no batch before this one."));
    EXPECT_THAT(page_words(front().select_node("//dl").node()), HasSubstr("Without a fault 1 Failed 3"));
    EXPECT_THAT(words_of_page("b.nc"), HasSubstr("b.nc:7 error : too far  [axis-limit]"));
}

TEST_F(Pages, SayWhyARunIsAnotherOne) {
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
        "the program, the machine, 'old.stl' is there no more, 'sub.nc', 'tools.txt' is there now, gsim "
        "itself";
    EXPECT_THAT(rows_below("times"), ElementsAre(testing::Contains(reason)));
    EXPECT_THAT(words_of_page("a.nc"), HasSubstr("Run anew for: " + reason));
    EXPECT_THAT(words_of_page("a.nc"), HasSubstr("old.stl looked for, and not there"));
}

// If a remark was added above, the same finding is on another line.
TEST_F(Pages, DoNotTakeAnotherLineForAnotherFinding) {
    batch({{.program = "a.nc", .cause = "feed"}});
    batch({{.program = "a.nc", .cause = "feed", .program_sha256 = "3"}});
    write_and_read();
    EXPECT_THAT(rows_below("findings"), ElementsAre());
    batch({{.program = "a.nc", .cause = "feed", .program_sha256 = "3", .text = "further"}});
    write_and_read();
    EXPECT_EQ(rows_below("findings").size(), 1U);
}

TEST_F(Pages, CompareWithTheBatchThatIsAskedFor) {
    batch({{.program = "a.nc", .time_s = 10}});
    batch({{.program = "a.nc", .time_s = 20}});
    batch({{.program = "a.nc", .time_s = 20}});
    write_and_read();
    EXPECT_THAT(rows_below("times"), ElementsAre());
    write_and_read(1);
    EXPECT_THAT(rows_below("times"), ElementsAre(testing::Contains("+10 s (+100 %)")));
    EXPECT_THAT(write(3).error(), HasSubstr("there is no batch 3 before the latest one"));
    EXPECT_THAT(write(-1).error(), HasSubstr("no batch -1"));
}

TEST_F(Pages, HaveTheHistoryOfAProgram) {
    batch({{.program = "a.nc", .time_s = 10}});
    batch({{.program = "a.nc", .time_s = 10}});
    batch({{.program = "b.nc"}});
    batch({{.program = "a.nc", .time_s = 12, .cause = "feed"}});
    write_and_read();
    const std::string words = words_of_page("a.nc");
    EXPECT_THAT(words, HasSubstr("It was last without a fault in batch 2"));
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

TEST_F(Pages, SayThatABatchIsNotWhole) {
    batch({{.program = "a.nc"}, {.program = "b.nc"}});
    batch({{.program = "a.nc"}}, false, "other.toml");
    write_and_read();
    const std::string words = page_words(front());
    EXPECT_THAT(words, HasSubstr("the batch was cut off, or is under way"));
    EXPECT_THAT(words, HasSubstr("Gone, or not run yet"));
    EXPECT_THAT(words, HasSubstr("That batch was of another plan: plan.toml."));
}

TEST_F(Pages, TakeNamesOfAnyKind) {
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

TEST_F(Pages, KeepTheirNames) {
    EXPECT_EQ(page_name("mill/dome.nc"), page_name("mill/dome.nc"));
    EXPECT_THAT(page_name("mill/dome.nc"), testing::MatchesRegex("mill-dome-nc-[0-9a-f]{16}\\.html"));
    EXPECT_NE(page_name("mill/dome.nc"), page_name("mill-dome.nc"));
    EXPECT_THAT(page_name(""), testing::StartsWith("program-"));
}

TEST_F(Pages, AreTheSameBytesAndUntouchedWhereNothingHasChanged) {
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

TEST_F(Pages, OfProgramsThatAreGoneGoAndFilesOfOthersStay) {
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

TEST_F(Pages, AreNotWrittenOverFilesOfOthers) {
    batch({{.program = "a.nc"}});
    fs::create_directory(site_);
    std::ofstream(site_ / "index.html") << "my front page";
    const auto written = write();
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error(), HasSubstr("index.html' is no page that was written here before"));
    EXPECT_EQ(text_in(site_ / "index.html"), "my front page");
    fs::remove(site_ / "index.html");
    fs::create_directory(site_ / "index.html");
    EXPECT_THAT(write().error(), HasSubstr("cannot write"));
}

TEST_F(Pages, NeedAFolderAndABatch) {
    auto results = Results::open(file_);
    auto empty = Database::open(file_, true);
    EXPECT_THAT(write_pages(*empty, {.folder = site_.string()}).error(), HasSubstr("there is no batch"));
    EXPECT_FALSE(fs::exists(site_));
    batch({{.program = "a.nc"}});
    const auto written = write_pages(*empty, {.folder = file_ + "/site"});
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error(), HasSubstr("r.sqlite/site"));
}

// In a file of results that machines share, a writer waits for readers that have not finished.
TEST_F(Pages, LeaveNothingOpenBehindThem) {
    batch({{.program = "a.nc"}});
    ASSERT_TRUE(Results::open(file_, Journal::rollback));
    auto reader = Database::open(file_, true);
    ASSERT_TRUE(write_pages(*reader, {.folder = site_.string()}));
    auto results = Results::open(file_, Journal::rollback);
    ASSERT_TRUE(results->begin_batch("plan.toml", 1, "v"));
    EXPECT_TRUE(results->end_batch(false));
}

TEST_F(Pages, OfManyRunsAreInParts) {
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
    EXPECT_THAT(page_words(front()), HasSubstr("1899 more are left out here.")) << "of 2,099 that are gone";
}

// The failed ones of 60 variants have their details, at any position.
TEST_F(Pages, OfManyVariantsHaveDetailsOfThoseThatFail) {
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
    EXPECT_THAT(words_of_page("a.nc"), HasSubstr("20 more have no more room"));
}

/// Makes pages of finished runs as gsim does, as far as files go, and counts them.
class Views : public Pages {
  protected:
    Views() {
        const std::string maker = (folder_ / "maker").string();
        std::ofstream(maker) << "#!/bin/sh\necho \"<title>gsim studio</title> $*\" > \"$3\"\necho x >> '"
                             << (folder_ / "made").string() << "'\nexit 1\n";
        fs::permissions(maker, fs::perms::owner_all);
        views_ = ViewMaker{.program = maker, .version = "v1"};
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

TEST_F(Views, AreOfWhatFailsOrHasChanged) {
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

TEST_F(Views, AreNotOfOtherRunsThanTheOneThatIsTold) {
    const ReadFile changed = file("changed.nc", "G1");
    file("changed.nc", "G0");
    batch({{.program = "changed.nc", .cause = "feed", .files = {changed}},
           {.program = "old.nc", .cause = "feed", .version = "v0"},
           {.program = "edited.nc", .cause = "feed", .settings = {{"machine.axis.X.max_mm", 5}}},
           {.program = "refused.nc", .cause = "syntax", .status = "refused"}});
    write_and_read();
    EXPECT_EQ(view_count(), 0U);
    EXPECT_THAT(words_of_page("changed.nc"), HasSubstr("changed.nc' is another one by now."));
    EXPECT_THAT(words_of_page("old.nc"), HasSubstr("it was run by another version of gsim."));
    EXPECT_THAT(words_of_page("edited.nc"), HasSubstr("gsim run has no word for machine.axis.X.max_mm."));
    EXPECT_THAT(words_of_page("refused.nc"), HasSubstr("the program was not run."));
}

TEST_F(Views, GoWhenTheyAreNoLongerWantedAndOtherFilesStay) {
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

TEST_F(Views, ThatCannotBeMadeSayWhy) {
    views_->program = (folder_ / "none").string();
    batch({{.program = "a.nc", .cause = "feed"}});
    write_and_read();
    EXPECT_THAT(words_of_page("a.nc"), HasSubstr("There is no page of the finished run: cannot run"));
}

}  // namespace
}  // namespace gsim::batch::pages_test
