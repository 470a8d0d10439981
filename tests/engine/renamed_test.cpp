// Names of version 0.1 mean what the new ones mean, for one minor release.
#include "engine/renamed.h"

#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include "engine/gsim.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace gsim::engine::renamed_test {
namespace {

static_assert(std::is_same_v<Failure, Error>);
static_assert(std::is_same_v<Tell, DiagnosticHandler>);
static_assert(std::is_same_v<TakeSegments, SegmentsHandler>);
static_assert(std::is_same_v<DocumentOptions, OutputOptions>);
static_assert(std::is_same_v<CuttingWays, CuttingPathOptions>);

TEST(RenamedNames, FailureIsAliasOfError) {
    const Failure failure{.code = "input-file", .message = "there is no file"};
    const Error& error = failure;
    EXPECT_EQ(error.message, "there is no file");
}

static_assert(std::is_same_v<gsim_take_moves, gsim_on_moves>);
static_assert(GSIM_REFUSED == GSIM_REJECTED && GSIM_MOST_AXES == GSIM_MAX_AXES);

void add_process_on_mm(void* total_mm, const gsim_move* moves, size_t count) {
    for (size_t i = 0; i < count; ++i)
        if (moves[i].jet_on != 0) *static_cast<double*>(total_mm) += moves[i].length_mm;
}

TEST(RenamedNames, CNamesOfVersion01StillWork) {
    gsim_request* request = gsim_request_create();
    const std::string program = "G0 X10\nM8\nG1 X60 F6000\nM9\nG1 X70\nM2\n";
    gsim_request_set_program(request, program.data(), program.size(), "part.nc");
    gsim_run* run = gsim_run_open(request, nullptr, nullptr);
    gsim_request_destroy(request);
    EXPECT_EQ(gsim_run_robots(run), 1U);
    EXPECT_STREQ(gsim_run_robot(run, 0), "");
    double process_on_mm = 0;
    ASSERT_EQ(gsim_run_take_moves(run, 0, add_process_on_mm, &process_on_mm), GSIM_OK);
    ASSERT_EQ(gsim_run_go(run), GSIM_OK);
    EXPECT_NEAR(process_on_mm, 50, 1e-9);
    gsim_run_destroy(run);
}

}  // namespace
}  // namespace gsim::engine::renamed_test
