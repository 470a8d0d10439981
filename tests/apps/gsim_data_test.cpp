// gsim-data: what the form of a controller does, on the command line.

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::gsim_data_test {
namespace {

using nlohmann::json;

const std::string kData =
    "NCFILE\r\nOFFSET ; frames\r\n54 200.000 1 2 # left\r\n55 1 2 3 inch\r\nTOOL\r\n1 50 10 JET\r\n"
    "ALIAS\r\nJetOn M08\r\nSECURITY\r\n1 0 1 0 1\r\nENDFILE\r\n";

class GsimData : public Apps {
  protected:
    // Runs the command on the data and gives back the file as it is then.
    std::string after(std::vector<std::string> command) {
        write("d.txt", kData);
        command.insert(command.begin(), "d.txt");
        const Ended e = gsim_data(command);
        EXPECT_EQ(e.status, 0) << e.err;
        EXPECT_EQ(files(), 1U) << "nothing is left behind";
        return read("d.txt");
    }

    void expect_refused(std::vector<std::string> command, const std::string& message) {
        write("d.txt", kData);
        command.insert(command.begin(), "d.txt");
        const Ended e = gsim_data(command);
        EXPECT_EQ(e.status, 2);
        EXPECT_EQ(e.err, fmt::format("gsim-data: {}\n", message));
        EXPECT_EQ(read("d.txt"), kData);
    }

    static std::string changed(const std::string& from, const std::string& to) {
        std::string text = kData;
        return text.replace(text.find(from), from.size(), to);
    }

    static std::string machine() { return tests::source_path("samples/machines/af5.toml"); }
};

TEST_F(GsimData, ListsInColumns) {
    write("d.txt", kData);
    const Ended e = gsim_data({"d.txt", "list", "offset"});
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_EQ(e.out,
              "OFFSET\n  ID  X        Y  Z  UNIT\n  54  200.000  1  2  metric\n  55  1        2  3  inch\n");
    const std::string all = gsim_data({"d.txt", "list"}).out;
    EXPECT_TRUE(
        contains(all, "\nTOOL\n  ID  LENGTH  DIAMETER  KIND  UNIT\n  1   50      10        JET   metric\n"))
        << all;
    EXPECT_FALSE(contains(all, "FIXED"));
}

TEST_F(GsimData, GetsValues) {
    write("d.txt", kData);
    EXPECT_EQ(gsim_data({"d.txt", "get", "OFFSET", "54"}).out, "X 200.000\nY 1\nZ 2\nUNIT metric\n");
    EXPECT_EQ(gsim_data({"d.txt", "get", "alias", "JETON", "code"}).out, "M08\n");
    EXPECT_EQ(text::parse_json<json>(gsim_data({"d.txt", "get", "TOOL", "1", "--json"}).out),
              (json{{"id", "1"}, {"unit", "metric"}, {"LENGTH", 50.0}, {"DIAMETER", 10.0}, {"KIND", "JET"}}));
    EXPECT_EQ(gsim_data({"--json", "d.txt", "get", "OFFSET", "54", "X"}).out, "200.0\n");
}

TEST_F(GsimData, SetsOneLine) {
    EXPECT_EQ(after({"set", "OFFSET", "54", "Y=-7.5"}), changed("200.000 1 2", "200.000 -7.5 2"));
    EXPECT_EQ(after({"set", "offset", "55", "x=50.8", "--metric"}),
              changed("1 2 3 inch", "50.8 50.8 76.2 metric"));
    EXPECT_EQ(after({"set", "OFFSET", "505", "Z=1", "--inch"}),
              changed("3 inch\r\n", "3 inch\r\n505  0  0  1  inch\r\n"));
    EXPECT_EQ(after({"set", "OFFSET", "54", "B=30", "--machine", machine()}), changed("1 2 #", "1 2  30 #"));
    EXPECT_EQ(after({"set", "HOME", "2", "X=1"}), changed("ENDFILE", "HOME\r\n2  1  0  0\r\nENDFILE"));
    EXPECT_EQ(after({"set", "TOOL", "1", "kind=cutter", "LENGTH_WEAR=.5"}),
              changed("JET", "CUTTER  LENGTH_WEAR=.5"));
}

TEST_F(GsimData, ResetsEntriesAndSections) {
    EXPECT_EQ(after({"reset", "OFFSET", "54"}), changed("200.000 1 2", "0 0 0"));
    EXPECT_EQ(after({"reset", "ALIAS", "JetOn"}), changed("JetOn M08\r\n", ""));
    EXPECT_EQ(after({"reset-all"}),
              "NCFILE\r\nOFFSET ; frames\r\n54 0 0 0 # left\r\n55 0 0 0 inch\r\nTOOL\r\n1 0 0 JET\r\n"
              "ALIAS\r\nSECURITY\r\nENDFILE\r\n");
    EXPECT_EQ(after({"reset-all", "tool"}), changed("50 10", "0 0"));
}

TEST_F(GsimData, RejectsInvalidCommandWithMessage) {
    expect_refused({"set", "OFFSET", "54", "X=1e12"}, "d.txt: 1e12 must be between -1e9 and 1e9");
    expect_refused({"set", "OFFSET", "53", "X=1"},
                   "d.txt: '53' is not a frame; frames are 54 to 59, 59.1 to 59.3 and 505 to 599");
    expect_refused({"set", "OFFSET", "54", "X"}, "'X' must be FIELD=VALUE");
    expect_refused({"set", "OFSET", "54", "X=1"},
                   "'OFSET' is not a section; known sections: OFFSET, FIXED, REFERENCE, HOME, TOOL, "
                   "VARIABLE, ALIAS, SECURITY, WORKING");
    expect_refused({"set", "SECURITY", "1", "XMIN=3"},
                   "d.txt: Xmin is 3 and Xmax is 1; min must be less than max");
    expect_refused({"get", "OFFSET", "56"}, "OFFSET 56 does not exist in the file");
    expect_refused({"reset", "OFFSET", "56"}, "d.txt: OFFSET 56 does not exist in the file");
    expect_refused({"convert"}, "convert requires --inch, --metric, --json or --from-json FILE");
    EXPECT_EQ(gsim_data({"d.txt"}).status, 2);
    EXPECT_EQ(gsim_data({"d.txt", "set", "OFFSET", "54", "X=1", "--inch", "--metric"}).status, 2);
    EXPECT_EQ(gsim_data({"none.txt", "list"}).err,
              "gsim-data: cannot read 'none.txt': No such file or directory\n");
    for (const char* file : {"none.txt", "."}) EXPECT_EQ(gsim_data({file, "check"}).status, 2) << file;
    EXPECT_EQ(gsim_data({"--help"}).status, 0);
}

TEST_F(GsimData, CreatesFileOnRequest) {
    EXPECT_EQ(gsim_data({"n.txt", "set", "FIXED", "1", "X=1"}).status, 2);
    EXPECT_EQ(gsim_data({"n.txt", "set", "FIXED", "1", "X=1", "--create"}).status, 0);
    EXPECT_EQ(read("n.txt"), "NCFILE\nFIXED\n1  1  0  0\nENDFILE\n");
    EXPECT_EQ(gsim_data({"n.txt", "set", "FIXED", "2", "X=2", "--create"}).status, 0);
    EXPECT_EQ(read("n.txt"), "NCFILE\nFIXED\n1  1  0  0\n2  2  0  0\nENDFILE\n");
}

TEST_F(GsimData, ChecksAllLines) {
    write("d.txt", "NCFILE\nOFFSET\n54 1 2\n53 1 2 3\n55 1 2 3x\nFIXD\n1 2\nTOOL\n1 2\nENDFILE\n");
    const Ended e = gsim_data({"d.txt", "check"});
    EXPECT_EQ(e.status, 1);
    for (const char* where : {"d.txt:3:1: ", "d.txt:4:1: ", "d.txt:5:8: ", "d.txt:6:1: ", "d.txt:9:1: "})
        EXPECT_TRUE(contains(e.err, where)) << where << '\n' << e.err;
    EXPECT_FALSE(contains(e.err, "d.txt:7:")) << "what stands behind a misspelled keyword is in no section\n"
                                              << e.err;
}

TEST_F(GsimData, WarnsOfSuspiciousEntries) {
    write("d.txt",
          "NCFILE\nOFFSET\n54 0 3000 0\nALIAS\nJetOn M08\nTurn G777\nX M3\nWORKING\n1 -1 10 0 10\nSECURITY\n"
          "3 0 1 0 1 off\nENDFILE\n");
    const Ended e = gsim_data({"d.txt", "--machine", machine(), "check"});
    EXPECT_EQ(e.status, 0);
    EXPECT_TRUE(contains(
        e.err, "d.txt:3:6: warning: Y of OFFSET 54 is 3000 mm, outside the machine's range of 0 to 2438.4\n"))
        << e.err;
    EXPECT_TRUE(contains(e.err, "d.txt:6:6: warning: Turn is an alias of 'G777', which is not a word of"))
        << e.err;
    EXPECT_TRUE(contains(e.err, "d.txt:7:3: warning: 'X' is not a valid name of an alias")) << e.err;
    EXPECT_TRUE(contains(e.err, "d.txt:9:3: warning: XMIN of WORKING 1 is -1 mm")) << e.err;
    EXPECT_TRUE(contains(e.err, "d.txt:11:11: warning: zone 3 is off at the start")) << e.err;
    EXPECT_FALSE(contains(e.err, "d.txt:5:")) << e.err;
    const Ended sample = gsim_data({tests::source_path("samples/jet.txt"), "check", "--machine", machine()});
    EXPECT_EQ(sample.status, 0);
    EXPECT_EQ(sample.err, "");
}

TEST_F(GsimData, ConvertsUnits) {
    EXPECT_EQ(after({"convert", "--metric"}), changed("1 2 3 inch", "25.4 50.8 76.2 metric"));
    write("d.txt", kData);
    EXPECT_EQ(gsim_data({"d.txt", "convert", "--inch", "-o", "i.txt"}).status, 0);
    EXPECT_EQ(read("d.txt"), kData);
    EXPECT_EQ(gsim_data({"i.txt", "convert", "--metric"}).status, 0);
    EXPECT_EQ(gsim_data({"i.txt", "get", "OFFSET", "54", "X"}).out, "200\n");
}

TEST_F(GsimData, ConvertsToJsonAndBack) {
    const std::string sample = tests::source_path("samples/jet.txt");
    ASSERT_EQ(gsim_data({sample, "convert", "--json", "-o", "d.json", "--machine", machine()}).status, 0);
    const Ended e = gsim_data({"back.txt", "convert", "--from-json", "d.json", "--machine", machine()});
    ASSERT_EQ(e.status, 0) << e.err;
    EXPECT_EQ(gsim_data({"back.txt", "list", "--json"}).out, gsim_data({sample, "list", "--json"}).out);
    EXPECT_EQ(text::parse_json<json>(read("d.json"))["SECURITY"][1]["ZMAX"], 50.0);
}

TEST_F(GsimData, RejectsInvalidJson) {
    const auto error = [&](const std::string& text) {
        write("j.json", text);
        const Ended e = gsim_data({"back.txt", "convert", "--from-json", "j.json"});
        EXPECT_EQ(e.status, 2);
        EXPECT_FALSE(exists("back.txt"));
        return e.err;
    };
    EXPECT_EQ(error("{"), "gsim-data: j.json: byte 2: this is not valid JSON\n");
    EXPECT_EQ(error("[1e400]"), "gsim-data: j.json: a number is too large: the max is about 1e308\n");
    EXPECT_EQ(error("[]"), "gsim-data: j.json: this must be a JSON object with a list for each section\n");
    EXPECT_EQ(error(R"({"OFSET":[]})"), "gsim-data: j.json: 'OFSET' is not a section\n");
    EXPECT_EQ(error(R"({"OFFSET":[{"X":1}]})"),
              "gsim-data: j.json: an entry of OFFSET must be an object with an \"id\"\n");
    EXPECT_EQ(error(R"({"OFFSET":[{"id":54,"X":"1","Y":1,"Z":1}]})"),
              "gsim-data: j.json: OFFSET 54: X is not a number\n");
    EXPECT_EQ(error(R"({"OFFSET":[{"id":54,"X":1,"Z":1}]})"),
              "gsim-data: j.json: OFFSET 54: Y is missing, but later values are given\n");
    EXPECT_EQ(error(R"({"VARIABLE":[{"id":1,"VALUE":1},{"id":"01","VALUE":1}]})"),
              "gsim-data: j.json: VARIABLE 01: it is given twice\n");
    EXPECT_EQ(error("{\"ALIAS\":[{\"id\":\"Jet\",\"CODE\":\"M8\\nENDFILE\"}]}"),
              "gsim-data: j.json: ALIAS Jet: CODE: 'M8?ENDFILE' must be one word\n");
    EXPECT_EQ(error(std::string(100000, '[')), "gsim-data: j.json: byte 100001: this is not valid JSON\n");
}

TEST_F(GsimData, KeepsFileIfOutputCannotBeWritten) {
    write("d.txt", kData);
    const Ended e = gsim_data({"d.txt", "convert", "--inch", "-o", "no/such/folder.txt"});
    EXPECT_EQ(e.status, 2);
    EXPECT_EQ(e.err, "gsim-data: cannot write 'no/such/folder.txt': No such file or directory\n");
    EXPECT_EQ(read("d.txt"), kData);
    EXPECT_EQ(gsim_data({"d.txt", "convert", "--inch", "-o", "/dev/full"}).status, 2);
    EXPECT_EQ(files(), 1U);
}

TEST_F(GsimData, KeepsLinksAndPermissionsOnSave) {
    write("d.txt", kData);
    std::filesystem::permissions(folder_ / "d.txt", std::filesystem::perms(0640));
    std::filesystem::create_symlink("d.txt", folder_ / "link");
    EXPECT_EQ(gsim_data({"link", "set", "OFFSET", "54", "X=1"}).status, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link"));
    EXPECT_EQ(std::filesystem::status(folder_ / "d.txt").permissions(), std::filesystem::perms(0640));
    EXPECT_NE(read("d.txt"), kData);
}

}  // namespace
}  // namespace gsim::apps::gsim_data_test
