#include "studio/engine/request.h"

#include <gtest/gtest.h>

namespace gsim::studio {
namespace {

using nlohmann::json;

std::string error_message(const json& request_json) {
    const auto request = run_request(request_json);
    return request ? "" : request.error().message;
}

TEST(RunRequest, ReadsRequestOfPage) {
    const auto request = run_request({{"program", "part.nc"},
                                      {"machine", "mine.toml"},
                                      {"dialect", "rs274ngc"},
                                      {"feed_override_percent", 80},
                                      {"blocks", 1000},
                                      {"collisions", false},
                                      {"explain", true}});
    ASSERT_TRUE(request) << request.error().message;
    EXPECT_EQ(request->program, "part.nc");
    EXPECT_EQ(request->machine, "mine.toml");
    EXPECT_EQ(request->language.dialect, "rs274ngc");
    EXPECT_EQ(request->overrides.feed_percent, 80);
    EXPECT_EQ(request->limits.blocks, 1000U);
    EXPECT_FALSE(request->collisions);
    EXPECT_TRUE(request->explain);
}

TEST(RunRequest, ErrorsNameInvalidKey) {
    EXPECT_EQ(error_message({{"programme", "part.nc"}}), "unknown key 'programme' of a run");
    EXPECT_EQ(error_message({{"program", 3}}), "'program' must be a string, not 3");
    EXPECT_EQ(error_message({{"blocks", "many"}}), "'blocks' must be a number, not of type string");
    EXPECT_EQ(error_message({{"blocks", 0}}), "'blocks' must be from 1 to 1000000000000000, not 0");
    EXPECT_EQ(error_message({{"feed_override_percent", 2000}}),
              "'feed_override_percent' must be from 0 to 1000, not 2000");
    EXPECT_EQ(error_message({{"collisions", 1}}), "'collisions' must be true or false, not 1");
    EXPECT_EQ(error_message(json::array()), "a request must be an object");
}

TEST(TranslationRequest, KeepsProgramAndLanguageOfRun) {
    auto request = run_request({{"program", "part.nc"}, {"machine", "mine.toml"}, {"dialect", "rs274ngc"}});
    ASSERT_TRUE(request);
    const engine::TranslationRequest translation = translation_request(*request);
    EXPECT_EQ(translation.program, "part.nc");
    EXPECT_EQ(translation.machine, "mine.toml");
    EXPECT_EQ(translation.language.dialect, "rs274ngc");
}

}  // namespace
}  // namespace gsim::studio
