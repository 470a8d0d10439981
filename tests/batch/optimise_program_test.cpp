// gsim-optimise as people run it: against what is known in closed form or by trying all, cut off, and the
// wheel on its gantry.

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

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

namespace gsim::batch::optimise_program_test {
namespace {

using apps::Ended;
using nlohmann::json;
using testing::HasSubstr;

const std::string kSamples = tests::source_path("samples");

class OptimiseProgram : public apps::Apps {
  protected:
    Ended optimise(const std::vector<std::string>& words) const {
        return apps::run_program(tests::program_path("gsim-optimise"), words, folder_);
    }
    Ended batch(const std::vector<std::string>& words) const {
        return apps::run_program(tests::program_path("gsim-batch"), words, folder_);
    }
    json found(const std::string& file = "found.json") const { return text::parse_json<json>(read(file)); }

    double number(const std::string& query, const std::string& file = "gsim-optimise.sqlite") const {
        auto results = Database::open((folder_ / file).string(), true);
        EXPECT_TRUE(results) << results.error().message;
        auto statement = results->prepare(query);
        EXPECT_TRUE(statement) << statement.error().message;
        EXPECT_TRUE(statement->step().value_or(false)) << query;
        return statement->number(0);
    }

    void write_slide() const {
        write("m.toml", kSlide);
        write("p.ngc", "G21 G90 G94 F600\nG1 X20\nM2\n");
    }
};

/// Returns the time between standstills over 20 mm at a share of 10 mm/s.
double slide_s(double percent) {
    const double feed_mm_s = percent / 10;
    return 20 / feed_mm_s + feed_mm_s / 1000;
}

TEST_F(OptimiseProgram, FindsOptimumAtRangeEndAndLimit) {
    write_slide();
    write("plan.toml", kOverride);
    const Ended ended = optimise({"plan.toml", "--json", "found.json", "--page", "found.html"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_NEAR(found()["start"]["value"], slide_s(100), 1e-9);
    EXPECT_NEAR(found()["best"]["value"], slide_s(150), 1e-3);
    EXPECT_NEAR(found()["verification"]["best"]["value"], found()["best"]["value"], 1e-12);
    EXPECT_LE(found()["verification"]["best"]["lower_bound_s"].get<double>(),
              found()["best"]["value"].get<double>());
    EXPECT_THAT(ended.out, HasSubstr("option.feed_override_percent"));
    EXPECT_THAT(read("found.html"), HasSubstr("<polyline"));
    EXPECT_EQ(number("SELECT count(DISTINCT number) FROM evaluations"), 61);
    EXPECT_EQ(number("SELECT count(*) FROM report"), 2) << "of the start and the best one";
    // No faster than at 120 %.
    write("limit.toml", std::string(kOverride) +
                            fmt::format("[[limit]]\nmetric = \"cycle_time_s\"\nmin = {}\n", slide_s(120)));
    ASSERT_EQ(optimise({"limit.toml", "--json", "found.json"}).status, 0);
    EXPECT_NEAR(found()["best"]["value"], slide_s(120), 2e-3);
    EXPECT_GE(found()["best"]["value"].get<double>(), slide_s(120));
}

// More of a figure may be better: the greatest time is at the slow end.
TEST_F(OptimiseProgram, NegativeWeightMaximizes) {
    write_slide();
    std::string plan = kOverride;
    write("plan.toml", plan.replace(plan.find("_s = 1"), 6, "_s = -1"));
    ASSERT_EQ(optimise({"plan.toml", "--json", "found.json"}).status, 0);
    EXPECT_NEAR(found()["best"]["value"], -slide_s(50), 0.05);
}

TEST_F(OptimiseProgram, ResumesAfterInterruption) {
    write_slide();
    write("plan.toml", kOverride);
    const std::vector<std::string> words{"plan.toml", "--variants", "600", "-q"};
    ASSERT_EQ(optimise({"plan.toml", "--variants", "600", "-q", "--results", "whole.sqlite"}).status, 0);
    os::SpawnActions actions;
    actions.redirect(2, 1);
    const auto child = os::spawn({"/bin/sh", "-c",
                                  fmt::format("cd '{}' && exec {} plan.toml --variants 600 -q > cut.txt",
                                              folder_.string(), tests::program_path("gsim-optimise"))},
                                 actions);
    ASSERT_TRUE(child);
    // Trials, 0 before there is a table of them.
    const auto trials = [&] {
        return one_number(folder_ / "gsim-optimise.sqlite", "SELECT count(*) FROM evaluations").value_or(0);
    };
    EXPECT_TRUE(tests::soon([&] { return trials() > 0; }));
    ::kill(*child, SIGTERM);
    os::wait_for(*child);
    EXPECT_LT(trials(), 601) << "it was over before it was asked to end";
    ASSERT_EQ(optimise(words).status, 0);
    const char* all = "SELECT group_concat(value) FROM (SELECT value FROM evaluations ORDER BY number)";
    const auto text = [&](const std::string& file) {
        auto results = Database::open((folder_ / file).string(), true);
        auto statement = results->prepare(all);
        EXPECT_TRUE(statement->step().value_or(false));
        return std::string(statement->text(0));
    };
    EXPECT_EQ(text("gsim-optimise.sqlite"), text("whole.sqlite")) << "the same trials with the same figures";
    EXPECT_EQ(number("SELECT count(*) FROM run"), number("SELECT count(*) FROM run", "whole.sqlite"))
        << "nothing was run twice";
}

/// Returns slots on a line, in no good order, each with a feed and a rapid of its own.
std::string slots() {
    json root = json::array(), paths = json::array();
    for (const int x : {300, 100, 400, 200, 50}) {
        const std::string name = fmt::format("slot{}", x);
        root.push_back({{"path", name}});
        paths.push_back({{"name", name},
                         {"targets",
                          {{{"motion", "rapid"}, {"position_mm", {x, 100, -5}}},
                           {{"position_mm", {x, 120, -5}}, {"feed_mm_min", 1200}},
                           {{"motion", "rapid"}, {"position_mm", {x, 120, -1}}}}}});
    }
    paths.push_back({{"name", "all"}, {"targets", root}});
    return json{{"name", "slots"}, {"root", "all"}, {"paths", paths}}.dump();
}

TEST_F(OptimiseProgram, FindsBestOrderOfExhaustiveSearch) {
    write("slots.path.json", slots());
    const std::string head =
        "programs = \"slots.path.json\"\nmachines = [\"router3\"]\n"
        "[options]\npost = \"rs274ngc\"\ndialect = \"rs274ngc\"\n";
    std::string orders;
    std::vector<int> order{0, 1, 2, 3, 4};
    do {
        orders += (orders.empty() ? "" : ", ") + json(order).dump();
    } while (std::next_permutation(order.begin(), order.end()));
    write("all.toml", head + "[[setting]]\nkey = \"path.order\"\nvalues = [" + orders + "]\n");
    const Ended all = batch({"all.toml", "--results", "all.sqlite"});
    ASSERT_EQ(all.status, 0) << all.err << all.out;
    ASSERT_EQ(number("SELECT count(*) FROM latest", "all.sqlite"), 120);
    write("plan.toml", head +
                           "[objective]\ncycle_time_s = 1\n[search]\nvariants = 120\n"
                           "[[setting]]\nkey = \"path.order\"\norders = 5\n");
    const Ended ended = optimise({"plan.toml", "--json", "found.json", "--best", "best"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(found()["best"]["value"].get<double>(),
              number("SELECT min(cycle_time_s) FROM latest", "all.sqlite"));
    EXPECT_LT(found()["best"]["value"].get<double>(), found()["start"]["value"].get<double>());
    // The written program has the same result by itself.
    const Ended repeated = apps::run_program(
        tests::program_path("gsim-run"),
        {"--machine", "router3", "--dialect", "rs274ngc", "--json", "best/slots.nc"}, folder_);
    ASSERT_EQ(repeated.status, 0) << repeated.err;
    EXPECT_NEAR(text::parse_json<json>(repeated.out)["cycle_time_s"], found()["best"]["value"], 1e-9);
}

// On the thesis's gantry, the plate with its clamps and the program are placed where the rotary axes' limits
// cost least. No body comes nearer than the cell permits.
TEST_F(OptimiseProgram, ImprovesWheelPlacement) {
#ifdef GSIM_SANITIZED
    GTEST_SKIP() << "bodies are looked at ten times as long there";
#endif
    const Ended ended = optimise({std::string(kSamples) + "/batch/wheel-placement.toml", "--variants", "36",
                                  "--seed", "2", "--json", "found.json", "--best", "best"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    const double start_s = found()["start"]["value"], best_s = found()["best"]["value"];
    EXPECT_NEAR(start_s, 88.331, 0.001);
    EXPECT_LT(best_s, 0.96 * start_s);
    EXPECT_GE(best_s, found()["verification"]["best"]["lower_bound_s"].get<double>());
    const json metrics = found()["best"]["runs"][0];
    EXPECT_GE(metrics["clearance_mm"].get<double>(), 0.25);
    // By the program that everybody has, from the files that were written.
    const Ended repeated = apps::run_program(
        tests::program_path("gsim-run"),
        {"best/wheel.nc", "--machine", "af5-measured", "--cell", "best/wheel.cell.toml", "--json"}, folder_);
    ASSERT_EQ(repeated.status, 0) << repeated.err;
    const json report = text::parse_json<json>(repeated.out);
    EXPECT_NEAR(report["cycle_time_s"], best_s, 1e-9);
    EXPECT_TRUE(report["collisions"].empty());
    EXPECT_TRUE(report["clearances"].empty());
    EXPECT_NEAR(report["length"]["process_on_mm"], 3183.626, 0.01) << "what is cut is the same";
}

// Written files are in another folder, and mean the same there; values that look like names of files stay.
TEST_F(OptimiseProgram, WritesRelocatableFiles) {
    write_slide();
    write("slide", "");
    write("linear", "");
    write("plan.toml", R"(programs = "p.ngc"
machines = ["m.toml"]
[options]
max_blocks = 1000
variables = "kept.var"
[objective]
cycle_time_s = 1
[search]
variants = 20
[[setting]]
key = "machine.axis.X.max_acceleration_mm_s2"
from = 500
to = 2000
)");
    const Ended ended = optimise({"plan.toml", "--best", "there/best", "--json", "found.json"});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_THAT(read("there/best/p.ngc.machine.toml"), HasSubstr("kind = \"linear\""));
    EXPECT_THAT(ended.out, HasSubstr("# without variables, for which it has no option"));
    const Ended repeated =
        apps::run_program(tests::program_path("gsim-run"),
                          {"p.ngc", "--machine", "there/best/p.ngc.machine.toml", "--json"}, folder_);
    EXPECT_NEAR(text::parse_json<json>(repeated.out)["cycle_time_s"], found()["best"]["value"], 1e-9);
    // The verification is run, not searched.
    ASSERT_EQ(optimise({"plan.toml", "--best", "there/best", "--overwrite"}).status, 0);
    EXPECT_EQ(number("SELECT reused FROM batch_run ORDER BY batch DESC LIMIT 1"), 0);
}

// Somebody else uses the same results meanwhile.
TEST_F(OptimiseProgram, WaitsForOtherWritersOfResults) {
    write_slide();
    write("plan.toml", kOverride);
    const auto child = os::spawn({"/bin/sh", "-c",
                                  fmt::format("cd '{}' && exec {} plan.toml --variants 200 -q > /dev/null",
                                              folder_.string(), tests::program_path("gsim-optimise"))},
                                 os::SpawnActions());
    ASSERT_TRUE(child);
    for (int i = 0; i < 8; ++i) {
        write(fmt::format("q{}.ngc", i), fmt::format("G21 F600\nG1 X{}\nM2\n", 10 + i));
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        batch({"--machine", "m.toml", fmt::format("q{}.ngc", i), "--results", "gsim-optimise.sqlite", "-q"});
    }
    const auto status = os::wait_for(*child);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(number("SELECT count(DISTINCT number) FROM evaluations"), 201);
}

TEST_F(OptimiseProgram, ReportsNoFeasibleVariant) {
    write_slide();
    write("plan.toml", std::string(kOverride) + "[[limit]]\nmetric = \"cycle_time_s\"\nmax = 0.1\n");
    const Ended ended = optimise({"plan.toml", "--variants", "10"});
    EXPECT_EQ(ended.status, 1);
    EXPECT_THAT(ended.out, HasSubstr("no variant is without errors"));
    write("p.ngc", "G21 F600\nG1 X[\n");
    EXPECT_THAT(optimise({"plan.toml", "--variants", "10"}).err, HasSubstr("p.ngc: "));
}

TEST_F(OptimiseProgram, RejectsInvalidInputs) {
    write_slide();
    write("plan.toml", kOverride);
    EXPECT_THAT(optimise({}).err, HasSubstr("name a plan"));
    EXPECT_EQ(optimise({"none.toml"}).status, 2);
    EXPECT_EQ(optimise({"plan.toml", "--variants", "-1"}).status, 2);
    EXPECT_THAT(optimise({"plan.toml", "--results", "plan.toml"}).err, HasSubstr("plan.toml"));
    EXPECT_EQ(read("plan.toml"), kOverride);
    EXPECT_THAT(optimise({"plan.toml", "--best", "m.toml", "--variants", "5"}).err, HasSubstr("m.toml"));
    // Existing files of others stay.
    write("slots.path.json", slots());
    write("slots.nc", "mine\n");
    write(
        "order.toml",
        "programs = \"slots.path.json\"\nmachines = [\"router3\"]\n[options]\npost = \"rs274ngc\"\ndialect = "
        "\"rs274ngc\"\n[objective]\ncycle_time_s = 1\n[[setting]]\nkey = \"path.order\"\norders = 5\n");
    EXPECT_THAT(optimise({"order.toml", "--best", ".", "--variants", "5"}).err,
                HasSubstr("'./slots.nc' already exists"));
    EXPECT_EQ(read("slots.nc"), "mine\n");
    EXPECT_EQ(optimise({"order.toml", "--best", ".", "--variants", "5", "--overwrite"}).status, 0);
    EXPECT_THAT(read("slots.nc"), HasSubstr("M2"));
    std::string energy = kOverride;
    write("energy.toml", energy.replace(energy.find("cycle_time_s"), 12, "energy_j"));
    EXPECT_THAT(optimise({"energy.toml"}).err, HasSubstr("have no 'energy_j'"));
    // Outputs are tried before anything is run, and inputs are never written over.
    EXPECT_THAT(optimise({"plan.toml", "--json", "none/found.json"}).err, HasSubstr("none"));
    EXPECT_THAT(optimise({"plan.toml", "--best", "/dev/null/x"}).err, HasSubstr("/dev/null/x"));
    write("p.ngc.machine.toml", read("m.toml"));
    std::string own = kOverride;
    own.replace(own.find("\"m.toml\""), 8, "\"p.ngc.machine.toml\"");
    write("own.toml", own);
    EXPECT_THAT(optimise({"own.toml", "--best", ".", "--overwrite"}).err,
                HasSubstr("p.ngc.machine.toml' is an input of the search"));
    EXPECT_EQ(read("p.ngc.machine.toml"), read("m.toml"));
    std::string nowhere = kOverride;
    nowhere.replace(nowhere.find("option.feed_override_percent"), 28, "machine.axis.Q.max_speed_mm_s");
    write("nowhere.toml", nowhere);
    const Ended reported = optimise({"nowhere.toml"});
    EXPECT_EQ(reported.status, 2);
    EXPECT_THAT(reported.err, HasSubstr("'axis.Q.max_speed_mm_s': 'Q' does not exist"));
    write("bare.toml", "programs = \"p.ngc\"\n");
    EXPECT_THAT(optimise({"bare.toml"}).err, HasSubstr("[objective]"));
    EXPECT_THAT(batch({"plan.toml"}).err, HasSubstr("no list of values"))
        << "the plan of a search is none of a grid";
}

}  // namespace
}  // namespace gsim::batch::optimise_program_test
