// Plans of searches, their counts, and the progress of a search, with runs of a closed form.
#include "batch/search/search.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <unistd.h>

#include "batch/search/space.h"
#include "batch/store/results.h"

namespace gsim::batch::search_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kPlan = R"(programs = ["p.nc"]
machines = ["m.toml"]
[objective]
cycle_time_s = 1
[search]
variants = 150
seed = 3
[[setting]]
key = "machine.a"
from = -4
to = 4
[[setting]]
key = "machine.b"
from = -4
to = 4
)";

class SearchFile : public testing::Test {
  protected:
    SearchFile() {
        fs::create_directories(folder_);
        std::ofstream(folder_ / "p.nc") << "M2\n";
    }
    ~SearchFile() override { fs::remove_all(folder_); }

    Result<SearchPlan> read(const std::string& text) const {
        return read_search(text, (folder_ / "plan.toml").string());
    }
    std::string rejection(const std::string& text) const {
        const auto search = read(text);
        return search ? "" : search.error().message;
    }

    /// Runs a batch as `row` says.
    Evaluate evaluate_by(std::function<RunRow(const Job&)> row) {
        return [this, row = std::move(row)](const Plan& plan, bool) -> Result<EvaluatedBatch> {
            if (batches_left_-- == 0) return EvaluatedBatch{};
            auto results = Results::open(results_);
            EXPECT_TRUE(results->begin_batch(plan.name, Jobs(plan).size(), "v"));
            const Jobs jobs(plan);
            for (std::uint64_t i = 0; i < jobs.size(); ++i) {
                const Job job = jobs.job(i);
                ++evaluated_;
                const auto run = results->add(job, {std::to_string(evaluated_), "", ""}, row(job), "v");
                EXPECT_TRUE(run && results->record(i, *run, false));
            }
            EXPECT_TRUE(results->end_batch(true));
            return EvaluatedBatch{results->batch(), true};
        };
    }

    Result<SearchState> search(const SearchPlan& plan, std::function<RunRow(const Job&)> row) {
        return search_best(plan, results_, evaluate_by(std::move(row)), [](const SearchState&) {});
    }

    double number(const std::string& query) const {
        auto database = Database::open(results_, true);
        auto statement = database->prepare(query);
        EXPECT_TRUE(statement && statement->step().value_or(false)) << query;
        return statement->number(0);
    }

    fs::path folder_ = fs::temp_directory_path() / ("gsim-search-" + std::to_string(::getpid()));
    std::string results_ = (folder_ / "r.sqlite").string();
    int batches_left_ = 1'000'000;
    int evaluated_ = 0;
};

double setting(const Job& job, std::size_t place) {
    return job.settings.empty() ? 0 : job.settings[place].value.get<double>();
}

RunRow is_clean(double time_s) {
    return {
        .outcome = {.status = "completed"}, .times = {.cycle_s = time_s}, .extents = "{}", .findings = "[]"};
}

/// Returns a run with its minimum, 10, at 1, -2.
RunRow bowl(const Job& job) {
    return is_clean(10 + std::pow(setting(job, 0) - 1, 2) + 4 * std::pow(setting(job, 1) + 2, 2));
}

TEST_F(SearchFile, FindsMinimumOfBowl) {
    const auto plan = read(kPlan);
    ASSERT_TRUE(plan) << plan.error().message;
    const auto state = search(*plan, bowl);
    ASSERT_TRUE(state) << state.error().message;
    EXPECT_EQ(state->start.score.value.value(), 27) << "with the settings that the files have";
    EXPECT_NEAR(state->best.score.value.value(), 10, 1e-3);
    EXPECT_NEAR(state->best.settings[0].value.get<double>(), 1, 0.03);
    EXPECT_EQ(state->trials, 151U);
    EXPECT_EQ(evaluated_, 151) << "no more than was allowed, and the start";
    EXPECT_TRUE(state->complete);
    EXPECT_EQ(number("SELECT count(*) FROM evaluations"), 151);
    EXPECT_EQ(number("SELECT min(value) FROM search_run"), state->best.score.value.value());
    EXPECT_EQ(number("SELECT best FROM search"), static_cast<double>(state->best_number));
    EXPECT_EQ(number("SELECT cycle_time_s FROM evaluations WHERE number = (SELECT best FROM search)"),
              state->best.score.value.value());
}

TEST_F(SearchFile, SamePlanGivesSameTrials) {
    const auto plan = read(kPlan);
    std::vector<std::string> first, second;
    for (auto* trials : {&first, &second}) {
        ASSERT_TRUE(search(*plan, [&](const Job& job) {
            trials->push_back(settings_json(job.settings).dump());
            return bowl(job);
        }));
    }
    EXPECT_EQ(first, second);
}

