#include "batch/store/results.h"

#include <filesystem>
#include <fstream>
#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include "base/text/json.h"
#include "batch/store/outputs.h"
#include "batch/store/schema.h"

namespace gsim::batch::results_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ResultsFile : public testing::Test {
  protected:
    ResultsFile() { fs::create_directories(folder_); }
    ~ResultsFile() override { fs::remove_all(folder_); }

    std::string hash(const std::string& name) const {
        const auto found = hashes_.find(name);
        return found == hashes_.end() ? "" : found->second;
    }
    FileHash file_hash() const {
        return [this](const std::string& name) { return hash(name); };
    }

    fs::path folder_ = fs::temp_directory_path() / ("gsim-results-" + std::to_string(::getpid()));
    std::string file_ = (folder_ / "r.sqlite").string();
    std::map<std::string, std::string> hashes_{{"a.nc", "1"}, {"sub.nc", "2"}};
};

Job job_of(std::size_t number, const std::string& program) {
    return {.number = number,
            .program = program,
            .machine = "m.toml",
            .options = nlohmann::json::object(),
            .settings = {{"machine.axis.X.max_mm", 250.5}, {"option.dialect", "ab9"}}};
}

RunRow run_row(std::size_t number, const std::string& cause = {}) {
    return {
        .number = number,
        .outcome = {.status = cause.empty() ? "completed" : "alarm",
                    .cause = cause,
                    .message = cause.empty() ? "" : "it says \"no\", <twice>",
                    .file = "a.nc",
                    .line = 3},
        .times = {.cycle_s = 0.1 + 0.2},
        .extents = "{}",
        .findings =
            R"([{"code":"axis-limit","column":null,"end_column":null,"file":"a.nc","hint":null,"line":3,"severity":"error","text":"too far"}])",
        .files = {{"a.nc", "1"}, {"sub.nc", "2"}, {"gone.nc", ""}}};
}

std::string written_text(const std::string& file, Result<void> (*write)(Database&, const Sink&)) {
    auto database = Database::open(file, true);
    EXPECT_TRUE(database) << database.error().message;
    std::string text;
    const auto done = write(*database, [&](std::string_view chunk) { return text.append(chunk), true; });
    EXPECT_TRUE(done) << done.error().message;
    return text;
}

TEST_F(ResultsFile, FindsRunIfItsInputsAreUnchanged) {
    auto results = Results::open(file_);
    ASSERT_TRUE(results) << results.error().message;
    ASSERT_TRUE(results->begin_batch("plan.toml", 1, "v"));
    EXPECT_FALSE(results->find("k", file_hash(), {}, false).value());
    const auto run = results->add(job_of(0, "a.nc"), {"k", "1", ""}, run_row(0), "v");
    ASSERT_TRUE(run) << run.error().message;
    ASSERT_TRUE(results->record(0, *run, false));
    ASSERT_TRUE(results->end_batch(true));

    ASSERT_TRUE(results->find("k", file_hash(), {}, false).value());
    EXPECT_EQ(results->find("k", file_hash(), {}, false).value()->run, *run);
    EXPECT_FALSE(results->find("k", file_hash(), {.report = true}, false).value()) << "it has no report";
    EXPECT_FALSE(results->find("other", file_hash(), {}, false).value());
    hashes_["sub.nc"] = "3";
    EXPECT_FALSE(results->find("k", file_hash(), {}, false).value());
    hashes_["sub.nc"] = "2";
    EXPECT_TRUE(results->find("k", file_hash(), {}, false).value());
    hashes_["gone.nc"] = "9";
    EXPECT_FALSE(results->find("k", file_hash(), {}, false).value())
        << "it was looked for, and now it is there";
}

