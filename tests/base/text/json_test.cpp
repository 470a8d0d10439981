#include "base/text/json.h"

#include <sstream>

#include <gtest/gtest.h>

namespace gsim::text {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

TEST(Json, ReadsTextsAndStreams) {
    EXPECT_EQ(parse_json<json>(R"({"b": 1, "a": [2.5]})")["a"][0], 2.5);
    EXPECT_EQ(parse_json<ordered_json>(R"({"b": 1, "a": 2})").begin().key(), "b");
    std::istringstream stream("[1, 2]");
    EXPECT_EQ(parse_json<json>(stream).size(), 2);
}

TEST(Json, ThrowsOrDiscardsInvalidJson) {
    EXPECT_THROW(parse_json<json>("{"), json::parse_error);
    EXPECT_THROW(parse_json<ordered_json>("[1] x"), ordered_json::parse_error);
    EXPECT_TRUE(try_parse_json<json>("{").is_discarded());
    EXPECT_TRUE(try_parse_json<ordered_json>("").is_discarded());
    EXPECT_FALSE(try_parse_json<json>("null").is_discarded());
}

}  // namespace

}  // namespace gsim::text
