#include "studio/engine/key_reader.h"

#include <gtest/gtest.h>

namespace gsim::studio {
namespace {

using nlohmann::json;

/// All values that can be read from an object.
struct ConsumedKeys {
    std::string text;
    double number = 7;
    std::optional<double> perhaps;
    std::optional<int> read_integer;
    std::optional<std::size_t> word;
    bool boolean = false;
    std::vector<std::string> texts;
    std::vector<double> numbers;
    std::optional<std::array<double, 3>> point;
    std::string error;
};

ConsumedKeys taken(const json& object) {
    ConsumedKeys all;
    KeyReader keys(object, "a thing");
    keys.text("text", all.text);
    keys.number("number", 0, 100, all.number);
    keys.number("perhaps", 0, 100, all.perhaps);
    keys.read_integer("whole", 1, 6, all.read_integer);
    keys.word("word", std::array{"one", "two"}, all.word);
    keys.boolean("truth", all.boolean);
    keys.texts("texts", all.texts);
    keys.numbers("numbers", -9, 9, all.numbers);
    keys.point("point", -9, 9, all.point);
    keys.require("text");
    if (const auto done = keys.end(); !done) all.error = done.error().message;
    return all;
}

TEST(KeyReader, ReadsEachValueByType) {
    const ConsumedKeys all = taken({{"text", "a"},
                                    {"number", 3.5},
                                    {"whole", 3},
                                    {"word", "two"},
                                    {"truth", true},
                                    {"texts", {"b", "c"}},
                                    {"numbers", {1, 2.5}},
                                    {"point", {1, 2, 3}}});
    EXPECT_EQ(all.error, "");
    EXPECT_EQ(all.text, "a");
    EXPECT_EQ(all.number, 3.5);
    EXPECT_FALSE(all.perhaps);
    EXPECT_EQ(all.read_integer, 3);
    EXPECT_EQ(all.word, 1U);
    EXPECT_TRUE(all.boolean);
    EXPECT_EQ(all.texts, (std::vector<std::string>{"b", "c"}));
    EXPECT_EQ(all.numbers, (std::vector<double>{1, 2.5}));
    EXPECT_EQ(all.point, (std::array<double, 3>{1, 2, 3}));
}

TEST(KeyReader, KeepsDefaultOfMissingKey) {
    EXPECT_EQ(taken({{"text", "a"}}).number, 7);
}

TEST(KeyReader, ReportsFirstInvalidKey) {
    EXPECT_EQ(taken({{"text", 3}}).error, "'text' must be a string, not 3");
    EXPECT_EQ(taken({{"number", 101}}).error, "'number' must be from 0 to 100, not 101");
    EXPECT_EQ(taken({{"whole", 7}}).error, "'whole' must be from 1 to 6, not 7");
    EXPECT_EQ(taken({{"whole", 2.5}}).error, "'whole' must be an integer, not 2.5");
    EXPECT_EQ(taken({{"word", "three"}}).error, "'word' must be one of one, two, not 'three'");
    EXPECT_EQ(taken({{"truth", 0}}).error, "'truth' must be true or false, not 0");
    EXPECT_EQ(taken({{"texts", {"a", 1}}}).error, "'texts' must be texts; one is 1");
    EXPECT_EQ(taken({{"numbers", "12"}}).error, "'numbers' must be a list, not of type string");
    EXPECT_EQ(taken({{"numbers", {1, 10}}}).error, "'numbers' must be from -9 to 9; one is 10");
    EXPECT_EQ(taken({{"point", {1, 2}}}).error, "'point' must be three numbers, not 2");
    EXPECT_EQ(taken({{"point", {1, 2, nullptr}}}).error, "'point' must be numbers; one is of type null");
    EXPECT_EQ(taken(json::object()).error, "a thing needs 'text'");
    EXPECT_EQ(taken({{"text", "a"}, {"colour", 1}}).error, "unknown key 'colour' of a thing");
    EXPECT_EQ(taken(3).error, "a thing must be an object, not 3");
}

}  // namespace
}  // namespace gsim::studio
