#include <gtest/gtest.h>

#include "tests/studio/engine/asked.h"

namespace gsim::studio {
namespace {

constexpr const char* kCell = R"(# A cell.
[cell]
name = "c"
machine = "router.toml"  # beside it

[[object]]
name = "table"
shape = { box_mm = [100.0, 100.0, 10.0] }
)";

TEST(TomlForm, ChangeReturnsCompleteTextAndValue) {
    const auto frames = request_frames(
        R"({"do": "toml", "file": "cell.toml", "changes": [
            {"op": "set", "at": ["cell", "clearance_mm"], "value": 2},
            {"op": "add", "at": ["object"], "value": {"name": "clamp", "shape": {"box_mm": [5, 5, 5]}}},
            {"op": "move", "at": ["object", 1], "to": 0},
            {"op": "remove", "at": ["object", 1, "shape"]}]})",
        {{"cell.toml", kCell}});
    ASSERT_EQ(last(frames).is(), "done") << last(frames).header;
    const Frame response = filter_frames(frames, "toml").at(0);
    EXPECT_EQ(response.columns.at("text"), R"(# A cell.
[cell]
name = "c"
machine = "router.toml"  # beside it
clearance_mm = 2.0

[[object]]
name = "clamp"
shape = { box_mm = [5.0, 5.0, 5.0] }

[[object]]
name = "table"
)");
    EXPECT_EQ(response.header["value"]["object"][1], nlohmann::json({{"name", "table"}}));
    EXPECT_EQ(response.header["value"]["cell"]["clearance_mm"], 2.0);
}

TEST(TomlForm, ReturnsUnchangedFile) {
    const auto frames = request_frames(R"({"do": "toml", "file": "cell.toml"})", {{"cell.toml", kCell}});
    EXPECT_EQ(filter_frames(frames, "toml").at(0).columns.at("text"), kCell);
    EXPECT_EQ(filter_frames(frames, "toml").at(0).header["value"]["cell"]["machine"], "router.toml");
}

TEST(TomlForm, CreatesFileForUnknownName) {
    const auto frames = request_frames(R"({"do": "toml", "file": "new.toml", "changes": [
            {"op": "set", "at": ["machine", "name"], "value": "mine"},
            {"op": "add", "at": ["axis"], "value": {"max_mm": 600, "kind": "linear", "direction": "x", "mine": 1, "letter": "X",
                "frame": {"yaw_deg": 90, "x_mm": 1}}}]})");
    EXPECT_EQ(filter_frames(frames, "toml").at(0).columns.at("text"),
              "[machine]\nname = \"mine\"\n\n[[axis]]\nletter = \"X\"\nkind = \"linear\"\nmax_mm = "
              "600.0\ndirection = \"x\"\n"
              "frame = { x_mm = 1.0, yaw_deg = 90.0 }\nmine = 1.0\n");
}

TEST(TomlForm, ReportsInvalidTomlWithLocation) {
    const auto frames =
        request_frames(R"({"do": "toml", "file": "cell.toml"})", {{"cell.toml", "[cell]\nname = \n"}});
    const auto reported = filter_frames(frames, "diagnostic");
    ASSERT_EQ(reported.size(), 1U);
    EXPECT_EQ(reported[0].header["severity"], "error");
    EXPECT_EQ(reported[0].header["file"], "cell.toml");
    EXPECT_EQ(reported[0].header["line"], 2);
    EXPECT_EQ(reported[0].header["column"], 8);
    EXPECT_EQ(last(frames).is(), "failed");
}

TEST(TomlForm, RejectsInvalidChanges) {
    const auto change_error = [](const std::string& change) {
        return make_error(R"({"do": "toml", "file": "cell.toml", "changes": [)" + change + "]}",
                          {{"cell.toml", kCell}});
    };
    EXPECT_EQ(change_error(R"({"op": "remove", "at": ["object", 1]})"),
              "'object[1]' does not exist and cannot be removed");
    EXPECT_EQ(
        change_error(R"({"op": "remove", "at": ["cell"]}, {"op": "move", "at": ["object", 0], "to": 1})"),
        "change 2: 'object' has 1 elements, from 0 on; index 1 does not exist");
    EXPECT_EQ(change_error("3"), "a change must be an object");
    EXPECT_EQ(change_error(R"({"op": "paint"})"), "'op' must be one of set, add, remove, move");
    EXPECT_EQ(change_error(R"({"op": "set", "at": "cell", "value": 1})"),
              "'at' must be a list of keys and of indices, from 0 on");
    EXPECT_EQ(change_error(R"({"op": "set", "at": ["cell", "name"]})"), "'set' lacks the key 'value'");
    EXPECT_EQ(change_error(R"({"op": "remove", "at": ["cell"], "value": 1})"),
              "unknown key 'value' of 'remove'");
    EXPECT_EQ(change_error(R"({"op": "move", "at": ["object", 0], "to": -1})"),
              "'to' must be an index, from 0 on");
    EXPECT_EQ(make_error(R"({"do": "toml"})"), "toml needs 'file'");
}

TEST(KeysForm, ListsKeysOfFile) {
    const auto frames = request_frames(R"({"do": "keys", "of": "machine"})");
    ASSERT_EQ(last(frames).is(), "done") << last(frames).header;
    const auto tables = filter_frames(frames, "keys").at(0).header["tables"];
    const auto linear = std::find_if(tables.begin(), tables.end(), [](const auto& table) {
        return table["at"] == nlohmann::json({"axis"}) && table["where"]["kind"] == "linear";
    });
    ASSERT_NE(linear, tables.end());
    const auto& keys = (*linear)["keys"];
    const auto speed = std::find_if(keys.begin(), keys.end(),
                                    [](const auto& key) { return key["name"] == "max_speed_mm_s"; });
    ASSERT_NE(speed, keys.end());
    EXPECT_EQ(*speed, nlohmann::json({{"name", "max_speed_mm_s"},
                                      {"kind", "number"},
                                      {"meaning", "max speed"},
                                      {"unit", "mm/s"},
                                      {"above", 0},
                                      {"max", 1e9},
                                      {"or", {"inf"}},
                                      {"default", "inf"}}));
    EXPECT_EQ(make_error(R"({"do": "keys", "of": "mesh"})"),
              "'of' must be one of machine, cell, controller, not 'mesh'");
}

}  // namespace
}  // namespace gsim::studio
