#include "batch/slurm/shards.h"

#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <unistd.h>

#include "batch/slurm/commands.h"

namespace gsim::batch::shards_test {
namespace {

namespace fs = std::filesystem;

TEST(Shards, HaveEachJobOnceAndSimilarSize) {
    Shards shards;
    for (std::uint64_t job = 0; job < 1007; job += job % 3 + 1) shards.pending_jobs.push_back(job);
    shards.shards = 16;
    std::multiset<std::uint64_t> all;
    std::size_t min = shards.pending_jobs.size(), max = 0;
    for (std::uint64_t shard = 0; shard < shards.shards; ++shard) {
        const auto jobs = shards.shard_jobs(shard);
        all.insert(jobs.begin(), jobs.end());
        min = std::min(min, jobs.size());
        max = std::max(max, jobs.size());
    }
    EXPECT_TRUE(std::equal(all.begin(), all.end(), shards.pending_jobs.begin(), shards.pending_jobs.end()));
    EXPECT_LE(max - min, 1U);
}

TEST(Shards, StayWithinArraySize) {
    EXPECT_EQ(shard_count(1, 1000, 1000), 1U);
    EXPECT_EQ(shard_count(1001, 1000, 1000), 2U);
    EXPECT_EQ(shard_count(10'000'000, 1000, 1000), 1000U);
}

TEST(Shards, AreWrittenAndReadBack) {
    const fs::path folder = fs::temp_directory_path() / ("gsim-shards-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    Shards shards;
    shards.results = "/a/r.sqlite";
    shards.jobs = 50;
    shards.pending_jobs = {0, 1, 2, 7, 8, 40};
    shards.shards = 3;
    shards.array_job = "12";
    ASSERT_TRUE(write_shards(folder, shards));
    const auto read = read_shards(folder);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->pending_jobs, shards.pending_jobs);
    EXPECT_EQ(read->array_job, "12");
    Plan plan;
    plan.programs = {"a.nc"};
    plan.settings = {{.keys = {"machine.a"}, .domain = Triangular{0, 4, 1}, .use = SettingUse::factor},
                     {.keys = {"machine.b"}, .domain = Normal{5, 1}},
                     {.keys = {"option.dialect"}, .domain = Choices{{"ab9"}}}};
    plan.design = {.sampling = Sampling::sobol, .runs = 9, .seed = 4};
    ASSERT_TRUE(write_stored_plan(folder, plan));
    const auto repeated = read_stored_plan(folder);
    ASSERT_TRUE(repeated) << repeated.error().message;
    const Jobs ours(plan), theirs(*repeated);
    ASSERT_EQ(theirs.size(), 9U);
    for (std::uint64_t job = 0; job < 9; ++job)
        EXPECT_EQ(print_job(ours.job(job)), print_job(theirs.job(job)));
    fs::remove_all(folder);
    EXPECT_FALSE(read_shards(folder));
}

// slurm.conf(5) and sbatch(1): minutes, minutes:seconds, hours:minutes:seconds, days-hours,
// days-hours:minutes, ...
TEST(SlurmTime, IsReadInAllFormats) {
    EXPECT_EQ(read_minutes("90").value(), 90U);
    EXPECT_EQ(read_minutes("10:30").value(), 10U);
    EXPECT_EQ(read_minutes("01:30:00").value(), 90U);
    EXPECT_EQ(read_minutes("2-12").value(), 60U * 60);
    EXPECT_EQ(read_minutes("1-00:30").value(), 24U * 60 + 30);
    EXPECT_EQ(read_minutes("1-01:30:59").value(), 25U * 60 + 30);
    EXPECT_EQ(read_minutes("UNLIMITED").value(), std::nullopt);
    for (const char* none : {"", "a", "1:2:3:4", "-5", "1-", "1.5"}) EXPECT_FALSE(read_minutes(none)) << none;
}

TEST(SlurmFields, AreReadInBothFormats) {
    const auto fields = read_fields(
        "PartitionName=test MaxTime=UNLIMITED\n   TotalNodes=2\nMaxArraySize            = 1001\n");
    EXPECT_EQ(fields.at("MaxTime"), "UNLIMITED");
    EXPECT_EQ(fields.at("TotalNodes"), "2");
    EXPECT_EQ(fields.at("MaxArraySize"), "1001");
}

}  // namespace
}  // namespace gsim::batch::shards_test
