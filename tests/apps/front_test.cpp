// gsim as the front end of the programs, and what all of them report about themselves.

#include <string>
#include <vector>

#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::front_test {
namespace {

class FrontEnd : public Apps {
  protected:
    Ended gsim(const std::vector<std::string>& arguments) const {
        return run_program(tests::program_path("gsim"), arguments, folder_);
    }
    const std::string part_ = write("part.nc", "G0 X100\nG1 X110 F3000\n");
    const std::string wrong_ = write("wrong.nc", "G0 X5000\n");
};

constexpr const char* kPrograms[] = {"gsim-run",   "gsim-check", "gcode2lua",  "autopath",
                                     "path2gcode", "gsim-data",  "gsim-studio"};

TEST_F(FrontEnd, CommandMatchesStandaloneProgram) {
    const Ended by_command = gsim({"run", part_, "--json"});
    const Ended by_name = gsim_run({part_, "--json"});
    EXPECT_EQ(by_command.status, 0);
    EXPECT_EQ(by_command.out, by_name.out);
    EXPECT_EQ(gsim({"gsim-run", part_, "--json"}).out, by_name.out);
    EXPECT_EQ(gsim({"translate", part_}).out, gcode2lua({part_}).out);
}

TEST_F(FrontEnd, SuggestsNearestNameForUnknownWord) {
    const Ended command = gsim({"rum", part_});
    EXPECT_EQ(command.status, 2);
    EXPECT_EQ(command.out, "");
    EXPECT_EQ(command.err, "gsim: unknown command 'rum'; did you mean 'run'?\ngsim: see gsim --help\n");
    const Ended option = gsim({"run", part_, "--machin", "x.toml"});
    EXPECT_EQ(option.status, 2);
    EXPECT_EQ(
        option.err,
        "gsim-run: unknown option '--machin'; did you mean '--machine'?\ngsim-run: see gsim-run --help\n");
    const Ended sub = gsim({"data", "x.txt", "lits"});
    EXPECT_EQ(sub.status, 2);
    EXPECT_TRUE(contains(sub.err, "unexpected argument 'lits'; did you mean 'list'?")) << sub.err;
    EXPECT_FALSE(contains(gsim({"run", "--qqqqqqqqqqqqqq"}).err, "did you mean"));
    EXPECT_EQ(gsim({}).status, 2);
}

TEST_F(FrontEnd, AcceptsOldOptionNameWithWarning) {
    const std::string path =
        write("p.json", R"({"format": 1, "paths": [{"name": "p", "targets": [{"point_mm": [1, 2, 3]}]}]})");
    const auto old_name = gsim({"path2gcode", path, "--go-on", "--post", "grbl"});
    const auto new_name = gsim({"path2gcode", path, "--continue-on-unknown", "--post", "grbl"});
    EXPECT_EQ(old_name.out, new_name.out);
    EXPECT_EQ(old_name.status, new_name.status);
    EXPECT_TRUE(contains(old_name.err, "warning: --go-on is named --continue-on-unknown now"))
        << old_name.err;
    EXPECT_FALSE(contains(new_name.err, "warning")) << new_name.err;
}

TEST_F(FrontEnd, OptionWithManyValuesDoesNotConsumeProgram) {
    const Ended ended = gsim({"run", "--envelope", "reach.csv", part_});
    EXPECT_TRUE(contains(ended.err, "remove part.nc")) << ended.err;
}

TEST_F(FrontEnd, EachProgramHasHelpManualAndVersion) {
    for (const std::string program : kPrograms) {
        const Ended help = gsim({"help", program});
        EXPECT_EQ(help.status, 0) << program;
        EXPECT_TRUE(help.out.starts_with("Usage: " + program + " ")) << help.out;
        EXPECT_TRUE(contains(help.out, "\nExamples:\n")) << program;
        EXPECT_TRUE(contains(help.out, "\nExit status: 0 success")) << program;
        const Ended page = gsim({"manual", program});
        EXPECT_EQ(page.status, 0) << program;
        for (const char* heading :
             {".TH ", ".SH NAME", ".SH SYNOPSIS", ".SH OPTIONS", ".SH EXIT STATUS", ".SH EXAMPLES"})
            EXPECT_TRUE(contains(page.out, heading)) << program << " " << heading;
        const Ended version = gsim({program, "--version"});
        EXPECT_TRUE(version.out.starts_with(program + " ")) << version.out;
        EXPECT_TRUE(contains(version.out, "\nLua 5.4")) << version.out;
    }
}

TEST_F(FrontEnd, GroupsHelpByTask) {
    const std::string help = gsim({"run", "--help"}).out;
    const std::size_t machine = help.find("\nMachine and language:\n");
    const std::size_t results = help.find("\nResults:\n");
    ASSERT_NE(machine, std::string::npos);
    ASSERT_NE(results, std::string::npos);
    EXPECT_GT(help.find("--cell FILE"), machine);
    EXPECT_GT(help.find("--trajectory FILE"), results);
    EXPECT_TRUE(contains(help, "time between samples (1e-06 to 1000000) [0.01]"));
}

TEST_F(FrontEnd, WritesCompletionsForThreeShells) {
    for (const std::string shell : {"bash", "zsh", "fish"}) {
        const Ended script = gsim({"completion", shell});
        EXPECT_EQ(script.status, 0);
        for (const std::string program : kPrograms)
            EXPECT_TRUE(contains(script.out, program)) << shell << " " << program;
        EXPECT_TRUE(contains(script.out, "machine-data")) << shell;
    }
    EXPECT_EQ(gsim({"completion", "tcsh"}).status, 2);
}

TEST_F(FrontEnd, CheckReportsEachProgram) {
    const Ended is_clean = gsim({"check", part_});
    EXPECT_EQ(is_clean.status, 0);
    EXPECT_TRUE(is_clean.out.starts_with("part.nc: no errors, ")) << is_clean.out;
    const Ended both = gsim({"check", wrong_, part_});
    EXPECT_EQ(both.status, 1);
    EXPECT_TRUE(contains(both.out, "wrong.nc:1: error: axis X ")) << both.out;
    EXPECT_TRUE(contains(both.out, "part.nc: no errors")) << both.out;
    const Ended missing = gsim({"check", "nowhere.nc", part_});
    EXPECT_EQ(missing.status, 2);
    EXPECT_TRUE(contains(missing.out, "part.nc: no errors")) << missing.out;
    EXPECT_TRUE(contains(missing.err, "nowhere.nc")) << missing.err;
    EXPECT_EQ(gsim({"check"}).status, 2);
}

TEST_F(FrontEnd, CheckReportsCollisionWithLineAndPair) {
    const std::string cell =
        write("cell.toml",
              "[cell]\nname = \"a post\"\nclearance_mm = 1.0\n"
              "[[object]]\nname = \"post\"\nshape = { box_mm = [20.0, 20.0, 20.0] }\n"
              "frame = { x_mm = 105.0 }\n"
              "[[shape]]\nname = \"tip\"\non = \"tool\"\nshape = { sphere_mm = 10.0 }\n");
    const Ended ended = gsim({"check", "--cell", cell, part_});
    ASSERT_NE(ended.status, 2) << ended.err;
    EXPECT_EQ(ended.status, 1) << ended.out;
    // The rapid of the first line; its near miss with the same body is not reported again.
    EXPECT_TRUE(ended.out.starts_with("part.nc:1: error: collision: 'tip' and 'post' at ")) << ended.out;
    EXPECT_FALSE(contains(ended.out, "near miss: 'tip' and 'post', 0.000 mm")) << ended.out;
}

}  // namespace
}  // namespace gsim::apps::front_test
