// gsim-batch as users run it: twice, with a change in between, interrupted, with faulty programs.

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "base/os/spawn.h"
#include "base/text/json.h"
#include "batch/store/sqlite.h"
#include "tests/apps/run_program.h"
#include "tests/batch/query_number.h"
#include "tests/batch/slide.h"
#include "tests/build_files/build_files.h"
#include "tests/support/soon.h"

namespace gsim::batch::batch_program_test {
namespace {

using apps::Ended;
using nlohmann::json;
using testing::HasSubstr;

#ifdef GSIM_SANITIZED
constexpr const char* kTimeout_s = "20";  // all else takes ten times as long, too
#else
constexpr const char* kTimeout_s = "1";
#endif

class BatchProgram : public apps::Apps {
  protected:
    Ended batch(const std::vector<std::string>& words) const {
        return apps::run_program(tests::program_path("gsim-batch"), words, folder_);
    }

    /// The one number that a query comes to.
    double number(const std::string& query, const std::string& file = "gsim-batch.sqlite") const {
        auto results = Database::open((folder_ / file).string(), true);
        EXPECT_TRUE(results) << results.error().message;
        auto statement = results->prepare(query);
        EXPECT_TRUE(statement) << statement.error().message;
        EXPECT_TRUE(statement->step().value_or(false)) << query;
        return statement->number(0);
    }

