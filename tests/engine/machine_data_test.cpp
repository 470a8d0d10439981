#include "engine/machine_data.h"

#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text/json.h"
#include "machine/data/machine_data_sections.h"
#include "tests/build_files/build_files.h"
#include "tests/engine/memory_files.h"

namespace gsim::engine::machine_data_test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using Format = MachineData::Format;

const std::string kData =
    "NCFILE\nOFFSET ; frames\n54 200.000 1 2 # left\n55 1 2 3 inch\nTOOL\n1 50 10 JET\nALIAS\nJetOn M08\n"
    "ENDFILE\n";

MachineData read_machine_data(const std::string& text = kData) {
    return MachineData::read(text, "d.txt").value();
}

std::string changed(const std::string& from, const std::string& to) {
    std::string text = kData;
    return text.replace(text.find(from), from.size(), to);
}

template <typename Value>
std::string rejection(const tl::expected<Value, Error>& done) {
    return done ? "nothing" : done.error().message;
}

const std::vector<std::string> kX = {"X=1"};

TEST(MachineDataValues, KeepTextByteForByte) {
    EXPECT_EQ(read_machine_data().text(), kData);
    EXPECT_EQ(MachineData("new.txt").text(), "NCFILE\nENDFILE\n");
}

TEST(MachineDataValues, AreListedInColumnsAndAsJson) {
    const MachineData data = read_machine_data();
    EXPECT_EQ(data.list(Format::text, "offset"),
              "OFFSET\n  ID  X        Y  Z  UNIT\n  54  200.000  1  2  metric\n  55  1        2  3  inch\n");
    const json all = text::parse_json<json>(data.list(Format::json).value());
    EXPECT_EQ(all["TOOL"], text::parse_json<json>(data.list(Format::json, "TOOL").value()));
    EXPECT_EQ(all["ALIAS"][0]["CODE"], "M08");
    EXPECT_EQ(data.list(Format::json, "HOME"), "[]\n");
}

