// Names of version 0.1 mean what the new ones mean, for one minor release.
#include "engine/renamed.h"

#include <type_traits>

#include <gtest/gtest.h>

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace gsim::engine::renamed_test {
namespace {

static_assert(std::is_same_v<Failure, Error>);
static_assert(std::is_same_v<Tell, DiagnosticHandler>);
static_assert(std::is_same_v<TakeSegments, SegmentsHandler>);
static_assert(std::is_same_v<DocumentOptions, OutputOptions>);
static_assert(std::is_same_v<CuttingWays, CuttingPathOptions>);

TEST(RenamedNames, AnErrorIsStillAFailure) {
    const Failure failure{.code = "input-file", .message = "there is no file"};
    const Error& error = failure;
    EXPECT_EQ(error.message, "there is no file");
}

}  // namespace
}  // namespace gsim::engine::renamed_test