TEST_F(SearchFile, ReturnsPartialResultIfInterrupted) {
    const auto plan = read(kPlan);
    batches_left_ = 4;
    const auto state = search(*plan, bowl);
    ASSERT_TRUE(state) << state.error().message;
    EXPECT_FALSE(state->complete);
    EXPECT_GT(state->trials, 20U);
    EXPECT_LT(state->best.score.value.value(), 27);
    batches_left_ = 0;
    EXPECT_EQ(search(*plan, bowl)->trials, 0U);
}

// The minimum of the bowl is not allowed: beyond a line a run fails, and a limit bounds a value.
TEST_F(SearchFile, FindsMinimumWithinLimits) {
    const std::string text = std::string(kPlan) + "[[limit]]\nmetric = \"clearance_mm\"\nmin = 1\n";
    auto plan = read(text);
    ASSERT_TRUE(plan) << plan.error().message;
    plan->variants = 400;  // in a corner of two limits it takes smaller steps
    const auto fenced = [](const Job& job) {
        RunRow row = bowl(job);
        row.clearance_mm = 2 - setting(job, 0);  // a is at most 1
        if (setting(job, 1) < -1) {
            row.outcome.cause = "collision";
            row.counts.collisions = 3;
        }
        return row;
    };
    const auto state = search(*plan, fenced);
    ASSERT_TRUE(state) << state.error().message;
    ASSERT_TRUE(state->best.score.is_feasible());
    EXPECT_NEAR(state->best.score.value.value(), 14, 0.05) << "at 1, -1";
    EXPECT_GE(state->best.settings[1].value.get<double>(), -1);
    EXPECT_EQ(number("SELECT count(*) FROM search_run WHERE violation = 0"),
              static_cast<double>(state->feasible));
}

TEST_F(SearchFile, OrdersViolationsByAmount) {
    const auto plan = read(kPlan);
    const auto violation = [&](RunRow row) {
        Plan one = plan->plan;
        one.settings.clear();
        const auto evaluated = evaluate_by([&](const Job&) { return row; })(one, false);
        auto results = Database::open(results_);
        const auto runs = read_metrics(*results, evaluated->batch, 1);
        const std::vector<RunMetrics> start{{.status = "completed", .metrics = {{"process_findings", 1}}}};
        return compute_score(*plan, *runs, start).violation;
    };
    RunRow touching = is_clean(1), past = is_clean(1), far = is_clean(1), findings = is_clean(1), alarm,
           early, rejected;
    touching.outcome.cause = "collision";
    touching.counts.collisions = 1;
    past.outcome.status = "violations";
    past.counts.violations = 12;
    findings.counts.process_findings = 2;
    alarm.outcome.status = early.outcome.status = "alarm";
    alarm.counts.blocks = 1000;
    early.counts.blocks = 10;
    rejected.outcome.status = "refused";
    EXPECT_EQ(violation(is_clean(1)), 0);
    EXPECT_EQ(violation(findings), 1) << "one more than the start has";
    EXPECT_EQ(violation(touching), 1);
    EXPECT_EQ(violation(past), 12);
    EXPECT_LT(violation(past), violation(alarm));
    EXPECT_LT(violation(alarm), violation(early)) << "it came farther";
    EXPECT_LT(violation(early), violation(rejected));
}

// A run that was not made has no value, least of all a good one.
TEST_F(SearchFile, RejectedRunHasNoValue) {
    const auto plan = read(kPlan);
    const auto state = search(*plan, [](const Job& job) {
        RunRow row = bowl(job);
        if (setting(job, 0) < 0) row.outcome.status = "refused";
        return row;
    });
    ASSERT_TRUE(state) << state.error().message;
    EXPECT_NEAR(state->best.score.value.value(), 10, 1e-2);
    EXPECT_GT(number("SELECT count(*) FROM search_run WHERE value IS NULL AND violation >= 1e9"), 0);
    EXPECT_EQ(number("SELECT count(*) FROM search_run WHERE value < 10"), 0);
}

TEST_F(SearchFile, ReportsImpossibleSettingEarly) {
    const auto plan = read(kPlan);
    const auto state = search(*plan, [](const Job& job) {
        RunRow row = bowl(job);
        if (!job.settings.empty()) {
            row.outcome.status = "refused";
            row.outcome.message = "there is no 'Q'";
        }
        return row;
    });
    ASSERT_FALSE(state);
    EXPECT_THAT(state.error().message, HasSubstr("each of the 20 first variants is rejected: "));
    EXPECT_THAT(state.error().message, HasSubstr("p.nc: there is no 'Q'"));
    EXPECT_EQ(evaluated_, 21);
}

