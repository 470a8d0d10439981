// A document returns the bytes it was read from, and a change affects its own line alone.
#include "machine/data/machine_data_document.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/file/machine_file.h"

namespace gsim::machine::machine_data_document_test {
namespace {

const std::string kFile =
    "; the fixtures\r\nNCFILE  # of the jet\r\n\r\nOFFSET\r\n  54   200.000  1e2  +3     # left vice\r\n"
    "  505  1  2.50  0  Inch\r\n...\r\n\r\n# points\r\nFIXED\r\n1 0 0 300\r\nTOOL\r\n1\t50.8\t10\tJET\r\n"
    "ALIAS\r\nWaterJetOn M08\r\nSECURITY\r\n1 0 10 0 10\r\nVARIABLE\r\n500 1\r\nENDFILE\r\n\r\n; end";

std::vector<Axis> axes() {
    return read_machine(built_in_machine_toml(), "").value().axes;
}

MachineDataDocument read(const std::string& text) {
    auto document = MachineDataDocument::read(text, "m.txt", axes());
    return document ? *document : throw std::runtime_error(document.error().front().message);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

// Expects that `change` turns this part of the file into that, and changes no other part.
template <typename Change>
void expect_change(const std::string& from, const std::string& to, Change change) {
    MachineDataDocument document = read(kFile);
    const Result<void> changed = change(document);
    ASSERT_TRUE(changed) << changed.error().message;
    EXPECT_EQ(document.text(), replaced(kFile, from, to));
}

template <typename Change>
void expect_refused(const std::string& message, Change change) {
    MachineDataDocument document = read(kFile);
    const MachineData data = document.data();
    const Result<void> changed = change(document);
    ASSERT_FALSE(changed);
    EXPECT_EQ(changed.error().message, message);
    EXPECT_EQ(document.text(), kFile);
    EXPECT_EQ(document.data(), data);
}

TEST(MachineDataDocument, ReturnsOriginalBytes) {
    for (const std::string& text :
         {kFile, std::string("NCFILE\nENDFILE"), std::string("\n\nNCFILE\r\nENDFILE\n\n")})
        EXPECT_EQ(read(text).text(), text);
    EXPECT_EQ(MachineDataDocument().text(), "NCFILE\nENDFILE\n");
}

TEST(MachineDataDocument, RowsKeepWrittenText) {
    const MachineDataDocument document = read(kFile);
    const std::vector<DataRow> rows = document.rows(DataSection::offset);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].values, (std::vector<std::string>{"200.000", "1e2", "+3", "", ""}));
    EXPECT_EQ(rows[1].unit, LengthUnit::inch);
    EXPECT_EQ(document.find(DataSection::alias, "WATERJETON")->values[0], "M08");
    EXPECT_FALSE(document.find(DataSection::offset, "55"));
    const auto location = document.location(DataSection::offset, "54", 1);
    EXPECT_EQ(location.line, 5U);
    EXPECT_EQ(location.column, 17U);
}

TEST(MachineDataDocument, EqualValueKeepsDigits) {
    expect_change("", "", [](auto& d) {
        return d.set(DataSection::offset, "54", {{"X", "200"}, {"Y", "100"}});
    });
    expect_change("1e2", "7  ", [](auto& d) { return d.set(DataSection::offset, "54", {{"Y", "7"}}); });
}

TEST(MachineDataDocument, WordsAfterChangeKeepColumns) {
    expect_change("+3     #", "-30.25 #", [](auto& d) {
        return d.set(DataSection::offset, "54", {{"Z", "-30.25"}});
    });
    expect_change("+3     #", "-1234567.5 #", [](auto& d) {
        return d.set(DataSection::offset, "54", {{"Z", "-1234567.5"}});
    });
}

TEST(MachineDataDocument, AppendsAdditionalValues) {
    expect_change("0  Inch", "0  0  45  Inch", [](auto& d) {
        return d.set(DataSection::offset, "505", {{"C", "45"}});
    });
    expect_change("JET", "JET  LENGTH_WEAR=0.5", [](auto& d) {
        return d.set(DataSection::tool, "1", {{"LENGTH_WEAR", "0.5"}});
    });
    expect_change("JET", "CUTTER", [](auto& d) {
        return d.set(DataSection::tool, "1", {{"KIND", "cutter"}});
    });
    expect_change("0 10 0 10\r\nV", "0 10 0 10  -5  5  LEAVE\r\nV", [](auto& d) {
        return d.set(DataSection::security, "1", {{"ZMAX", "5"}, {"ZMIN", "-5"}, {"KIND", "LEAVE"}});
    });
}

TEST(MachineDataDocument, SetsAndRemovesNamesOfPoints) {
    expect_change("1 0 0 300\r\n", "1 0 0 300  NAME=Vise\r\n", [](auto& d) {
        return d.set(DataSection::fixed, "1", {{"NAME", "Vise"}});
    });
    expect_change("1 0 0 300\r\n", "1 0 0 11.81102362204724  NAME=Vise  inch\r\n", [](auto& d) {
        return d.set(DataSection::fixed, "1", {{"NAME", "Vise"}}, LengthUnit::inch);
    });
    expect_change("1 0 0 300\r\n", "1 0 0 300  45  NAME=VISE\r\n7  1  0  0  NAME=B\r\n", [](auto& d) {
        const Result<void> named = d.set(DataSection::fixed, "1", {{"NAME", "Vise"}});
        const Result<void> turned = d.set(DataSection::fixed, "1", {{"B", "45"}, {"NAME", "VISE"}});
        EXPECT_TRUE(named && turned);
        return d.set(DataSection::fixed, "7", {{"X", "1"}, {"NAME", "B"}});
    });
    expect_change("1 0 0 300\r\n", "1 0 0 0    NAME=Vise\r\n", [](auto& d) {
        EXPECT_TRUE(d.set(DataSection::fixed, "1", {{"NAME", "Vise"}}));
        return d.reset(DataSection::fixed, "1");
    });
    expect_change("", "", [](auto& d) {
        EXPECT_TRUE(d.set(DataSection::fixed, "1", {{"NAME", "Vise"}}));
        return d.set(DataSection::fixed, "1", {{"NAME", ""}});
    });
    MachineDataDocument document = read("NCFILE\nFIXED\n1 0 0 0 NAME=Vise\nENDFILE\n");
    const Result<void> same = document.set(DataSection::fixed, "2", {{"NAME", "VISE"}});
    ASSERT_FALSE(same);
    EXPECT_EQ(same.error().message, "the name VISE of a fixed point is given twice; first in line 3");
}

TEST(MachineDataDocument, ConvertsEntryToRequestedUnit) {
    expect_change("1  2.50  0  Inch", "25.4 63.5  7  metric", [](auto& d) {
        return d.set(DataSection::offset, "505", {{"Z", "7"}}, LengthUnit::metric);
    });
    expect_change("1\t50.8\t10\tJET", "1\t2\t0.25\tJET  inch", [](auto& d) {
        return d.set(DataSection::tool, "1", {{"DIAMETER", "0.25"}}, LengthUnit::inch);
    });
    expect_refused("VARIABLE has no lengths and therefore no unit", [](auto& d) {
        return d.set(DataSection::variable, "500", {{"VALUE", "1"}}, LengthUnit::inch);
    });
}

TEST(MachineDataDocument, AppendsNewEntriesToTheirSection) {
    expect_change("...\r\n", "...\r\n55  0  5  0\r\n", [](auto& d) {
        return d.set(DataSection::offset, "55", {{"Y", "5"}});
    });
    expect_change("1 0 0 300\r\n", "1 0 0 300\r\n7  1  0  0  inch\r\n", [](auto& d) {
        return d.set(DataSection::fixed, "7", {{"X", "1"}}, LengthUnit::inch);
    });
    expect_change("ENDFILE", "WORKING\r\n1  0  10  -  -\r\nENDFILE", [](auto& d) {
        return d.set(DataSection::working, "1", {{"XMIN", "0"}, {"XMAX", "10"}});
    });
}

TEST(MachineDataDocument, ResetsAndErasesEntries) {
    expect_change("1  2.50  0  Inch", "0  0     0  Inch",
                  [](auto& d) { return d.reset(DataSection::offset, "505"); });
    expect_change("WaterJetOn M08\r\n", "",
                  [](auto& d) { return d.reset(DataSection::alias, "waterjeton"); });
    expect_change("1 0 10 0 10\r\n", "", [](auto& d) { return d.reset_all(DataSection::security); });
    expect_change("500 1\r\n", "", [](auto& d) { return d.erase(DataSection::variable, "500"); });
    MachineDataDocument all = read(kFile);
    ASSERT_TRUE(all.reset_all(DataSection::offset));
    for (const auto& [code, values] : all.data().offsets) {
        for (const auto& [letter, value] : values) EXPECT_EQ(value, 0) << code << letter;
    }
}

TEST(MachineDataDocument, RejectsInvalidChanges) {
    const auto set = [](DataSection section, const char* id, const char* field, const std::string& value) {
        return [=](auto& d) { return d.set(section, id, {{field, value}}); };
    };
    expect_refused("'3,5' is not a number", set(DataSection::offset, "54", "X", "3,5"));
    expect_refused("1e12 must be between -1e9 and 1e9", set(DataSection::offset, "54", "X", "1e12"));
    expect_refused("'60' is not a frame; frames are 54 to 59, 59.1 to 59.3 and 505 to 599",
                   set(DataSection::offset, "60", "X", "1"));
    expect_refused("OFFSET has no 'Q'; it has X, Y, Z, B, C", set(DataSection::offset, "54", "Q", "1"));
    expect_refused("'1 2' cannot be written: it must be a single word",
                   set(DataSection::offset, "54", "X", "1 2"));
    expect_refused("'M8?ENDFILE' cannot be written: it must be a single word",
                   set(DataSection::alias, "WaterJetOn", "CODE", "M8\nENDFILE"));
    expect_refused("Xmin is 20 and Xmax is 10; min must be less than max",
                   set(DataSection::security, "1", "XMIN", "20"));
    expect_refused("an alias needs its name and its code", set(DataSection::alias, "JetOff", "CODE", ""));
    expect_refused("a home position also needs a value for B: its values are positional",
                   set(DataSection::home, "2", "C", "1"));
    expect_refused("OFFSET 55 does not exist in the file",
                   [](auto& d) { return d.reset(DataSection::offset, "55"); });
}

TEST(MachineDataDocument, RejectsKeywordOrCommentAsAlias) {
    for (const char* name : {"OFFSET", "ENDFILE", "a b", "#x", "", "x\ny"}) {
        MachineDataDocument document = read(kFile);
        EXPECT_FALSE(document.set(DataSection::alias, name, {{"CODE", "M8"}})) << name;
        EXPECT_EQ(document.text(), kFile) << name;
    }
}

TEST(MachineDataDocument, ConvertsAllEntriesToOneUnit) {
    MachineDataDocument document =
        read("NCFILE\nOFFSET\n54 1 0.5 -2 90 # left\n55 38.1 0 0 metric\nTOOL\n1 254 0 jet\nENDFILE\n");
    const MachineData data = document.data();
    ASSERT_TRUE(document.convert(LengthUnit::inch));
    EXPECT_EQ(document.text(),
              "NCFILE\nOFFSET\n54 0.0393700787401575 0.01968503937007874 -0.078740157480315 90  inch # left\n"
              "55 1.5 0 0 inch\nTOOL\n1 10 0 jet  inch\nENDFILE\n");
    EXPECT_NEAR(document.data().offsets.at("54").at('Z'), -2, 1e-12);
    EXPECT_EQ(document.data().offsets.at("54").at('B'), 90);
    ASSERT_TRUE(document.convert(LengthUnit::metric));
    EXPECT_EQ(document.data(), data);
}

TEST(MachineDataDocument, RejectsConversionOfUnknownAxesWithoutMachine) {
    auto document = MachineDataDocument::read("NCFILE\nOFFSET\n54 1 2 3 90\nENDFILE\n", "m.txt").value();
    EXPECT_FALSE(document.convert(LengthUnit::inch));
    ASSERT_TRUE(document.set(DataSection::offset, "54", {{"AXIS4", "45"}}));
    EXPECT_EQ(document.text(), "NCFILE\nOFFSET\n54 1 2 3 45\nENDFILE\n");
}

TEST(MachineDataDocument, UpdateFromRunChangesOnlyAffectedLines) {
    MachineDataDocument document = read(kFile);
    MachineData data = document.data();
    data.offsets["54"]['X'] = 201.5;
    data.offsets["54"]['C'] = 0;  // equivalent to none
    data.offsets["505"]['Y'] = 25.4;
    data.offsets["59.3"] = {{'X', 0.1}, {'B', 0}, {'C', 30}};
    data.tools[1].length_wear_mm = -0.25;
    data.variables.clear();
    ASSERT_TRUE(document.update(data));
    std::string expected_value = replaced(kFile, "200.000", "201.5  ");
    expected_value = replaced(expected_value, "2.50", "1   ");
    expected_value = replaced(expected_value, "...\r\n", "...\r\n59.3  0.1  0  0  0  30\r\n");
    expected_value = replaced(expected_value, "JET", "JET  LENGTH_WEAR=-0.25");
    expected_value = replaced(expected_value, "500 1\r\n", "");
    EXPECT_EQ(document.text(), expected_value);
    data.offsets["54"]['X'] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(document.update(data).error().message, "'inf' is not a number");
    EXPECT_EQ(document.text(), expected_value);
}

}  // namespace
}  // namespace gsim::machine::machine_data_document_test
