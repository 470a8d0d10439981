// docs/path.schema.json knows the keys that the reader knows, and says of each what the reader says.
#include <algorithm>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "base/text/json.h"
#include "tests/build_files/build_files.h"
#include "toolpath/json/json_reader.h"
#include "toolpath/json/keys.h"
#include "toolpath/json/target_draft.h"
#include "toolpath/json/touches.h"

namespace gsim::path::schema_test {
namespace {

using nlohmann::json;

template <typename Range>
std::set<std::string> as_set(const Range& keys) {
    return {keys.begin(), keys.end()};
}

std::set<std::string> keys_of(const json& object) {
    std::set<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.insert(key);
    return keys;
}

json schema() {
    std::ifstream file(tests::source_path("docs/path.schema.json"));
    return text::parse_json<json>(file);
}

TEST(PathSchema, KeysMatchReader) {
    const json all = schema();
    EXPECT_EQ(keys_of(all["properties"]), as_set(kProgramKeys));
    EXPECT_EQ(keys_of(all["$defs"]["path"]["properties"]), as_set(kPathKeys));
    std::set<std::string> targets = keys_of(all["$defs"]["point"]["properties"]);
    for (const char* other : {"sub_path", "machine_point"})
        targets.merge(keys_of(all["$defs"][other]["properties"]));
    EXPECT_EQ(targets, as_set(kTargetKeys));
    EXPECT_EQ(all["$defs"]["point"]["properties"]["motion"]["enum"], json(kMotionNames));
}

TEST(PathSchema, TypesMatchReader) {
    const json all = schema();
    for (std::size_t i = 0; i < kTargetKeys.size(); ++i) {
        const auto key = static_cast<TargetKey>(i);
        const char* const of = key >= TargetKey::path    ? "sub_path"
                               : key >= TargetKey::fixed ? "machine_point"
                                                         : "point";
        const json property = all["$defs"][of]["properties"][std::string(kTargetKeys[i])];
        const std::string type = property.value("type", "string");
        switch (TargetDraft::value_kind(key)) {
            case TargetDraft::ValueKind::text: EXPECT_EQ(type, "string") << kTargetKeys[i]; break;
            case TargetDraft::ValueKind::number:
                EXPECT_TRUE(type == "number" || type == "integer") << kTargetKeys[i];
                break;
            case TargetDraft::ValueKind::text_or_number:
                EXPECT_EQ(property["oneOf"][0]["type"], "string") << kTargetKeys[i];
                EXPECT_EQ(property["oneOf"][1]["type"], "integer") << kTargetKeys[i];
                break;
            case TargetDraft::ValueKind::letters: EXPECT_EQ(type, "object") << kTargetKeys[i]; break;
            default: EXPECT_EQ(type, "array") << kTargetKeys[i];
        }
    }
}

TEST(PathSchema, TouchesMatchReader) {
    const json touch = schema()["$defs"]["touch"];
    EXPECT_EQ(keys_of(touch["properties"]), as_set(kTouchKeys));
    EXPECT_EQ(as_set(touch["required"].get<std::vector<std::string>>()),
              as_set(std::span(kTouchKeys).first(kRequiredTouchKeys)));
    for (std::size_t i = 0; i < kTouchKeys.size(); ++i) {
        const json property = touch["properties"][std::string(kTouchKeys[i])];
        switch (TouchDraft::value_kind(static_cast<TouchKey>(i))) {
            case TouchDraft::ValueKind::text: EXPECT_EQ(property["enum"], (json{"X", "Y", "Z"})); break;
            case TouchDraft::ValueKind::vector: EXPECT_EQ(property["type"], "array"); break;
            case TouchDraft::ValueKind::number:
                EXPECT_TRUE(property["type"] == "number" || property["type"] == "integer") << kTouchKeys[i];
        }
    }
}

TEST(PathSchema, MachinePointNumbersMatchReader) {
    const json all = schema();
    const auto accepted = [](const std::string& key, int number) {
        const json point = {{key, number}};
        return read_json(json{{"paths", {{{"name", "a"}, {"targets", {point}}}}}}.dump(), "f").has_value();
    };
    const json properties = all["$defs"]["machine_point"]["properties"];
    for (const auto& [key, limits] : {std::pair{"fixed", properties["fixed"]["oneOf"][1]},
                                      std::pair{"reference", properties["reference"]["oneOf"][1]}}) {
        EXPECT_TRUE(accepted(key, limits["minimum"])) << key;
        EXPECT_FALSE(accepted(key, limits["minimum"].get<int>() - 1)) << key;
        EXPECT_TRUE(accepted(key, limits["maximum"])) << key;
        EXPECT_FALSE(accepted(key, limits["maximum"].get<int>() + 1)) << key;
    }
}

// The reader accepts what the schema allows at its limits, and no more.
TEST(PathSchema, LimitsMatchReader) {
    const json all = schema();
    const auto accepted = [](const std::string& key, double value) {
        json point = {{"position_mm", {1, 2, 3}}, {"feed_mm_min", 1}};
        point[key] = value;
        return read_json(json{{"paths", {{{"name", "a"}, {"targets", {point}}}}}}.dump(), "f").has_value();
    };
    for (const auto& [key, property] : all["$defs"]["point"]["properties"].items()) {
        if (property.value("type", "") != "number" || key == "turn_deg") continue;
        const double max = property["maximum"];
        EXPECT_TRUE(accepted(key, max)) << key;
        EXPECT_FALSE(accepted(key, 2 * max)) << key;
        EXPECT_EQ(accepted(key, 0), !property.contains("exclusiveMinimum")) << key;
        EXPECT_FALSE(accepted(key, -1)) << key;
    }
}

}  // namespace
}  // namespace gsim::path::schema_test
