#include "base/toml/toml_json.h"

#include <gtest/gtest.h>

#include "base/text/json.h"

namespace gsim::base {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

TEST(TomlJson, ContainsAllValuesOfDocument) {
    const auto value = toml_json(
        "a = [1, 2.5, true, \"x\"]\nb.c = { d = inf, e = -inf, f = nan }\ng = 1979-05-27\nh = 07:32:00\n"
        "[[i]]\n[[i]]\nj = 1979-05-27T07:32:00Z\n",
        "part.toml");
    ASSERT_TRUE(value) << value.error().message;
    EXPECT_EQ(*value, text::parse_json<json>(
                          R"({"a": [1, 2.5, true, "x"], "b": {"c": {"d": "inf", "e": "-inf", "f": "nan"}},
        "g": "1979-05-27", "h": "07:32:00", "i": [{}, {"j": "1979-05-27T07:32:00Z"}]})"));
    EXPECT_EQ(toml_json("a = 1\nb = = 2\n", "part.toml").error().message.substr(0, 14), "part.toml:2:5:");
}

TEST(TomlJson, WritesValueOnOneLine) {
    const auto written = [](const char* value, TomlNumbers numbers) {
        return toml_value(text::parse_json<ordered_json>(value), numbers);
    };
    EXPECT_EQ(written(R"({"z": 1, "a b": ["x\"\n", true, {}]})", TomlNumbers::as_given),
              R"({ z = 1, "a b" = ["x\"\u000A", true, {}] })");
    EXPECT_EQ(written("[1, 2, 2.5]", TomlNumbers::as_given), "[1.0, 2.0, 2.5]");
    EXPECT_EQ(written("[1, [2]]", TomlNumbers::floats), "[1.0, [2.0]]");
    EXPECT_EQ(written("18446744073709551615", TomlNumbers::as_given), "1.8446744073709552e+19");
    EXPECT_EQ(written("[]", TomlNumbers::floats), "[]");
}

TEST(TomlJson, ReportsValuesInvalidInToml) {
    const auto error = [](const ordered_json& value) { return find_value_error(value).value_or("").message; };
    EXPECT_EQ(error({1, {{"a", "b"}}}), "");
    EXPECT_EQ(error({{"a", {1, nullptr}}}), "TOML has no null; remove the key instead");
    EXPECT_EQ(error("\xff"), "a string is not UTF-8");
    EXPECT_EQ(error({{"\xff", 1}}), "a key is not UTF-8");
    EXPECT_EQ(error(std::numeric_limits<double>::infinity()), "a number is not finite");
    ordered_json deep = 1;
    for (int i = 0; i < 33; ++i) deep = ordered_json::array({deep});
    EXPECT_EQ(error(deep), "lists and objects are nested deeper than 32");
}

TEST(TomlJson, RecognizesNumberFormatBySpelling) {
    for (const char* integer_spelling : {"1", "+12", "-1_000", "0x1e", "0b1", "0o7"})
        EXPECT_EQ(number_format(integer_spelling), TomlNumberFormat::integer_spelling) << integer_spelling;
    for (const char* decimal : {"1.0", "-1e3", "6E2", "inf", "-nan"})
        EXPECT_EQ(number_format(decimal), TomlNumberFormat::decimal) << decimal;
    for (const char* other : {"\"1\"", "'1.5'", "true", "1979-05-27", "07:32:00.5", "1979-05-27 07:32:00"})
        EXPECT_EQ(number_format(other), TomlNumberFormat::other) << other;
}

}  // namespace
}  // namespace gsim::base
