#include "batch/work/worker_pool.h"

#include <map>

#include <gmock/gmock.h>

namespace gsim::batch::worker_pool_test {
namespace {

using testing::HasSubstr;

/// Worker in sh: it answers jobs like a real one, and obeys the names of some programs.
constexpr const char* kWorker = R"(
while IFS= read -r line; do
    number=$(expr "$line" : '.*"number":\([0-9]*\)')
    case $line in
        *crash*) kill -SEGV $$ ;;
        *leave*) exit 3 ;;
        *ended*) kill -TERM $$ ;;
        *memory*) exit 12 ;;
        *sleep*) exec sleep 60 ;;
        *babble*) echo 'no row' ;;
    esac
    echo "{\"number\":$number,\"status\":\"completed\",\"cause\":\"\",\"message\":\"\",\"file\":\"\",\"line\":0,\"machine\":\"\",\"controller\":\"\",\"cycle_time_s\":1,\"rapid_s\":0,\"feed_s\":0,\"dwell_s\":0,\"rapid_mm\":0,\"feed_mm\":0,\"process_on_mm\":0,\"blocks\":0,\"moves\":0,\"violations\":0,\"collisions\":0,\"process_findings\":0,\"warnings\":0,\"extents\":\"{}\",\"findings\":\"[]\",\"cpu_s\":0,\"report\":\"\",\"picture\":\"\",\"picture_error\":\"\",\"cycle_time_min_s\":null,\"cycle_time_max_s\":null,\"energy_j\":null,\"clearance_mm\":null,\"deviation_mm\":null,\"joint_speed_share\":null,\"lower_bound_s\":null,\"files\":[]}"
done
)";

std::map<std::size_t, RunRow> run_all(const std::vector<std::string>& programs, std::size_t workers,
                                      double timeout_s = 60) {
    WorkerPool pool({.command = {"/bin/sh", "-c", kWorker}, .workers = workers, .timeout_s = timeout_s});
    std::map<std::size_t, RunRow> rows;
    std::size_t next = 0;
    while (rows.size() < programs.size()) {
        while (next < programs.size() && pool.has_capacity()) {
            const auto given = pool.submit({.number = next,
                                            .program = programs[next],
                                            .machine = "",
                                            .options = nlohmann::json::object(),
                                            .settings = {}});
            EXPECT_TRUE(given) << given.error().message;
            ++next;
        }
        auto taken = pool.collect(std::chrono::milliseconds(100));
        EXPECT_TRUE(taken) << taken.error().message;
        for (RunRow& row : *taken) EXPECT_TRUE(rows.emplace(row.number, row).second) << "a row twice";
    }
    EXPECT_EQ(pool.pending_count(), 0U);
    return rows;
}

TEST(WorkerPool, ReturnsRowForEachJob) {
    const auto rows = run_all(std::vector<std::string>(200, "a.nc"), 3);
    for (const auto& [number, row] : rows) EXPECT_EQ(row.outcome.status, "completed");
}

TEST(WorkerPool, EndedWorkerFailsOnlyItsJob) {
    std::vector<std::string> programs(60, "a.nc");
    for (std::size_t i = 0; i < programs.size(); i += 5)
        programs[i] = std::vector<std::string>{"crash", "leave", "memory", "babble"}[i / 5 % 4];
    const auto rows = run_all(programs, 2);
    for (const auto& [number, row] : rows) {
        SCOPED_TRACE(programs[number]);
        if (programs[number] == "a.nc") {
            EXPECT_EQ(row.outcome.status, "completed");
        }
        if (programs[number] == "memory") {
            EXPECT_EQ(row.outcome.status, "memory");
        }
        if (programs[number] == "crash") {
            EXPECT_THAT(row.outcome.message, HasSubstr("signal 11"));
        }
        if (programs[number] == "leave") {
            EXPECT_THAT(row.outcome.message, HasSubstr("status 3"));
        }
        if (programs[number] == "babble") {
            EXPECT_EQ(row.outcome.status, "crashed");
        }
        if (!row.outcome.is_clean()) {
            EXPECT_EQ(row.outcome.file, programs[number]);
        }
    }
}

// Another worker retries the job, because the job may not be the cause.
TEST(WorkerPool, StopsRetryingTerminatedJob) {
    const auto rows = run_all({"a.nc", "ended", "a.nc", "a.nc"}, 2);
    EXPECT_EQ(rows.at(1).outcome.status, "crashed");
    EXPECT_THAT(rows.at(1).outcome.message, HasSubstr("signal 15"));
    for (const std::size_t number : {0U, 2U, 3U}) EXPECT_EQ(rows.at(number).outcome.status, "completed");
}

TEST(WorkerPool, EndsJobAfterTimeout) {
    const auto rows = run_all({"a.nc", "sleep", "a.nc", "a.nc", "sleep", "a.nc"}, 2, 0.5);
    for (const std::size_t number : {0U, 2U, 3U, 5U}) EXPECT_EQ(rows.at(number).outcome.status, "completed");
    for (const std::size_t number : {1U, 4U}) {
        EXPECT_EQ(rows.at(number).outcome.status, "timeout");
        EXPECT_THAT(rows.at(number).outcome.message, HasSubstr("0.5 s"));
    }
}

TEST(WorkerPool, ReportsMissingProgram) {
    WorkerPool pool({.command = {"/no/such/program"}, .workers = 1, .timeout_s = 1});
    const auto given = pool.submit({});
    ASSERT_FALSE(given);
    EXPECT_THAT(given.error().message, HasSubstr("cannot run /no/such/program"));
}

TEST(WorkerPool, EndsWorkersOnDestruction) {
    const auto begun = std::chrono::steady_clock::now();
    {
        WorkerPool pool({.command = {"/bin/sh", "-c", kWorker}, .workers = 2, .timeout_s = 60});
        for (std::size_t number = 0; number < 4; ++number)
            ASSERT_TRUE(pool.submit({.number = number,
                                     .program = "sleep",
                                     .machine = "",
                                     .options = nlohmann::json::object(),
                                     .settings = {}}));
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(20));
}

}  // namespace
}  // namespace gsim::batch::worker_pool_test