    void write_programs(int count) const {
        for (int i = 0; i < count; ++i)
            write(fmt::format("p{}.ngc", i), fmt::format("G21 G90 G94 F600\nG1 X{}\nM2\n", 10 + i));
    }
};

/// Returns the time between standstills over a distance at a feed of 10 mm/s, with 1000 mm/s2.
double time_s(double distance_mm, double feed_mm_s = 10, double acceleration_mm_s2 = 1000) {
    return distance_mm / feed_mm_s + feed_mm_s / acceleration_mm_s2;
}

TEST_F(BatchProgram, ResultsMatchSingleRuns) {
    write("m.toml", kSlide);
    write_programs(12);
    const Ended first = batch({"--machine", "m.toml", ".", "--csv", "runs.csv", "--reports"});
    ASSERT_EQ(first.status, 0) << first.err;
    EXPECT_THAT(first.err, HasSubstr("12 of 12 jobs: 12 run"));
    EXPECT_EQ(number("SELECT count(*) FROM clean"), 12);
    for (const int i : {0, 5, 11}) {
        EXPECT_NEAR(number(fmt::format("SELECT cycle_time_s FROM latest WHERE program LIKE '%p{}.ngc'", i)),
                    time_s(10 + i), 1e-9);
        const Ended standalone = gsim_run({"--machine", "m.toml", "--json", fmt::format("p{}.ngc", i)});
        auto results = Database::open((folder_ / "gsim-batch.sqlite").string(), true);
        auto kept = results->prepare(fmt::format(
            "SELECT json FROM report JOIN run ON run.id = report.run WHERE program LIKE '%p{}.ngc'", i));
        ASSERT_TRUE(kept->step().value_or(false));
        json of_batch = text::parse_json<json>(std::string(kept->text(0))),
             single_report = text::parse_json<json>(standalone.out);
        for (json* report : {&of_batch, &single_report}) report->erase("program");
        EXPECT_EQ(of_batch, single_report);
    }
    EXPECT_THAT(read("runs.csv"), HasSubstr("job,program,machine"));
}

TEST_F(BatchProgram, RunsOnlyChangedJobs) {
    write("m.toml", kSlide);
    write_programs(6);
    write("o100.ngc", "o<o100> sub\nG1 X5\no<o100> endsub\n");
    write("calls.ngc", "G21 G90 G94 F600\no<o100> call\nM2\n");
    const std::vector<std::string> words{"--machine", "m.toml", "p0.ngc",   "p1.ngc",
                                         "p2.ngc",    "p3.ngc", "calls.ngc"};
    ASSERT_EQ(batch(words).status, 0) << batch(words).err;
    EXPECT_THAT(batch(words).err, HasSubstr("5 of 5 jobs: 0 run"));
    write("p1.ngc", "G21 G90 G94 F600\nG1 X500\nM2\n");
    EXPECT_THAT(batch(words).err, HasSubstr("1 run"));
    EXPECT_NEAR(number("SELECT cycle_time_s FROM latest WHERE program LIKE '%p1.ngc'"), time_s(500), 1e-9);
    // A program that another one calls counts as well: it is known from the run before.
    write("o100.ngc", "o<o100> sub\nG1 X25\no<o100> endsub\n");
    EXPECT_THAT(batch(words).err, HasSubstr("1 run"));
    EXPECT_NEAR(number("SELECT cycle_time_s FROM latest WHERE program LIKE '%calls.ngc'"), time_s(25), 1e-9);
    write("m.toml", std::string(kSlide) + "# another text\n");
    EXPECT_THAT(batch(words).err, HasSubstr("5 run"));
    EXPECT_EQ(number("SELECT count(*) FROM batch"), 5);
    EXPECT_EQ(number("SELECT count(*) FROM run"), 12);
}

TEST_F(BatchProgram, SettingsChangeMachineAndOptions) {
    write("m.toml", kSlide);
    write_programs(1);
    write("plan.toml", R"(programs = "p0.ngc"
machines = ["m.toml"]
[[setting]]
key = "machine.axis.X.max_acceleration_mm_s2"
values = [0.5, 1.0, 2.0]
scale = true
[[setting]]
key = "option.feed_override_percent"
values = [50, 100]
)");
    ASSERT_EQ(batch({"plan.toml"}).status, 0) << batch({"plan.toml"}).err;
    for (const double factor : {0.5, 1.0, 2.0}) {
        for (const int percent : {50, 100})
            EXPECT_NEAR(
                number(fmt::format(
                    "SELECT cycle_time_s FROM latest JOIN setting s ON s.run = latest.id AND s.name = "
                    "'machine.axis.X.max_acceleration_mm_s2' AND s.value = {} JOIN setting o ON o.run = "
                    "latest.id "
                    "AND o.name = 'option.feed_override_percent' AND o.value = {}",
                    factor, percent)),
                time_s(10, percent / 10.0, 1000 * factor), 1e-9);
    }
}

// Settings reach the built-in machine; the cell names another machine, which is another setting.
TEST_F(BatchProgram, SettingsReachMachineOfCell) {
    write("m.toml", kSlide);
    std::string fast = kSlide;
    fast.replace(fast.find("s2 = 1000.0"), 11, "s2 = 2000.0");
    write("fast.toml", fast);
    write("cell.toml", "[cell]\nname = \"c\"\nmachine = \"m.toml\"\n");
    write_programs(1);
    write("plan.toml", R"(programs = "p0.ngc"
[options]
cell = "cell.toml"
[[setting]]
key = "cell.cell.machine"
values = ["m.toml", "fast.toml"]
[[setting]]
key = "machine.axis.X.max_acceleration_mm_s2"
values = [1.0, 0.5]
scale = true
)");
    ASSERT_EQ(batch({"plan.toml"}).status, 0) << batch({}).out;
    for (const auto& [job, acceleration] : {std::pair{0, 1000}, {1, 500}, {2, 2000}, {3, 1000}})
        EXPECT_NEAR(number(fmt::format("SELECT cycle_time_s FROM latest WHERE job = {}", job)),
                    time_s(10, 10, acceleration), 1e-9);
    write("built-in.toml",
          "programs = \"p0.ngc\"\ncontrollers = [\"exact-stop\", \"ab9\"]\n[options]\ndialect = "
          "\"rs274ngc\"\n");
    ASSERT_EQ(batch({"built-in.toml"}).status, 0) << batch({}).out;
    EXPECT_EQ(number("SELECT count(DISTINCT controller) FROM latest"), 2);
}

// Two variants that are one, and programs that are named twice.
TEST_F(BatchProgram, RunsSameJobOnceInBatch) {
    write("m.toml", kSlide);
    write_programs(1);
    write("plan.toml", R"(programs = ["p0.ngc", "*.ngc"]
machines = ["m.toml", "m.toml"]
[[setting]]
key = "option.feed_override_percent"
values = [50, 50, 100]
)");
    ASSERT_EQ(batch({"plan.toml"}).status, 0) << batch({}).out;
    EXPECT_EQ(number("SELECT count(*) FROM latest"), 6);
    EXPECT_EQ(number("SELECT count(*) FROM run"), 2);
}

// A module has no controller of ours, and runs in a separate process.
TEST_F(BatchProgram, SupportsControllerModule) {
    write_programs(1);
    write("plan.toml",
          "programs = \"p0.ngc\"\n[options]\ndialect = \"rs274ngc\"\nmodule = \"gsim_rcs_default\"\n");
    EXPECT_EQ(batch({"plan.toml"}).status, 0) << batch({}).out;
}

TEST_F(BatchProgram, ReportsErrorOfEachProgramInOneRow) {
    write("m.toml", kSlide);
    write("good.ngc", "G21 F600\nG1 X10\nM2\n");
    write("far.ngc", "G21 F600\nG1 X5000\nM2\n");
    write("wrong.ngc", "G21 F600\nG1 X[\nM2\n");
    write("endless.ngc", "G21 F600\no1 while [1]\nG1 X10\nG1 X0\no1 endwhile\nM2\n");
    write("empty.ngc", "");
    write("broken.toml", "[machine\n");
    const Ended ended = batch({"--machine", "m.toml", "--machine", "broken.toml", ".", "--timeout",
                               kTimeout_s, "-j", "2", "--junit", "t.xml"});
    EXPECT_EQ(ended.status, 1) << ended.err;
    const auto status = [&](const std::string& program) {
        auto results = Database::open((folder_ / "gsim-batch.sqlite").string(), true);
        auto statement = results->prepare(
            "SELECT status || ' ' || cause FROM latest WHERE machine = 'm.toml' AND program LIKE '%" +
            program + "'");
        EXPECT_TRUE(statement->step().value_or(false)) << program;
        return std::string(statement->text(0));
    };
    EXPECT_EQ(status("good.ngc"), "completed ");
    EXPECT_EQ(status("far.ngc"), "violations axis-limit");
    EXPECT_THAT(status("wrong.ngc"), HasSubstr("refused"));
    EXPECT_EQ(status("endless.ngc"), "timeout timeout");
    EXPECT_EQ(number("SELECT count(*) FROM latest WHERE machine = 'broken.toml' AND status = 'refused'"), 5);
    EXPECT_THAT(read("t.xml"), HasSubstr("<testsuite name=\"broken.toml\" tests=\"5\" failures=\"5\">"));
}

// Two nights, with an edit in between that breaks a program and one that mends another.
TEST_F(BatchProgram, WritesPagesOfNightlyCheck) {
    write("m.toml", kSlide);
    write("a<1>.ngc", "G21 F600\nG1 X10\nM2\n");
    write("b.ngc", "G21 F600\nG1 X5000\nM2\n");
    const std::vector<std::string> nightly{"--machine", "m.toml", ".", "--pages", "site", "-q"};
    EXPECT_EQ(batch(nightly).status, 1);
    EXPECT_THAT(read("site/index.html"), HasSubstr("There is no earlier batch."));
    write("a<1>.ngc", "G21 F600\nG1 X5000\nM2\n");
    write("b.ngc", "G21 F600\nG1 X20\nM2\n");
    EXPECT_EQ(batch(nightly).status, 1);
    const std::string front = read("site/index.html");
    const std::size_t failing = front.find("<h3 id=\"newly-failing\">"),
                      fixed = front.find("<h3 id=\"fixed\">");
    ASSERT_NE(fixed, std::string::npos);
    EXPECT_THAT(front.substr(failing, fixed - failing), HasSubstr("a&lt;1&gt;.ngc"));
    EXPECT_THAT(front.substr(failing, fixed - failing), HasSubstr("axis-limit"));
    EXPECT_THAT(front.substr(fixed), HasSubstr("b.ngc"));

    EXPECT_EQ(batch({"--pages", "site"}).status, 0) << "of the results alone";
    EXPECT_EQ(read("site/index.html"), front);
    EXPECT_THAT(batch({"--pages", "site", "--since", "7"}).err, HasSubstr("no batch 7"));
    const Ended unwritable = batch({"--pages", "m.toml/site"});
    EXPECT_EQ(unwritable.status, 2);
    EXPECT_THAT(unwritable.err, HasSubstr("m.toml/site"));
}

TEST_F(BatchProgram, PagesHaveViewOfFailedRun) {
    if (!std::filesystem::exists(std::filesystem::path(tests::program_path("gsim-batch")).parent_path() /
                                 "../share/gsim/studio/view.html"))
        GTEST_SKIP() << "this build has no page of the studio";
    write("m.toml", kSlide);
    write("it's far.ngc", "G21 F600\nG1 X5000\nM2\n");
    EXPECT_EQ(batch({"--machine", "m.toml", ".", "--pages", "site", "--views", "-q"}).status, 1);
    const std::string view = std::filesystem::directory_iterator(folder_ / "site/views")->path().filename();
    EXPECT_THAT(read("site/views/" + view), HasSubstr("<title>gsim studio</title>"));
    std::string links;
    for (const auto& page : std::filesystem::directory_iterator(folder_ / "site")) {
        if (page.is_regular_file()) links += read("site/" + page.path().filename().string());
    }
    EXPECT_THAT(links, HasSubstr("<a href=\"views/" + view + "\">"));
}

// The batch is killed in its middle, as by a power cut: existing results stay, and the same command
// continues.
TEST_F(BatchProgram, ResumesAfterInterruption) {
    write("m.toml", kSlide);
    write_programs(3);
    write("plan.toml", R"(programs = ["p0.ngc", "p1.ngc", "p2.ngc"]
machines = ["m.toml"]
[[setting]]
key = "machine.axis.X.max_speed_mm_s"
from = 50
to = 100
steps = 1000
)");
    // Rows of runs, 0 before there is a table of them.
    const auto rows = [&] {
        return one_number(folder_ / "gsim-batch.sqlite", "SELECT count(*) FROM run").value_or(0);
    };
    const auto spawn = [&](int signal) {
        const double before = rows();
        os::SpawnActions actions;
        actions.redirect(2, 1);
        const std::string command = fmt::format("cd '{}' && exec {} plan.toml -q", folder_.string(),
                                                tests::program_path("gsim-batch"));
        const auto child = os::spawn({"/bin/sh", "-c", command}, actions);
        ASSERT_TRUE(child);
        EXPECT_TRUE(tests::soon([&] { return rows() > before; }));
        ::kill(*child, signal);
        os::wait_for(*child);
    };
    spawn(SIGKILL);
    spawn(SIGTERM);
    EXPECT_LT(rows(), 3000) << "it was over before it was asked to end";
    const Ended rest = batch({"plan.toml"});
    EXPECT_EQ(rest.status, 0) << rest.err;
    EXPECT_EQ(number("SELECT count(*) FROM run"), 3000) << "none lost, none twice";
    EXPECT_EQ(number("SELECT count(DISTINCT key) FROM run"), 3000);
    EXPECT_EQ(number("SELECT count(*) FROM latest"), 3000);
    EXPECT_THAT(batch({"plan.toml"}).err, HasSubstr("0 run"));
}

TEST_F(BatchProgram, KeepsAndShowsPictures) {
    write("m.toml", kSlide);
    write_programs(2);
    if (std::system("gnuplot --version > /dev/null 2>&1") != 0) {
        EXPECT_THAT(batch({"--machine", "m.toml", "p0.ngc", "--pictures"}).err, HasSubstr("gnuplot"));
        GTEST_SKIP() << "there is no gnuplot here";
    }
    ASSERT_EQ(batch({"--machine", "m.toml", "p0.ngc", "p1.ngc"}).status, 0);
    const Ended drawn = batch({"--machine", "m.toml", "p0.ngc", "--pictures", "--pages", "site"});
    ASSERT_EQ(drawn.status, 0) << drawn.err;
    EXPECT_THAT(drawn.err, HasSubstr("1 run")) << "there had been no picture of it";
    EXPECT_EQ(number("SELECT count(*) FROM picture WHERE svg LIKE '%<svg%</svg>%'"), 1);
    EXPECT_THAT(batch({"--machine", "m.toml", "p0.ngc", "--pictures"}).err, HasSubstr("0 run"));
    std::string pages;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "site"))
        pages += read("site/" + entry.path().filename().string());
    EXPECT_THAT(pages, HasSubstr("src=\"data:image/svg+xml;base64,"));
}