TEST_F(ResultsFile, RepeatsCrashedRunOnRequest) {
    auto results = Results::open(file_);
    ASSERT_TRUE(results);
    ASSERT_TRUE(results->begin_batch("plan.toml", 1, "v"));
    RunRow row = run_row(0);
    row.outcome.status = row.outcome.cause = "crashed";
    ASSERT_TRUE(results->add(job_of(0, "a.nc"), {"k", "1", ""}, row, "v"));
    const auto found = results->find("k", file_hash(), {}, false).value();
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->is_clean);
    EXPECT_FALSE(results->find("k", file_hash(), {}, true).value());
    ASSERT_TRUE(results->end_batch(true));
}

// A crash does not report what was read, so a run that came to its end is better.
TEST_F(ResultsFile, PrefersCompletedRunToLaterTimeout) {
    auto results = Results::open(file_);
    ASSERT_TRUE(results->begin_batch("plan.toml", 1, "v"));
    const auto good = results->add(job_of(0, "a.nc"), {"k", "1", ""}, run_row(0), "v");
    RunRow lost = run_row(0);
    lost.outcome.status = lost.outcome.cause = "timeout";
    lost.files = {};
    ASSERT_TRUE(results->add(job_of(0, "a.nc"), {"k", "1", ""}, lost, "v"));
    EXPECT_EQ(results->find("k", file_hash(), {}, false).value()->run, *good);
    hashes_["sub.nc"] = "3";
    EXPECT_FALSE(results->find("k", file_hash(), {}, false).value()->is_clean);
    ASSERT_TRUE(results->end_batch(true));
}

// The results were removed while a cluster was at work: what it has is of no batch there.
TEST_F(ResultsFile, DoesNotResumeOtherBatch) {
    std::string token;
    {
        auto results = Results::open(file_);
        ASSERT_TRUE(results->begin_batch("plan.toml", 1, "v"));
        token = results->token();
        ASSERT_TRUE(results->end_batch(false));
        ASSERT_TRUE(results->resume_batch(1, token));
        ASSERT_TRUE(results->end_batch(false));
    }
    fs::remove(file_);
    auto results = Results::open(file_);
    EXPECT_FALSE(results->resume_batch(1, token));
    ASSERT_TRUE(results->begin_batch("plan.toml", 1, "v"));
    ASSERT_TRUE(results->end_batch(false));
    EXPECT_FALSE(results->resume_batch(1, token)) << "the same number, another batch";
}

TEST_F(ResultsFile, CanBeReadDuringWriting) {
    auto results = Results::open(file_);
    ASSERT_TRUE(results);
    ASSERT_TRUE(results->begin_batch("plan.toml", 2, "v"));
    const auto run = results->add(job_of(0, "a.nc"), {"k", "1", ""}, run_row(0), "v");
    ASSERT_TRUE(results->record(0, run.value(), false));
    ASSERT_TRUE(results->commit());
    ASSERT_TRUE(results->add(job_of(1, "b.nc"), {"l", "1", ""}, run_row(1), "v"));
    auto reader = Database::open(file_, true);
    ASSERT_TRUE(reader);
    auto rows = reader->prepare(
        "SELECT count(*), max(cycle_time_s), max(batch_run.job) FROM run JOIN batch_run ON run.id = run");
    ASSERT_TRUE(rows) << rows.error().message;
    ASSERT_TRUE(rows->step().value());
    EXPECT_EQ(rows->integer(0), 1);
    EXPECT_EQ(rows->number(1), 0.1 + 0.2) << "to the last bit";
}

