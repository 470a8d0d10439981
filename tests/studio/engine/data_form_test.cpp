#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/studio/engine/asked.h"

namespace gsim::studio {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string kTools =
    "NCFILE ; of the shop\nOFFSET\n54 200.000 1 2 # left vice\nTOOL\n1  50.8 10 JET # 2 inch\nALIAS\n"
    "JetOn M08\nENDFILE\n";

std::string data_request(const json& changes) {
    return json{{"do", "data"}, {"file", "tools.txt"}, {"changes", changes}}.dump();
}

Frame data_after(const json& changes, const std::string& text = kTools) {
    return filter_frames(request_frames(data_request(changes), {{"tools.txt", text}}), "data").at(0);
}

std::string text_after(const json& changes) {
    return data_after(changes).columns.at("text");
}

std::string tools_with(const std::string& from, const std::string& to) {
    std::string text = kTools;
    return text.replace(text.find(from), from.size(), to);
}

json set_offset(const json& values) {
    return {{"op", "set"}, {"section", "OFFSET"}, {"id", "54"}, {"values", values}};
}

/// Blanks before the text after a changed word keep it in its column.
std::string with_single_blanks(const std::string& text) {
    std::string single;
    std::unique_copy(text.begin(), text.end(), std::back_inserter(single),
                     [](char a, char b) { return a == ' ' && b == ' '; });
    return single;
}

TEST(DataForm, KeepsFileWithoutChanges) {
    const Frame data = data_after(json::array());
    EXPECT_EQ(data.columns.at("text"), kTools);
    const json entries = data.header["entries"];
    EXPECT_EQ(entries["OFFSET"][0],
              (json{{"id", "54"}, {"unit", "metric"}, {"X", 200.0}, {"Y", 1.0}, {"Z", 2.0}}));
    EXPECT_EQ(entries["ALIAS"][0]["CODE"], "M08");
    EXPECT_FALSE(entries.contains("HOME"));
}

TEST(DataForm, ListsFieldsOfSections) {
    const json sections = data_after(json::array()).header["sections"];
    ASSERT_EQ(sections.size(), 9U);
    EXPECT_EQ(sections[0]["name"], "OFFSET");
    EXPECT_EQ(sections[0]["id"], "54 to 59, 59.1 to 59.3, 505 to 599");
    const json& fields = sections[0]["fields"];  // of the machine that is built in
    ASSERT_EQ(fields.size(), 5U);
    EXPECT_EQ(fields[0]["unit"], "length");
    EXPECT_EQ(fields[3]["name"], "B");
    EXPECT_EQ(fields[3]["unit"], "angle");
    EXPECT_EQ(fields[3]["meaning"], "the origin of the frame on axis B, in machine coordinates");
    for (const std::size_t points : {1U, 2U}) {
        const json& name = sections[points]["fields"].back();
        EXPECT_EQ(name["name"], "NAME");
        EXPECT_EQ(name["unit"], "none");
        EXPECT_EQ(name["required"], false);
    }
    const json& walls = sections[7]["fields"];
    EXPECT_EQ(walls[0]["open"], true);
    EXPECT_EQ(walls[6]["choices"], json({"ENTER", "LEAVE"}));
    EXPECT_EQ(walls[8]["max"], 99);
}

TEST(DataForm, ChangesOnlyLineOfEntry) {
    EXPECT_EQ(text_after(json::array({set_offset({{"X", "201.50"}})})), tools_with("200.000", "201.50"));
    const json tool{
        {"op", "set"}, {"section", "TOOL"}, {"id", "1"}, {"values", {{"LENGTH", "2"}}}, {"unit", "inch"}};
    EXPECT_EQ(text_after(json::array({tool})),
              tools_with("50.8 10 JET # 2 inch", "2 0.393700787401575 JET  inch # 2 inch"));
}

TEST(DataForm, SetsNameOfPointAndRejectsDuplicate) {
    const json named{
        {"op", "set"}, {"section", "FIXED"}, {"id", "3"}, {"values", {{"X", "10"}, {"NAME", "CLAMP1"}}}};
    EXPECT_EQ(text_after(json::array({named})),
              tools_with("ENDFILE", "FIXED\n3  10  0  0  NAME=CLAMP1\nENDFILE"));
    EXPECT_EQ(data_after(json::array({named})).header["entries"]["FIXED"][0]["NAME"], "CLAMP1");
    json second = named;
    second["id"] = "4";
    EXPECT_EQ(make_error(data_request(json::array({named, second})), {{"tools.txt", kTools}}),
              "tools.txt: the name CLAMP1 of a fixed point is given twice; first in line 9");
}

TEST(DataForm, KeepsCommentsOverSeveralChanges) {
    const std::string text =
        text_after({set_offset({{"Z", "-7"}}),
                    {{"op", "set"}, {"section", "OFFSET"}, {"id", "55"}, {"values", {{"X", "10"}}}},
                    {{"op", "convert"}, {"unit", "inch"}},
                    {{"op", "reset"}, {"section", "TOOL"}, {"id", "1"}},
                    {{"op", "convert"}, {"unit", "mm"}}});
    EXPECT_EQ(
        with_single_blanks(text),
        "NCFILE ; of the shop\nOFFSET\n54 200 1 -7 metric # left vice\n55 10 0 0 metric\nTOOL\n1 0 0 JET "
        "metric # 2 inch\nALIAS\nJetOn M08\nENDFILE\n");
}

TEST(DataForm, ResetsSectionOrFile) {
    EXPECT_EQ(text_after(json::array({{{"op", "reset_all"}, {"section", "ALIAS"}}})),
              tools_with("JetOn M08\n", ""));
    const json entries = data_after(json::array({{{"op", "reset_all"}}})).header["entries"];
    EXPECT_EQ(entries["OFFSET"][0]["X"], 0);
    EXPECT_EQ(entries["TOOL"][0]["DIAMETER"], 0);
    EXPECT_FALSE(entries.contains("ALIAS"));
}

TEST(DataForm, CreatesDataForUnknownFileName) {
    const std::string request_json =
        json{{"do", "data"}, {"file", "new.txt"}, {"changes", json::array({set_offset({{"X", "1"}})})}}
            .dump();
    const Frame data = filter_frames(request_frames(request_json), "data").at(0);
    EXPECT_EQ(data.columns.at("text"), "NCFILE\nOFFSET\n54  1  0  0\nENDFILE\n");
}

TEST(DataForm, UsesAxesOfMachineOfCell) {
    const Files files{{"tools.txt", "NCFILE\nOFFSET\n54 1 2 3 4\nENDFILE\n"},
                      {"cell.toml", "[cell]\nname = \"c\"\nmachine = \"mill.toml\"\n"},
                      {"mill.toml", sample("machines/mill-head-table.toml")}};
    const auto frames = request_frames(R"({"do": "data", "file": "tools.txt", "cell": "cell.toml"})", files);
    const Frame data = filter_frames(frames, "data").at(0);
    EXPECT_EQ(data.header["entries"]["OFFSET"][0]["B"], 4);
}

TEST(DataForm, WarnsOfSuspiciousEntry) {
    const auto frames =
        request_frames(data_request(json::array()), {{"tools.txt", "NCFILE\nALIAS\nJetOn M9999\nENDFILE\n"}});
    const auto reported = filter_frames(frames, "diagnostic");
    ASSERT_EQ(reported.size(), 1U);
    EXPECT_EQ(reported[0].header["severity"], "warning");
    EXPECT_EQ(reported[0].header["line"], 3);
}

TEST(DataForm, ReportsEachErrorOfInvalidFile) {
    const auto frames =
        request_frames(data_request(json::array()), {{"tools.txt", "NCFILE\nTOOL\n1 a 2\n2 3 b\nENDFILE\n"}});
    EXPECT_EQ(filter_frames(frames, "diagnostic").size(), 2U);
    EXPECT_EQ(filter_frames(frames, "data").size(), 0U);
    EXPECT_EQ(last(frames).is(), "failed");
}

TEST(DataForm, RejectsInvalidChanges) {
    const auto error = [](const json& change) {
        return make_error(data_request(json::array({change})), {{"tools.txt", kTools}});
    };
    EXPECT_EQ(error({{"op", "burn"}}), "'op' must be one of set, reset, reset_all, convert, not 'burn'");
    EXPECT_EQ(error(json::object()), "a change of data needs 'op'");
    EXPECT_EQ(error(7), "a change of data must be an object, not 7");
    EXPECT_EQ(error({{"op", "convert"}, {"unit", "foot"}}), "'unit' must be one of mm, inch, not 'foot'");
    EXPECT_EQ(error({{"op", "reset"}, {"section", "TOOL"}}), "a change of data needs 'id'");
    EXPECT_EQ(error({{"op", "reset_all"}, {"id", "1"}}), "unknown key 'id' of a change of data");
    EXPECT_EQ(error(set_offset({{"X", 10}})), "the value of 'X' must be a string, not 10");
    EXPECT_EQ(error(set_offset({{"X=1 Y", "2"}})), "'X=1 Y' is not the name of a field");
    EXPECT_THAT(error(set_offset({{"Q", "1"}})), HasSubstr("OFFSET has no 'Q'"));
    EXPECT_THAT(error(set_offset({{"X", "ten"}})), HasSubstr("'ten' is not a number"));
    EXPECT_EQ(make_error(R"({"do": "data"})"), "data needs 'file'");
    EXPECT_EQ(make_error(R"({"do": "data", "file": "a", "program": "b"})"), "unknown key 'program' of data");
    EXPECT_EQ(make_error(R"({"do": "data", "file": "a", "cell": 3})"), "'cell' must be a string, not 3");
}

}  // namespace
}  // namespace gsim::studio