TEST_F(SearchFile, MoreVariantsContinueAfterFewer) {
    auto plan = read(kPlan);
    std::vector<std::string> fewer, more;
    for (auto* trials : {&fewer, &more}) {
        plan->variants = trials == &fewer ? 33 : 80;
        ASSERT_TRUE(search(*plan, [&](const Job& job) {
            trials->push_back(settings_json(job.settings).dump());
            return bowl(job);
        }));
    }
    ASSERT_EQ(fewer.size(), 34U);
    EXPECT_TRUE(std::equal(fewer.begin(), fewer.end(), more.begin()));
    plan->variants = 7;
    std::vector<std::string> few;
    ASSERT_TRUE(search(*plan, [&](const Job& job) {
        few.push_back(settings_json(job.settings).dump());
        return bowl(job);
    }));
    EXPECT_TRUE(std::equal(few.begin(), few.end(), more.begin()));
}

TEST_F(SearchFile, AcceptsMachineNamedTwice) {
    std::string text = kPlan;
    text.replace(text.find("[\"m.toml\"]"), 10, "[\"m.toml\", \"m.toml\"]");
    const auto state = search(*read(text), bowl);
    ASSERT_TRUE(state) << state.error().message;
    EXPECT_NEAR(state->best.score.value.value(), 20, 1e-2);
}

TEST_F(SearchFile, SumsOverPrograms) {
    std::ofstream(folder_ / "q.nc") << "M2\n";
    std::string text = kPlan;
    text.replace(text.find("\"p.nc\""), 6, "\"p.nc\", \"q.nc\"");
    const auto plan = read(text);
    ASSERT_TRUE(plan) << plan.error().message;
    // Each program has its minimum elsewhere; the sum has it halfway.
    const auto state = search(*plan, [](const Job& job) {
        return is_clean(1 + std::pow(setting(job, 0) - (job.program.ends_with("p.nc") ? 2 : 0), 2));
    });
    ASSERT_TRUE(state) << state.error().message;
    EXPECT_NEAR(state->best.score.value.value(), 4, 1e-3);
    EXPECT_NEAR(state->best.settings[0].value.get<double>(), 1, 0.03);
    EXPECT_EQ(state->best.runs.size(), 2U);
    EXPECT_EQ(number("SELECT count(*) FROM search_run"), 302);
}

TEST_F(SearchFile, ReportsMissingMetric) {
    std::string text = kPlan;
    text.replace(text.find("cycle_time_s"), 12, "energy_j");
    const auto state = search(*read(text), bowl);
    ASSERT_FALSE(state);
    EXPECT_THAT(state.error().message, HasSubstr("have no 'energy_j'"));
}

TEST_F(SearchFile, FindsBestOrder) {
    std::string text = kPlan;
    text.erase(text.find("[[setting]]"));
    text += "[[setting]]\nkey = \"path.order\"\norders = 5\n";
    // Path through points on a line, in any order; 4 there and back is the minimum.
    const auto plan = read(text);
    ASSERT_TRUE(plan) << plan.error().message;
    const auto state = search(*plan, [](const Job& job) {
        constexpr std::array kAt{3.0, 1.0, 4.0, 0.0, 2.0};
        double at = 0, distance = 0;
        const std::vector<std::size_t> order = job.settings.empty()
                                                   ? std::vector<std::size_t>{0, 1, 2, 3, 4}
                                                   : job.settings[0].value.get<std::vector<std::size_t>>();
        for (const std::size_t place : order) {
            distance += std::abs(kAt[place] - at);
            at = kAt[place];
        }
        return is_clean(distance);
    });
    ASSERT_TRUE(state) << state.error().message;
    EXPECT_EQ(state->best.score.value.value(), 4);
    EXPECT_EQ(state->best.settings[0].value, (nlohmann::json{3U, 1U, 4U, 0U, 2U}));
}

TEST(SearchSpace, HasCoordinatePerSettingAndOrderElement) {
    const SearchSpace space({{{"machine.a", "machine.b"}, Uniform{10, 20}, SettingUse::shift},
                             {{"path.order"}, Order{3}},
                             {{"option.dialect"}, Choices{{"ab9", "rs274ngc"}}}});
    ASSERT_EQ(space.dimensions(), 5U);
    Eigen::VectorXd point(5);
    point << 0.25, 0.9, 0.1, 0.5, 1;
    const std::vector<SettingValue> values = space.variant(point);
    EXPECT_EQ(values[0], (SettingValue{"machine.a", 12.5, SettingUse::shift}));
    EXPECT_EQ(values[1], (SettingValue{"machine.b", 12.5, SettingUse::shift}));
    EXPECT_EQ(values[2].value, (nlohmann::json{1U, 2U, 0U}));
    EXPECT_EQ(values[3].value, "rs274ngc") << "the end of the box is its last value";
}

