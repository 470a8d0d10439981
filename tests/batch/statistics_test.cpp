#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include <gmock/gmock.h>
#include <unistd.h>

#include "base/text/json.h"
#include "batch/plan/plan.h"
#include "batch/statistics/regression.h"
#include "batch/statistics/sample.h"
#include "batch/statistics/study.h"
#include "batch/store/results.h"
#include "batch/work/run_job.h"

namespace gsim::batch::statistics_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Student's t with 9 degrees of freedom: 2.262157 at 97.5 %.
TEST(Summary, HasMeanAndItsInterval) {
    const SampleSummary summary = summarize({10, 9, 8, 7, 6, 5, 4, 3, 2, 1});
    EXPECT_DOUBLE_EQ(summary.mean, 5.5);
    EXPECT_NEAR(summary.deviation, 3.0276503540974917, 1e-12);
    EXPECT_NEAR(*summary.mean_interval.max - 5.5, 2.2621571628 * 3.0276503541 / std::sqrt(10.0), 1e-8);
    EXPECT_DOUBLE_EQ(summary.percentiles[3].value, 5.5);
    EXPECT_DOUBLE_EQ(summary.percentiles[2].value, 3.25) << "type 7 of Hyndman and Fan";
    // The second and the ninth of ten values are the narrowest that hold the median with 95 % (97.9 %).
    EXPECT_EQ(summary.percentiles[3].interval.min, 2);
    EXPECT_EQ(summary.percentiles[3].interval.max, 9);
    EXPECT_FALSE(summary.percentiles[0].interval.min) << "ten runs do not tell how little there may be";
    const SampleSummary one = summarize({7});
    EXPECT_EQ(one.mean, 7);
    EXPECT_FALSE(one.mean_interval.min);
}

// The interval is 1 - 0.025^(1/n) for none of n; for 5 of 50 it is that of the tables of Clopper and Pearson.
TEST(Proportion, HasConfidenceInterval) {
    EXPECT_EQ(*proportion_interval(0, 300).min, 0);
    EXPECT_NEAR(*proportion_interval(0, 300).max, 1 - std::pow(0.025, 1.0 / 300), 1e-12);
    EXPECT_NEAR(*proportion_interval(300, 300).min, std::pow(0.025, 1.0 / 300), 1e-12);
    EXPECT_NEAR(*proportion_interval(5, 50).min, 0.0333, 5e-5);
    EXPECT_NEAR(*proportion_interval(5, 50).max, 0.2181, 5e-5);
}

TEST(Regression, FindsSlopesOfLinearFunction) {
    std::mt19937 random(3);
    std::vector<double> a, b, constant, metric;
    for (int i = 0; i < 200; ++i) {
        a.push_back(static_cast<double>(random() % 1000) / 1000);
        b.push_back(static_cast<double>(random() % 1000));
        constant.push_back(4);
        metric.push_back(7 + 3 * a.back() - 0.002 * b.back());
    }
    const Sensitivity found = regress({"a", "b", "constant"}, {a, b, constant}, metric);
    ASSERT_EQ(found.effects.size(), 2U);
    EXPECT_NEAR(found.effects[0].slope, 3, 1e-9);
    EXPECT_NEAR(found.effects[1].slope, -0.002, 1e-12);
    EXPECT_NEAR(found.explained, 1, 1e-12);
    EXPECT_GT(found.effects[0].coefficient, 0.7);
    EXPECT_LT(found.effects[1].coefficient, -0.4);
    EXPECT_TRUE(regress({"a"}, {{1, 2}}, {1, 2}).effects.empty())
        << "two runs tell nothing of a slope and a mean";
    EXPECT_TRUE(regress({"a"}, {{1, 2, 3, 4}}, {5, 5, 5, 5}).effects.empty());
}

TEST(Histogram, CountsEachValueOnce) {
    std::vector<double> values;
    for (int i = 0; i <= 1000; ++i) values.push_back(0.01 * i);
    std::uint64_t count = 0;
    const auto bins = histogram(values);
    EXPECT_GT(bins.size(), 5U);
    for (const Bin& bin : bins) count += bin.count;
    EXPECT_EQ(count, values.size());
    EXPECT_EQ(histogram({3, 3, 3}).size(), 1U);
    EXPECT_EQ(convergence(values).back().count, values.size());
}

// Line of 40 mm from standstill to standstill at 1000 mm/s2, at a feed of 10 mm/s with an override from 40 to
// 160 percent. It takes 40 / v + v / 1000 s, less at higher speed.
class ClosedForm : public testing::Test {
  protected:
    ClosedForm() {
        fs::create_directories(folder_);
        std::ofstream(folder_ / "p.ngc") << "G21 F600\nG1 X40\nM2\n";
        std::ofstream(folder_ / "m.toml")
            << "[machine]\nname = \"slide\"\n[program]\ndialect = \"rs274ngc\"\n[[axis]]\nletter = \"X\"\n"
               "kind = \"linear\"\nmax_mm = 1000.0\nmax_speed_mm_s = 100.0\nmax_acceleration_mm_s2 = 1000.0\n"
               "direction = \"x\"\n";
    }
    ~ClosedForm() override { fs::remove_all(folder_); }

    static double time_s(double percent) { return 40 / (percent / 10) + percent / 10 / 1000; }
    static double percentile_s(double share) { return time_s(40 + 120 * (1 - share)); }

    Plan plan(Sampling sampling, std::uint64_t runs, std::uint64_t seed) const {
        Plan plan;
        plan.programs = {(folder_ / "p.ngc").string()};
        plan.machines = {(folder_ / "m.toml").string()};
        plan.settings = {{.keys = {"option.feed_override_percent"}, .domain = Uniform{40, 160}}};
        plan.design = {.sampling = sampling, .runs = runs, .seed = seed};
        return plan;
    }

