// Words that stop each controller (docs/stops.md); LinuxCNC stops at them as recorded.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "base/text/json.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::stops_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The letters of the models that stop: LinuxCNC, grbl, blend, ab9.
struct Word {
    std::string_view before, word, stops;
};

constexpr std::string_view kAll = "LGBA";

constexpr Word kNgcWords[] = {
    // Offsets
    {"", "G54", ""},
    {"", "G55", kAll},
    {"", "G59.3", kAll},
    {"", "G92 X0", kAll},
    {"", "G92 X50", "LG"},
    {"", "G92.1", "LG"},
    {"", "G92.2", "L"},
    {"", "G92.3", "L"},
    {"", "G52 X0", "L"},
    {"", "G10 L2 P1 X0", "LG"},
    {"", "G10 L2 P0 X0", "LG"},
    {"", "G10 L2 P1 X5", kAll},
    {"", "G10 L2 P2 X5", "G"},
    {"", "G10 L20 P1 X50", "LG"},
    {"", "G10 L1 P1 Z5", "L"},
    {"", "G28.1", "G"},
    {"", "G30.1", "G"},
    // Lengths of tools
    {"", "G43 H1", "L"},
    {"", "G43 H2", kAll},
    {"", "G43.1 Z0", "L"},
    {"", "G43.2 H1", "L"},
    {"", "G49", "L"},
    {"G43 H2", "G49", kAll},
    // The spindle
    {"", "S2000", "L"},
    {"", "G97 S2000", "L"},
    {"", "G97", ""},
    {"S1000 M3", "S2000", kAll},
    {"S1000 M3", "S1000", "LBA"},
    {"", "M3", kAll},
    {"M3", "M3", "LBA"},
    {"M3", "M4", kAll},
    {"M3", "M5", kAll},
    {"", "M5", "LBA"},
    {"", "M19 R0", kAll},
    // Coolant
    {"", "M7", kAll},
    {"M7", "M7", "LBA"},
    {"", "M8", kAll},
    {"M8", "M8", "LBA"},
    {"M7", "M8", kAll},
    {"M8", "M9", kAll},
    {"", "M9", "LBA"},
    // Stops, tools, inputs and outputs
    {"", "G4 P0", kAll},
    {"", "M0", kAll},
    {"", "M1", "LBA"},
    {"", "M60", kAll},
    {"", "T1", ""},
    {"", "T1 M6", kAll},
    {"", "M61 Q1", "GBA"},
    {"", "M62 P1", ""},
    {"", "M64 P1", kAll},
    {"", "M65 P1", kAll},
    {"", "M66 P0 L0", kAll},
    {"", "M67 E0 Q1", ""},
    {"", "M68 E0 Q1", kAll},
    {"", "M48", ""},
    {"", "M50 P1", ""},
    {"", "M51 P1", ""},
    {"", "M52 P1", "L"},
    {"", "M53 P1", ""},
    // Messages
    {"", "(MSG,x)", "L"},
    {"", "(DEBUG,x)", "L"},
    {"", "(PRINT,x)", ""},
    {"", "(LOG,x)", ""},
    {"", "(x)", ""},
    // Words planned on
    {"", "G17", ""},
    {"", "G21", ""},
    {"", "G40", ""},
    {"", "G98", ""},
    {"", "#1=5", ""},
    {"", "#1=#5420", ""},
    {"", "M73", ""},
};

constexpr Word kAb9Words[] = {
    {"", "G54", ""},       {"", "G55", kAll},   {"", "G92 X50", "LG"},
    {"", "G52 X0", "L"},   {"", "G43 H1", "L"}, {"", "G68 X0 Y0 R0", kAll},
    {"", "S2000", "L"},    {"M3", "M3", "LBA"}, {"", "M5", "LBA"},
    {"M8", "M8", "LBA"},   {"", "M9", "LBA"},   {"", "M7", kAll},
    {"M7", "M7", "LBA"},   {"", "M10", kAll},   {"", "M1", "LBA"},
    {"", "M6", kAll},      {"", "M48", "GBA"},  {"", "T1", ""},
    {"", "#1100=1", kAll}, {"", "G4 P0", kAll}, {"", "(MSG, x)", ""},
    {"", "#1=5", ""},
};