TEST_F(ResultsFile, ExportsJunitSarifCsvAndJsonLines) {
    {
        auto results = Results::open(file_);
        ASSERT_TRUE(results);
        ASSERT_TRUE(results->begin_batch("plan.toml", 2, "v"));
        for (std::size_t i = 0; i < 2; ++i) {
            const auto run = results->add(job_of(i, "a<b>&.nc"), {std::to_string(i), "1", ""},
                                          run_row(i, i == 0 ? "" : "feed"), "v");
            ASSERT_TRUE(results->record(i, run.value(), false));
        }
        ASSERT_TRUE(results->end_batch(true));
    }
    const std::string junit = written_text(file_, write_junit);
    EXPECT_THAT(junit, HasSubstr("<testsuite name=\"m.toml\" tests=\"2\" failures=\"1\">"));
    EXPECT_THAT(junit, HasSubstr("name=\"a&lt;b&gt;&amp;.nc {&quot;machine.axis.X.max_mm&quot;:250.5"));
    EXPECT_THAT(
        junit,
        HasSubstr(
            "<failure type=\"feed\" message=\"it says &quot;no&quot;, &lt;twice&gt;\">a.nc:3</failure>"));
    const auto sarif = text::parse_json<nlohmann::json>(written_text(file_, write_sarif));
    EXPECT_EQ(sarif["runs"][0]["results"].size(), 1U) << "the same finding of two runs is one";
    const std::string csv = written_text(file_, [](Database& from, const Sink& sink) {
        return write_csv(from, "SELECT message, cycle_time_s FROM latest", sink);
    });
    EXPECT_EQ(csv,
              "message,cycle_time_s\r\n,0.30000000000000004\r\n\"it says \"\"no\"\", "
              "<twice>\",0.30000000000000004\r\n");
    const std::string lines = written_text(file_, [](Database& from, const Sink& sink) {
        return write_json_lines(from, kAllColumnsQuery, sink);
    });
    const auto first = text::parse_json<nlohmann::json>(lines.substr(0, lines.find('\n')));
    EXPECT_EQ(first["settings"]["machine.axis.X.max_mm"], 250.5);
    EXPECT_EQ(first["cycle_time_s"], 0.1 + 0.2);
}

TEST_F(ResultsFile, MergesOtherFilesOnce) {
    const auto file_with = [&](const std::string& name, std::size_t first, std::size_t end) {
        const std::string file = (folder_ / name).string();
        auto results = Results::open(file, Journal::rollback);
        EXPECT_TRUE(results) << results.error().message;
        EXPECT_TRUE(results->begin_batch("plan", end - first, "v"));
        for (std::size_t i = first; i < end; ++i) {
            RunRow row = run_row(i);
            row.documents.report = "{}";
            const auto run =
                results->add(job_of(i, "p" + std::to_string(i)), {std::to_string(i), "1", ""}, row, "v");
            EXPECT_TRUE(results->record(i, run.value(), false));
        }
        EXPECT_TRUE(results->end_batch(true));
        return file;
    };
    const std::vector<std::string> shards{file_with("a", 0, 3), file_with("b", 3, 5)};
    // A requeued task has begun a batch, and ended before it had recorded a run.
    {
        auto repeated = Results::open(shards[0], Journal::rollback);
        ASSERT_TRUE(repeated->begin_batch("plan", 3, "v"));
        ASSERT_TRUE(repeated->end_batch(false));
    }
    auto results = Results::open(file_, Journal::rollback);
    ASSERT_TRUE(results->begin_batch("plan", 5, "v"));
    for (int turn = 0; turn < 2; ++turn) {
        std::uint64_t taken = 0;
        for (const std::string& shard : shards) taken += results->merge(shard).value_or(99);
        EXPECT_EQ(taken, turn == 0 ? 5U : 0U);
    }
    // One file is of a task killed before it had tables, the other is no database.
    ASSERT_TRUE(Database::open((folder_ / "empty").string())->execute("PRAGMA user_version = 0"));
    EXPECT_EQ(results->merge((folder_ / "empty").string()).value_or(99), 0U);
    std::ofstream(folder_ / "damaged") << std::string(5000, 'x');
    EXPECT_FALSE(results->merge((folder_ / "damaged").string()));
    EXPECT_EQ(results->recorded().value_or(99), 5U) << "it goes on behind a file that cannot be read";
    ASSERT_TRUE(results->end_batch(true));
    auto database = Database::open(file_, true);
    for (const auto& [query, count] : {std::pair{"SELECT count(*) FROM setting", 10},
                                       {"SELECT count(*) FROM report", 5},
                                       {"SELECT count(*) FROM run_input", 15},
                                       {"SELECT count(*) FROM input", 3},
                                       {"SELECT count(DISTINCT program) FROM latest", 5}}) {
        auto statement = database->prepare(query);
        ASSERT_TRUE(statement->step().value_or(false));
        EXPECT_EQ(statement->integer(0), count) << query;
    }
}