TEST_F(SearchFile, AcceptsOldKeyNamesAndWarns) {
    const std::string text = kPlan;
    const auto old = read(text + "[[limit]]\nfigure = \"cycle_time_s\"\nleast = 1\nmost = 3\n");
    ASSERT_TRUE(old) << old.error().message;
    ASSERT_EQ(old->limits.size(), 1);
    EXPECT_EQ(old->limits[0].metric, "cycle_time_s");
    EXPECT_EQ(old->limits[0].min, 1);
    EXPECT_EQ(old->limits[0].max, 3);
    EXPECT_EQ(old->warnings.size(), 3);
    std::string metric = text + "[[limit]]\nmetric = \"most_s\"\nmax = 3\n";
    metric.replace(metric.find("cycle_time_s"), 12, "most_s");
    const auto renamed = read(metric);
    ASSERT_TRUE(renamed) << renamed.error().message;
    EXPECT_EQ(renamed->objective[0].metric, "cycle_time_max_s");
    EXPECT_EQ(renamed->limits[0].metric, "cycle_time_max_s");
    EXPECT_EQ(renamed->warnings.size(), 2);
}

TEST_F(SearchFile, ReportsErrorsOfPlan) {
    const std::string text = kPlan;
    const auto without = [&](const std::string& part) {
        std::string less = text;
        return less.erase(less.find(part), part.size());
    };
    EXPECT_THAT(rejection(without("[objective]\ncycle_time_s = 1\n")), HasSubstr("requires [objective]"));
    EXPECT_THAT(rejection(text.substr(0, text.find("[[setting]]"))), HasSubstr("requires [[setting]]"));
    const auto with = [&](const std::string& more) { return rejection(text + more); };
    EXPECT_THAT(with("[[limit]]\nmax = 1\n"), HasSubstr("lacks the key 'metric'"));
    EXPECT_THAT(with("[[limit]]\nmetric = \"cycle_time_s\"\n"), HasSubstr("'min', 'max' or both"));
    EXPECT_THAT(with("[[limit]]\nmetric = \"cycle_time_s\"\nmin = 3\nmax = 1\n"), HasSubstr("not be less"));
    EXPECT_THAT(with("[[limit]]\nmetric = \"cycle\"\nmax = 1\n"), HasSubstr("'metric' must be"));
    EXPECT_THAT(
        with("[[setting]]\nkey = \"machine.c\"\ndistribution = \"normal\"\nmean = 1\ndeviation = 1\n"),
        HasSubstr(
            "'machine.c': a search supports 'from' and 'to', 'values' or 'orders', not a distribution"));
    std::string wrong = text;
    EXPECT_THAT(rejection(wrong.replace(wrong.find("cycle_time_s"), 12, "cycle_tims_s")),
                HasSubstr("did you mean 'cycle_time_s'?"));
    wrong = text;
    EXPECT_THAT(rejection(wrong.replace(wrong.find("= 1\n"), 3, "= 0")), HasSubstr("a weight of 0"));
    wrong = text;
    EXPECT_THAT(rejection(wrong.replace(wrong.find("variants = 150"), 14, "variants = 1.5")),
                HasSubstr("'variants' must be an integer from 1"));
    EXPECT_THAT(rejection("objective = 1\n"), HasSubstr("programs"));
    EXPECT_THAT(with("[sampling]\nkind = \"random\"\nruns = 3\n"), HasSubstr("selects its variants itself"));
    EXPECT_THAT(rejection("controllers = [\"ab9\", \"blend\"]\n" + text), HasSubstr("supports one control"));
    std::string many = text;
    for (int i = 0; i < 7; ++i)
        many += "[[setting]]\nkey = \"machine.s" + std::to_string(i) + "\"\nfrom = 1\nto = 2\nsteps = 31\n";
    EXPECT_EQ(rejection(many), "") << "of which it tries 150";
    std::string speeds = text;
    speeds.replace(speeds.find("cycle_time_s"), 12, "joint_speed_share");
    EXPECT_EQ(read(speeds)->plan.options["joint_speeds"], true);
}

}  // namespace
}  // namespace gsim::batch::search_test