class Stops : public Apps {
  protected:
    double time_s(const std::string& program, const std::string& dialect, const std::string& machine) const {
        write("data.txt", "NCFILE\nTOOL\n1 0 6\n2 5 6\n3 0 6\n4 0 6\n5 0 6\nENDFILE\n");
        const Ended ran = gsim_run({program, "--dialect", dialect, "--machine", machine, "--machine-data",
                                    "data.txt", "--quiet", "--report", "report.json"});
        EXPECT_EQ(ran.status, 0) << ran.err;
        return text::parse_json<json>(read("report.json"))["cycle_time_s"].get<double>();
    }
    std::string make_machine(const std::string& model) const {
        std::string text = read(tests::source_path("samples/machines/linuxcnc-router.toml"));
        const std::string given = "model = \"linuxcnc-2.9\"";
        text.replace(text.find(given), given.size(), fmt::format("model = \"{}\"", model));
        // Words that take time of their own are not stops.
        const std::size_t times = text.find("[times]");
        text.erase(times, text.find("\n\n", times) - times);
        return write(model + ".toml", text);
    }
    mutable std::map<std::string, double>
        passing_s_;  // without a word, by machine, dialect and what is before
    // Returns the time that a word adds, in the middle of a straight path.
    double stop_s(const Word& word, const std::string& dialect, const std::string& machine) const {
        const auto run = [&](std::string_view middle) {
            return time_s(
                write("stop.nc", fmt::format("{}G21 G90 G94\nG64\n{}\nG1 X50 F6000\n{}\nG1 X100\nG1 "
                                             "X120\nM2\n",
                                             dialect == "ab9" ? "O1\n" : "", word.before, middle)),
                dialect, machine);
        };
        const auto [passing, is_new] = passing_s_.try_emplace(machine + std::string(word.before) + dialect);
        if (is_new) passing->second = run("");
        return run(word.word) - passing->second;
    }
    void expect_stops(const Word& word, const std::string& dialect) const {
        static const std::vector<std::pair<char, std::string>> kModels{
            {'L', "linuxcnc-2.9"}, {'G', "grbl-1.1"}, {'B', "blend"}, {'A', "ab9"}};
        std::string stops;
        for (const auto& [letter, model] : kModels) {
            if (stop_s(word, dialect, make_machine(model)) > 0.02) stops += letter;
        }
        EXPECT_EQ(stops, word.stops) << dialect << ": " << word.word << " behind '" << word.before << "'";
    }
};

TEST_F(Stops, EachModelStopsAtItsWords) {
    for (const Word& word : kNgcWords) expect_stops(word, "rs274ngc");
}

TEST_F(Stops, Ab9WordsFollowSameRules) {
    for (const Word& word : kAb9Words) expect_stops(word, "ab9");
}

TEST_F(Stops, MachineFileOverridesRules) {
    const std::string text = read(make_machine("grbl-1.1"));
    const Word message{"", "(MSG,x)", ""};
    EXPECT_LT(stop_s(message, "rs274ngc", make_machine("grbl-1.1")), 0.02);
    const std::string stops = "model = \"grbl-1.1\"\nstops = { \"MSG\" = \"always\" }";
    std::string own = text;
    own.replace(own.find("model = \"grbl-1.1\""), 18, stops);
    EXPECT_GT(stop_s(message, "rs274ngc", write("own.toml", own)), 0.02);
    own.replace(own.find("\"MSG\""), 5, "\"MSGS\"");
    const Ended wrong = gsim_run({"stop.nc", "--machine", write("own.toml", own)});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_TRUE(contains(wrong.err, "unknown key 'MSGS' in [controller.stops]; did you mean 'MSG'?"))
        << wrong.err;
}

/// Returns false for words that take the time of other programs of LinuxCNC, which is not modelled.
bool is_counted(const std::string& word) {
    constexpr std::string_view kNot[] = {"M8", "M9",    // the io program: 30 to 160 ms
                                         "G10 L1",      // the table of tools is written: 60 ms
                                         "M66 P0 L3"};  // its input never came
    return std::none_of(std::begin(kNot), std::end(kNot),
                        [&](std::string_view each) { return word.starts_with(each); });
}

// router_v00 and so on; others are parts.
bool is_of_a_word(std::string_view name) {
    constexpr std::string_view kDigits = "0123456789";
    return (name.starts_with("router_v") || name.starts_with("router_w")) && name.size() == 10 &&
           name.find_first_not_of(kDigits, 8) == std::string_view::npos;
}

std::map<std::string, double> recorded_times(const fs::path& table) {
    std::map<std::string, double> times;
    std::ifstream file(table);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string name;
        double time_s = 0;
        if (words >> name >> time_s) times[name] = time_s;
    }
    return times;
}

// LinuxCNC 2.9 ran each word between two lines: 1.353 s in passing, 1.556 s with a stop.
TEST_F(Stops, MatchRecordedLinuxCncTimes) {
    const char* const reference = std::getenv("GSIM_REFERENCE");
    const fs::path folder = fs::path(reference == nullptr ? "" : reference) / "linuxcnc2";
    if (reference == nullptr || !fs::is_directory(folder)) GTEST_SKIP() << "no recordings in GSIM_REFERENCE";
    constexpr double kWallClock_s = 0.006;
    int counted = 0;
    for (const auto& [name, recorded_s] : recorded_times(folder / "table.tsv")) {
        if (!is_of_a_word(name)) continue;
        const fs::path program = folder / (name + ".ngc");
        std::istringstream lines(read(program.string()));
        std::string word;
        for (int line = 0; line < 4; ++line) std::getline(lines, word);
        if (!is_counted(word)) continue;
        ++counted;
        EXPECT_NEAR(
            time_s(program.string(), "rs274ngc", tests::source_path("samples/machines/linuxcnc-router.toml")),
            recorded_s, kWallClock_s)
            << name << ": " << word;
    }
    EXPECT_GE(counted, 50);
}

}  // namespace
}  // namespace gsim::apps::stops_test