    /// Number of the first seeds that are run, to show that runs take the closed-form time; statistics of
    /// more seeds use the closed form alone.
    static constexpr std::uint64_t kSeedsRun = 5;

    std::vector<double> times_s(Sampling sampling, std::uint64_t runs, std::uint64_t seed) {
        const Plan one = plan(sampling, runs, seed);
        const Jobs jobs(one);
        std::vector<double> found;
        for (std::uint64_t number = 0; number < jobs.size(); ++number) {
            const Job job = jobs.job(number);
            const double expected_s = time_s(job.settings[0].value);
            if (seed <= kSeedsRun) {
                const RunRow row = runner_.run(job);
                EXPECT_EQ(row.outcome.status, "completed") << row.outcome.message;
                EXPECT_NEAR(row.times.cycle_s, expected_s, 1e-9);
            }
            found.push_back(expected_s);
        }
        return found;
    }

    fs::path folder_ = fs::temp_directory_path() / ("gsim-statistics-" + std::to_string(::getpid()));
    JobRunner runner_;
};

TEST_F(ClosedForm, IntervalsContainPercentilesFor95Of100Seeds) {
    constexpr std::uint64_t kRuns = 60;
    std::vector<int> covered(7);
    int mean_held = 0;
    // The mean of 400 / p + p / 10000 over p from 40 to 160.
    const double mean_s = 400 * std::log(4.0) / 120 + 0.01;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const SampleSummary summary = summarize(times_s(Sampling::random, kRuns, seed));
        for (std::size_t i = 0; i < summary.percentiles.size(); ++i)
            covered[i] +=
                summary.percentiles[i].interval.contains(percentile_s(summary.percentiles[i].share)) ? 1 : 0;
        mean_held += summary.mean_interval.contains(mean_s) ? 1 : 0;
    }
    EXPECT_THAT(covered, testing::Each(testing::Ge(95)));
    EXPECT_GE(mean_held, 92) << "Student's t is for normal samples; this one is skew";
}

TEST_F(ClosedForm, EvenDesignsAreMoreAccurateThanRandom) {
    const auto worst = [&](Sampling sampling) {
        double max = 0;
        for (std::uint64_t seed = 1; seed <= 5; ++seed)
            max = std::max(max, std::abs(summarize(times_s(sampling, 64, seed)).percentiles[3].value -
                                         percentile_s(0.5)));
        return max;
    };
    const double uniform_random = worst(Sampling::random);
    EXPECT_LT(worst(Sampling::latin_hypercube), uniform_random / 3);
    EXPECT_LT(worst(Sampling::sobol), uniform_random / 3);
}

TEST_F(ClosedForm, ReadsStudiesAndComparisonsFromResults) {
    const std::string file = (folder_ / "r.sqlite").string();
    Plan both = plan(Sampling::latin_hypercube, 40, 1);
    // The same machine with half of the acceleration, and one run that fails.
    both.programs.push_back(both.programs.front());  // copies are pairs one by one
    both.machines.push_back((folder_ / "slow.toml").string());
    std::ifstream in(folder_ / "m.toml");
    std::string text((std::istreambuf_iterator<char>(in)), {});
    text.replace(text.find("s2 = 1000.0"), 11, "s2 = 500.0 ");
    std::ofstream(folder_ / "slow.toml") << text;
    {
        auto results = Results::open(file);
        ASSERT_TRUE(results);
        const Jobs jobs(both);
        ASSERT_TRUE(results->begin_batch("p", jobs.size(), "v"));
        for (std::uint64_t number = 0; number < jobs.size(); ++number) {
            const Job job = jobs.job(number);
            RunRow row = runner_.run(job);
            if (number == 3) row.outcome.status = row.outcome.cause = "timeout";
            ASSERT_TRUE(results->record(
                number, results->add(job, {std::to_string(number), "", ""}, row, "v").value(), false));
        }
        ASSERT_TRUE(results->end_batch(true));
    }
    auto database = Database::open(file, true);
    const auto studies = read_studies(*database);
    ASSERT_TRUE(studies) << studies.error().message;
    ASSERT_EQ(studies->size(), 2U);
    EXPECT_EQ(studies->front().runs, 80U);
    EXPECT_EQ(studies->front().failed, 1U);
    EXPECT_EQ(studies->front().time.count, 79U);
    EXPECT_NEAR(studies->front().time.percentiles[3].value, percentile_s(0.5), 0.1);
    ASSERT_EQ(studies->front().sensitivity.effects.size(), 1U);
    EXPECT_LT(studies->front().sensitivity.effects[0].coefficient, -0.9);
    const auto comparisons = compare_machines(*database);
    ASSERT_TRUE(comparisons) << comparisons.error().message;
    ASSERT_EQ(comparisons->size(), 1U);
    EXPECT_EQ(comparisons->front().pairs, 80U);
    EXPECT_EQ(comparisons->front().slower, 79U);
    EXPECT_EQ(comparisons->front().fails_first, 1U);
    // The difference is that of v / 500 and v / 1000, for v from 4 to 16 mm/s.
    EXPECT_NEAR(comparisons->front().difference_s.mean, 0.010, 0.0005);
    EXPECT_FALSE(compare_batches(*database, 0)) << "there is none before";
    EXPECT_THAT(to_html(*studies, *comparisons), HasSubstr("<svg"));
    const auto read = text::parse_json<nlohmann::json>(to_json(*studies, *comparisons));
    EXPECT_EQ(read["studies"][0]["cycle_time_s"]["count"], 79);
}

}  // namespace
}  // namespace gsim::batch::statistics_test