TEST(MachineDataValues, SectionsMatchRulesAndDocs) {
    const std::vector<MachineData::Section> sections = read_machine_data().sections();
    ASSERT_EQ(sections.size(), machine::kDataSections.size());
    const machine::DataRules rules;
    std::ifstream file(tests::source_path("docs/machine-data.md"));
    const std::string page((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    for (const machine::DataSection each : machine::kDataSections) {
        const MachineData::Section& section = sections[static_cast<std::size_t>(each)];
        EXPECT_EQ(section.name, machine::keyword(each));
        EXPECT_FALSE(section.title.empty());
        EXPECT_THAT(page, HasSubstr("| `" + section.name + "` | " + section.ids + " |"));
        const std::vector<machine::DataField>& fields = rules.of(each).fields;
        ASSERT_EQ(section.fields.size(), fields.size());
        for (std::size_t i = 0; i < fields.size(); ++i) {
            EXPECT_EQ(section.fields[i].name, fields[i].name);
            EXPECT_FALSE(section.fields[i].meaning.empty()) << section.name << ' ' << fields[i].name;
        }
    }
}

TEST(MachineDataValues, FieldsDescribeTheirValues) {
    const std::vector<MachineData::Section> sections = read_machine_data().sections();
    const auto field = [&](std::size_t section, const std::string& name) {
        for (const MachineData::Field& each : sections[section].fields) {
            if (each.name == name) return each;
        }
        return MachineData::Field();
    };
    constexpr std::size_t kTool = 4, kZone = 7;
    EXPECT_EQ(field(kTool, "LENGTH").quantity, MachineData::Quantity::length);
    EXPECT_EQ(field(kTool, "B").quantity, MachineData::Quantity::angle);
    EXPECT_THAT(field(kTool, "KIND").choices, ElementsAre("", "CUTTER", "JET"));
    EXPECT_TRUE(field(kZone, "XMIN").may_be_unlimited);
    EXPECT_TRUE(field(kZone, "XMIN").required);
    EXPECT_FALSE(field(kZone, "ZMIN").required);
    EXPECT_EQ(field(kZone, "SWITCH").max, 99);
    EXPECT_EQ(field(0, "AXIS4").quantity, MachineData::Quantity::unknown);
}

TEST(MachineDataValues, MissingFileGivesEmptyData) {
    Host host;
    host.files = given({{"d.txt", kData}});
    EXPECT_EQ(MachineData::open(host, "d.txt")->text(), kData);
    EXPECT_EQ(MachineData::open(host, "new.txt")->text(), "NCFILE\nENDFILE\n");
    EXPECT_EQ(rejection(MachineData::open(Host(), "/")), "cannot read '/': Is a directory");
}

TEST(MachineDataValues, ReturnsEntryOrValue) {
    const MachineData data = read_machine_data();
    EXPECT_EQ(data.get(Format::text, "OFFSET", "54"), "X 200.000\nY 1\nZ 2\nUNIT metric\n");
    EXPECT_EQ(data.get(Format::text, "alias", "JETON", "code"), "M08\n");
    EXPECT_EQ(data.get(Format::json, "OFFSET", "54", "X"), "200.0\n");
    EXPECT_EQ(data.get(Format::json, "TOOL", "1", "LENGTH_WEAR"), "null\n");
}

TEST(MachineDataValues, ChangeReplacesOnlyWordsOfLine) {
    MachineData data = read_machine_data();
    const std::vector<std::string> y = {"y=-7.5"};
    ASSERT_TRUE(data.set("OFFSET", "54", y));
    EXPECT_EQ(data.text(), changed("200.000 1 2", "200.000 -7.5 2"));
    ASSERT_TRUE(data.reset("OFFSET", "54"));
    EXPECT_EQ(data.text(), changed("200.000 1 2", "0 0 0"));
    data = read_machine_data();
    const std::vector<std::string> x = {"X=50.8"};
    ASSERT_TRUE(data.set("offset", "55", x, LengthUnit::mm));
    EXPECT_EQ(data.text(), changed("1 2 3 inch", "50.8 50.8 76.2 metric"));
}

TEST(MachineDataValues, ResetsAndConvertsAllEntries) {
    MachineData data = read_machine_data();
    ASSERT_TRUE(data.reset_all("tool"));
    EXPECT_EQ(data.text(), changed("50 10", "0 0"));
    ASSERT_TRUE(data.reset_all());
    EXPECT_EQ(data.list(Format::json, "ALIAS"), "[]\n");
    data = read_machine_data();
    ASSERT_TRUE(data.convert(LengthUnit::mm));
    EXPECT_EQ(data.get(Format::text, "OFFSET", "55", "X"), "25.4\n");
}

TEST(MachineDataValues, RejectedChangeKeepsData) {
    MachineData data = read_machine_data();
    const std::vector<std::string> far = {"X=1e12"}, no_value = {"X"};
    EXPECT_EQ(rejection(data.set("OFFSET", "54", far)), "d.txt: 1e12 must be between -1e9 and 1e9");
    EXPECT_EQ(rejection(data.set("OFFSET", "54", no_value)), "'X' must be FIELD=VALUE");
    EXPECT_EQ(rejection(data.set("OFFSET", "53", kX)),
              "d.txt: '53' is not a frame; frames are 54 to 59, 59.1 to 59.3 and 505 to 599");
    EXPECT_EQ(rejection(data.set("OFSET", "54", kX)),
              "'OFSET' is not a section; known sections: OFFSET, FIXED, REFERENCE, HOME, TOOL, VARIABLE, "
              "ALIAS, SECURITY, WORKING");
    EXPECT_EQ(rejection(data.set("ALIAS", "JetOn", kX, LengthUnit::inch)),
              "d.txt: ALIAS has no lengths and therefore no unit");
    EXPECT_EQ(rejection(data.reset("OFFSET", "56")), "d.txt: OFFSET 56 does not exist in the file");
    EXPECT_EQ(rejection(data.get(Format::text, "OFFSET", "56")), "OFFSET 56 does not exist in the file");
    EXPECT_EQ(rejection(data.get(Format::json, "OFFSET", "54", "Q")), "OFFSET has no 'Q'");
    EXPECT_EQ(rejection(data.list(Format::text, "here")).substr(0, 24), "'here' is not a section;");
    EXPECT_EQ(data.text(), kData);
}

TEST(MachineDataValues, ReportsAllInvalidLines) {
    std::vector<std::uint32_t> lines;
    const auto data = MachineData::read("NCFILE\nOFFSET\n53 1 2 3\n55 1 2 3x\nENDFILE\n", "d.txt", nullptr,
                                        [&](const Diagnostic& reported) { lines.push_back(reported.line); });
    ASSERT_FALSE(data);
    EXPECT_THAT(lines, ElementsAre(3, 4));
    EXPECT_TRUE(data.error().in_program);
    EXPECT_EQ(data.error().message,
              "d.txt:3:1: '53' is not a frame; frames are 54 to 59, 59.1 to 59.3 and 505 to 599");
}

TEST(MachineDataValues, JsonRoundTripKeepsData) {
    const MachineData data = read_machine_data();
    const std::string written = data.to_json().value();
    EXPECT_EQ(data.list(Format::json), written);
    const auto repeated = MachineData::from_json(written, "d.json");
    ASSERT_TRUE(repeated) << repeated.error().message;
    EXPECT_EQ(repeated->to_json(), written);
    EXPECT_EQ(rejection(MachineData::from_json("[", "d.json")), "d.json: byte 2: this is not valid JSON");
    EXPECT_EQ(rejection(MachineData::from_json("[]", "d.json")),
              "d.json: this must be a JSON object with a list for each section");
}

TEST(MachineDataValues, PointsKeepTheirNames) {
    const std::string points =
        "NCFILE\nFIXED\n1 0 0 25.4 NAME=CLAMP1\n2 1 2 3\nREFERENCE\n1 4 5 6  NAME=Pallet\nENDFILE\n";
    MachineData data = read_machine_data(points);
    EXPECT_EQ(data.list(Format::text, "FIXED"),
              "FIXED\n  ID  X  Y  Z     NAME    UNIT\n  1   0  0  25.4  CLAMP1  metric\n  2   1  2  3        "
              "     metric\n");
    EXPECT_EQ(data.get(Format::text, "REFERENCE", "1", "NAME"), "Pallet\n");
    const MachineData repeated = MachineData::from_json(data.to_json().value(), "d.json").value();
    EXPECT_EQ(repeated.to_json().value(), data.to_json().value());
    ASSERT_TRUE(data.convert(LengthUnit::inch));
    EXPECT_EQ(data.get(Format::text, "FIXED", "1"), "X 0\nY 0\nZ 1\nNAME CLAMP1\nUNIT inch\n");
    ASSERT_TRUE(data.reset("FIXED", "1"));
    EXPECT_EQ(data.get(Format::text, "FIXED", "1"), "X 0\nY 0\nZ 0\nNAME CLAMP1\nUNIT inch\n");
    const std::vector<std::string> taken = {"NAME=clamp1"}, none = {"NAME="};
    EXPECT_EQ(rejection(data.set("FIXED", "2", taken)),
              "d.txt: the name clamp1 of a fixed point is given twice; first in line 3");
    EXPECT_TRUE(data.set("REFERENCE", "1", taken)) << "the other section has names of its own";
    EXPECT_TRUE(data.set("FIXED", "1", none));
    EXPECT_EQ(data.get(Format::json, "FIXED", "1", "NAME"), "null\n");
}

TEST(MachineDataValues, RejectsDuplicateOrInvalidNamesInJson) {
    const auto error = [](const std::string& entries) {
        return rejection(MachineData::from_json("{\"FIXED\":[" + entries + "]}", "d.json"));
    };
    EXPECT_EQ(error(R"({"id":1,"X":0,"Y":0,"Z":0,"NAME":"A"},{"id":2,"X":0,"Y":0,"Z":0,"NAME":"a"})"),
              "d.json: FIXED 2: its NAME is already used by another entry");
    EXPECT_EQ(error(R"({"id":1,"X":0,"Y":0,"Z":0,"NAME":"1"})"),
              "d.json: FIXED 1: '1' is not a valid name: a letter first, then letters, digits and '_'");
    EXPECT_EQ(error(R"({"id":1,"X":0,"Y":0,"Z":0,"NAME":1})"), "d.json: FIXED 1: NAME is not a string");
}

TEST(MachineDataValues, RejectsNonUtf8WordsInJson) {
    const MachineData data = read_machine_data("NCFILE\nALIAS\nJet\xff M08\nENDFILE\n");
    EXPECT_EQ(rejection(data.to_json()), "d.txt: JSON must be UTF-8, but a word in this file is not");
    EXPECT_EQ(text::parse_json<json>(data.list(Format::json).value())["ALIAS"][0]["id"], "Jet\uFFFD");
}

TEST(MachineDataValues, MachineGivesAxisNamesAndRanges) {
    const Machine machine = Machine::read({}).value();
    const std::string text = "NCFILE\nOFFSET\n54 0 0 9e6\nALIAS\nTurn G777\nENDFILE\n";
    MachineData data = MachineData::read(text, "d.txt", &machine).value();
    const std::vector<Diagnostic> lint_warnings = data.lint_warnings();
    ASSERT_EQ(lint_warnings.size(), 2U);
    EXPECT_EQ(lint_warnings[0].severity, Severity::warning);
    EXPECT_EQ(lint_warnings[0].line, 3U);
    EXPECT_EQ(lint_warnings[0].column, 8U);
    EXPECT_THAT(lint_warnings[0].text,
                testing::StartsWith("Z of OFFSET 54 is 9000000 mm, outside the machine's range of 0 to "));
    EXPECT_THAT(lint_warnings[1].text,
                testing::StartsWith("Turn is an alias of 'G777', which is not a word of "));
    const std::vector<std::string> b = {"B=30"};
    EXPECT_TRUE(data.set("OFFSET", "54", b));
    EXPECT_EQ(rejection(MachineData("d.txt").set("OFFSET", "54", b)),
              "d.txt: OFFSET has no 'B'; it has X, Y, Z, AXIS4, AXIS5, AXIS6, AXIS7, AXIS8, AXIS9");
    EXPECT_EQ(MachineData::read(text, "d.txt")->lint_warnings().size(), 1U) << "no ranges are known";
}

}  // namespace
}  // namespace gsim::engine::machine_data_test