TEST_F(BatchProgram, RejectsInvalidInputs) {
    write("plan.toml", "programs = 1\n");
    EXPECT_EQ(batch({"plan.toml"}).status, 2);
    EXPECT_EQ(batch({"none.ngc"}).status, 2);
    EXPECT_EQ(batch({}).status, 2) << "there are no results yet";
    EXPECT_EQ(batch({"--no-such"}).status, 2);
    write("p.ngc", "M2\n");
    EXPECT_THAT(batch({"plan.toml", "--machine", "m.toml"}).err,
                HasSubstr("a plan defines the machines and options"));
    EXPECT_THAT(batch({"p.ngc", "--results", "p.ngc"}).err, HasSubstr("p.ngc"));
    EXPECT_EQ(read("p.ngc"), "M2\n");
    EXPECT_THAT(batch({"p.ngc", "--results", "r.sqlite", "--csv", "r.sqlite"}).err, HasSubstr("r.sqlite"));
    EXPECT_THAT(batch({"p.ngc", "--results", "none/r.sqlite"}).err, HasSubstr("none"));
    EXPECT_THAT(batch({"p.ngc", "--views"}).err, HasSubstr("--views requires --pages"));
    EXPECT_THAT(batch({"--slurm"}).err, HasSubstr("name a plan"));
}

#ifndef GSIM_SANITIZED  // which reserves all available addresses
TEST_F(BatchProgram, LimitsMemory) {
    write("good.ngc", "G21 F600\nG1 X10\nM2\n");
    write("m.toml", kSlide);
    // Numbers of a list that grows, in a script.
    write("large.lua", "local t = {}\nfor i = 1, 1000 do t[i] = string.rep(tostring(i), 1000000) end\n");
    const Ended ended =
        batch({"--machine", "m.toml", "good.ngc", "large.lua", "--memory-mb", "256", "-j", "1"});
    EXPECT_EQ(ended.status, 1) << ended.err;
    EXPECT_EQ(number("SELECT count(*) FROM latest WHERE status = 'completed'"), 1);
    EXPECT_EQ(number("SELECT count(*) FROM latest WHERE program = 'large.lua' AND (status = 'memory' OR "
                     "cause LIKE '%memory%' OR message LIKE '%memory%')"),
              1);
}
#endif

}  // namespace
}  // namespace gsim::batch::batch_program_test