// The file is a copy in a read-only folder, with a name that needs escapes in a URI.
TEST_F(ResultsFile, CanBeReadInReadOnlyFolder) {
    const fs::path odd = folder_ / "odd 50% #1?";
    fs::create_directories(odd);
    const std::string file = (odd / "r's.sqlite").string();
    {
        auto results = Results::open(file);
        ASSERT_TRUE(results);
        ASSERT_TRUE(results->begin_batch("plan", 1, "v"));
        ASSERT_TRUE(results->record(
            0, results->add(job_of(0, "a.nc"), {"k", "1", ""}, run_row(0), "v").value(), false));
        ASSERT_TRUE(results->end_batch(true));
    }
    fs::permissions(file, fs::perms::owner_read);
    fs::permissions(odd, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_THAT(written_text(file, write_junit), HasSubstr("tests=\"1\""));
    fs::permissions(odd, fs::perms::owner_all);
}

// A run without the requested output is repeated.
TEST_F(ResultsFile, StoresPicturesOnRequest) {
    auto results = Results::open(file_);
    ASSERT_TRUE(results->begin_batch("plan", 1, "v"));
    RunRow row = run_row(0);
    const auto bare = results->add(job_of(0, "a.nc"), {"k", "1", ""}, row, "v");
    EXPECT_FALSE(results->find("k", file_hash(), {.picture = true}, false).value());
    row.documents.picture = "<svg/>";
    const auto drawn = results->add(job_of(0, "a.nc"), {"k", "1", ""}, row, "v");
    EXPECT_EQ(results->find("k", file_hash(), {.picture = true}, false).value()->run, *drawn);
    EXPECT_EQ(results->find("k", file_hash(), {}, false).value()->run, *drawn) << "the newest";
    EXPECT_FALSE(results->find("k", file_hash(), {.report = true, .picture = true}, false).value());
    ASSERT_TRUE(results->record(0, *bare, false));
    ASSERT_TRUE(results->record(1, *drawn, false));
    ASSERT_TRUE(results->end_batch(true));
    // Those of shards come along.
    const std::string all = (folder_ / "all.sqlite").string();
    auto gathered = Results::open(all);
    ASSERT_TRUE(gathered->begin_batch("plan", 2, "v"));
    ASSERT_TRUE(gathered->merge(file_));
    ASSERT_TRUE(gathered->end_batch(true));
    auto statement = Database::open(all, true);
    auto rows = statement->prepare("SELECT group_concat(svg), count(*) FROM picture");
    ASSERT_TRUE(rows->step().value());
    EXPECT_EQ(rows->text(0), "<svg/>");
    EXPECT_EQ(rows->integer(1), 1);
}

// As the version before had made it: what is in it stays, and is found again.
TEST_F(ResultsFile, UpgradesVersionOne) {
    {
        auto old = Database::open(file_);
        ASSERT_TRUE(old->execute(std::string("BEGIN; ") + kSchema +
                                 "PRAGMA application_id = 1735616877; PRAGMA user_version = 1; COMMIT;"));
        ASSERT_TRUE(old->execute(
            "INSERT INTO run VALUES (1, 'k', 'a.nc', '1', 'm', '', 'm', 'c', '{}', '{}', 'v', '', "
            "'completed', '', "
            "'', '', 0, 12.5, NULL, NULL, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, NULL, '{}', '[]', 0);"
            "INSERT INTO batch VALUES (1, 't', 'p', 'v', '', '', 1, 1); INSERT INTO batch_run VALUES (1, 0, "
            "1, 0)"));
    }
    upgrade_schema(file_);
    EXPECT_THAT(
        written_text(file_, [](Database& from,
                               const Sink& sink) { return write_csv(from, kTableColumnsQuery, sink); }),
        testing::AllOf(HasSubstr("clearance_mm"), HasSubstr("process_on_mm")));
    auto results = Results::open(file_);
    ASSERT_TRUE(results) << results.error().message;
    EXPECT_EQ(results->find("k", file_hash(), {}, false).value()->run, 1);
    ASSERT_TRUE(results->begin_batch("plan", 1, "v"));
    RunRow row = run_row(0);
    row.clearance_mm = 1.25;
    ASSERT_TRUE(
        results->record(0, results->add(job_of(0, "a.nc"), {"k2", "1", ""}, row, "v").value(), false));
    ASSERT_TRUE(results->end_batch(true));
    auto statement = Database::open(file_, true);
    auto rows = statement->prepare("SELECT clearance_mm, lower_bound_s FROM run ORDER BY id");
    ASSERT_TRUE(rows->step().value());
    EXPECT_TRUE(rows->is_null(0)) << "nobody had looked";
    ASSERT_TRUE(rows->step().value());
    EXPECT_EQ(rows->number(0), 1.25);
    EXPECT_TRUE(rows->is_null(1));
    fs::remove(file_);
    upgrade_schema(file_);
    EXPECT_FALSE(fs::exists(file_)) << "nothing is made";
}

// The columns of version 2 had other names.
TEST_F(ResultsFile, RenamesColumnsOfVersionTwo) {
    {
        auto old = Database::open(file_);
        std::string version_2 = kVersion2Tables;
        for (const char* metric : kVersion2Columns)
            version_2 += fmt::format("ALTER TABLE run ADD COLUMN {} REAL;\n", metric);
        ASSERT_TRUE(old->execute(std::string("BEGIN; ") + kSchema + version_2 +
                                 "PRAGMA application_id = 1735616877; PRAGMA user_version = 2; COMMIT;"));
        ASSERT_TRUE(old->execute(
            "INSERT INTO run VALUES (1, 'k', 'a.nc', '1', 'm', '', 'm', 'c', '{}', '{}', 'v', '', "
            "'completed', '', '', '', 0, 12.5, 12.25, 12.75, 0, 0, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, NULL, "
            "'{}', '[]', 0, NULL, NULL, NULL, NULL);"
            "INSERT INTO batch VALUES (1, 't', 'p', 'v', '', '', 1, 1); INSERT INTO batch_run VALUES (1, 0, "
            "1, 0)"));
    }
    upgrade_schema(file_);
    auto database = Database::open(file_, true);
    auto rows = database->prepare(
        "SELECT cycle_time_min_s, cycle_time_max_s, process_on_mm, complete FROM latest JOIN batch");
    ASSERT_TRUE(rows) << rows.error().message;
    ASSERT_TRUE(rows->step().value());
    EXPECT_EQ(rows->number(0), 12.25);
    EXPECT_EQ(rows->number(1), 12.75);
    EXPECT_EQ(rows->number(2), 7);
    EXPECT_EQ(rows->integer(3), 1);
}

TEST_F(ResultsFile, RejectsOtherFileTypes) {
    std::ofstream(file_) << "no database, but long enough to be looked at as if it were one, with many words";
    const auto text = Results::open(file_);
    ASSERT_FALSE(text);
    EXPECT_THAT(text.error().message, HasSubstr("not a database"));
    fs::remove(file_);
    ASSERT_TRUE(Database::open(file_)->execute("CREATE TABLE mine (a)"));
    EXPECT_THAT(Results::open(file_).error().message, HasSubstr("is not a results file"));
}

}  // namespace
}  // namespace gsim::batch::results_test
