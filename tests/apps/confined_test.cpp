// Limits of a run's access to the system after its programs run, tested by a library that simulates a
// security hole in Lua.

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "base/os/confinement.h"
#include "tests/apps/output_options.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::confined_test {
namespace {

namespace fs = std::filesystem;

class Confinement : public Apps {
  protected:
    Confinement() {
        fs::create_directory(folder_ / "here");
        fs::create_directory(folder_ / "out");
        fs::create_directory(folder_ / "elsewhere");
        write("here/part.nc", "G0 X10\nM98 P7\nM30\n");
        write("here/O0007.nc", "G1 X20 F600\nM99\n");
        write("elsewhere/secret", "secret");
    }

    /// Tries names while a program runs.
    Ended escape(const std::string& names, std::vector<std::string> arguments) const {
        arguments.insert(
            arguments.begin(),
            {fmt::format("LD_PRELOAD={}", tests::build_path("lib/test_modules/libgsim_escape.so")),
             "GSIM_ESCAPE=" + names, tests::program_path("gsim-run")});
        return run_program("/usr/bin/env", arguments, folder_);
    }
    /// Runs the same test with any program, when it opens a file with `at` in its name.
    Ended escape_at(const std::string& at, const std::string& names,
                    std::vector<std::string> arguments) const {
        arguments.insert(
            arguments.begin(),
            {fmt::format("LD_PRELOAD={}", tests::build_path("lib/test_modules/libgsim_escape.so")),
             "GSIM_ESCAPE_AT=" + at, "GSIM_ESCAPE=" + names, tests::program_path("gsim")});
        return run_program("/usr/bin/env", arguments, folder_);
    }
    void expect_confined(const std::string& at, std::vector<std::string> arguments) const {
        const std::string secret = path("elsewhere/secret"), other = path("elsewhere/new");
        const std::string names = fmt::format("r:{} w:{}", secret, other);
        SCOPED_TRACE(arguments.front());
        const Ended confined = escape_at(at, names, arguments);
        EXPECT_EQ(confined.status, 0) << confined.err;
        arguments.insert(arguments.begin() + 1, "--no-confine");
        const Ended open = escape_at(at, names, arguments);
        EXPECT_EQ(open.status, 0) << open.err;
        EXPECT_TRUE(contains(open.err, "r:" + secret + ": reached")) << open.err;
        fs::remove(other);
        if (contains(confined.err, "r:" + secret + ": reached"))
            GTEST_SKIP() << "this system confines no process";
        EXPECT_TRUE(contains(confined.err, "r:" + secret + ": Permission denied")) << confined.err;
        EXPECT_TRUE(contains(confined.err, "w:" + other + ": Permission denied")) << confined.err;
    }
    std::string path(const char* name) const { return (folder_ / name).string(); }
};

#ifdef GSIM_SANITIZED
#define GSIM_SKIP_WITH_SANITIZER GTEST_SKIP() << "a sanitizer wants to be loaded first"
#else
#define GSIM_SKIP_WITH_SANITIZER
#endif

TEST_F(Confinement, BlocksOtherFilesForHoleInLua) {
    GSIM_SKIP_WITH_SANITIZER;
    const std::string names = fmt::format("r:{} w:{} r:/etc/passwd r:{} w:{}", path("elsewhere/secret"),
                                          path("elsewhere/new"), path("here/part.nc"), path("here/part.nc"));
    const Ended open = escape(names, {"--no-confine", "--moves", "out/m.jsonl", "here/part.nc"});
    EXPECT_EQ(open.status, 0) << open.err;
    EXPECT_TRUE(contains(open.err, path("elsewhere/secret") + ": reached")) << open.err;
    fs::remove(folder_ / "elsewhere" / "new");

    const Ended confined = escape(names, {"--moves", "out/m.jsonl", "here/part.nc"});
    EXPECT_EQ(confined.status, 0) << confined.err;
    if (contains(confined.err, path("elsewhere/secret") + ": reached"))
        GTEST_SKIP() << "this system confines no process";
    EXPECT_TRUE(contains(confined.err, "r:" + path("elsewhere/secret") + ": Permission denied"));
    EXPECT_TRUE(contains(confined.err, "w:" + path("elsewhere/new") + ": Permission denied"));
    EXPECT_TRUE(contains(confined.err, "r:/etc/passwd: Permission denied")) << confined.err;
    EXPECT_TRUE(contains(confined.err, "r:" + path("here/part.nc") + ": reached"))
        << "programs are looked up there";
    EXPECT_TRUE(contains(confined.err, "w:" + path("here/part.nc") + ": Permission denied")) << confined.err;
    EXPECT_FALSE(exists("elsewhere/new"));
    EXPECT_TRUE(exists("out/m.jsonl")) << "what was asked for is written";
}

/// The module may access anything, in its own process.
TEST_F(Confinement, AppliesWithModuleInSeparateProcess) {
    GSIM_SKIP_WITH_SANITIZER;
    const std::string names = "r:" + path("elsewhere/secret");
    const Ended standalone = escape(names, {"here/part.nc"});
    if (contains(standalone.err, "reached")) GTEST_SKIP() << "this system confines no process";
    const Ended module_run = escape(names, {"--rcs", tests::default_module_path(), "here/part.nc"});
    EXPECT_EQ(module_run.status, 0) << module_run.err;
    EXPECT_TRUE(contains(module_run.err, names + ": Permission denied")) << module_run.err;
    const Ended within =
        escape(names, {"--rcs", tests::default_module_path(), "--rcs-in-process", "here/part.nc"});
    EXPECT_EQ(within.status, 0) << within.err;
    EXPECT_TRUE(contains(within.err, names + ": reached")) << within.err;
}

TEST_F(Confinement, BlocksOtherFilesForHolesInReaders) {
    GSIM_SKIP_WITH_SANITIZER;
    write(
        "here/part.svg",
        R"(<svg width="20mm" height="20mm" viewBox="0 0 20 20"><rect x="2" y="2" width="9" height="9"/></svg>)");
    expect_confined("/out/", {"translate", "here/part.nc", "-o", path("out/part.lua")});
    expect_confined("part.svg", {"autopath", "here/part.svg", "--speed", "400", "--kerf", "1", "--at", "100",
                                 "100", "0", "-o", "out/p.json"});
    expect_confined("p.json", {"path2gcode", "out/p.json", "-o", "out/p.nc"});
    expect_confined("part.nc", {"check", "here/part.nc"});
    expect_confined("part.nc", {"run", "--moves", "out/m.jsonl", "here/part.nc"});
    expect_confined("data.txt", {"data", "out/data.txt", "set", "OFFSET", "54", "X=1", "--create"});
    expect_confined("data.txt", {"data", "out/data.txt", "convert", "--json", "-o", "out/data.json"});
    expect_confined("data.json", {"data", "out/new.txt", "convert", "--from-json", "out/data.json"});
    write("here/tool.tbl", "T1 P1 Z10 D5\n");
    expect_confined("tool.tbl", {"data", "import", "here/tool.tbl", "-o", "out/tools.txt"});
    EXPECT_TRUE(exists("out/part.lua"));
    EXPECT_TRUE(exists("out/p.nc"));
}

TEST_F(Confinement, AllowsCellFilesInAnyFolder) {
    GSIM_SKIP_WITH_SANITIZER;
    write("elsewhere/block.stl",
          "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
          "0\nendloop\nendfacet\n"
          "endsolid a\n");
    write("here/cell.toml",
          "[cell]\nname = \"c\"\n[[object]]\nname = \"far\"\nrole = \"fixture\"\n"
          "shape = { mesh = \"../elsewhere/block.stl\" }\nframe = { x_mm = 900, y_mm = 900, z_mm = 500 }\n");
    write("here/second.nc", "G0 X5\n");
    expect_confined("part.nc", {"check", "--cell", "here/cell.toml", "here/part.nc", "here/second.nc"});
}

TEST_F(Confinement, AllowsCalledProgramsAndAllOutputs) {
    std::vector<std::string> options = output_options();
    options.insert(options.end(), {"--sarif", "--variables", "--save-machine-data"});
    std::vector<std::string> command = {"here/part.nc"};
    for (const std::string& option : options)
        command.insert(command.end(), {option, file_of_option(option, "out/")});
    const Ended ended = gsim_run(command);
    EXPECT_EQ(ended.status, 0) << ended.err;
    for (const std::string& option : options) EXPECT_TRUE(exists(file_of_option(option, "out/"))) << option;
    EXPECT_TRUE(contains(read("out/report"), "O0007.nc"));
}

TEST_F(Confinement, AllowsImportOfToolTableInAnyFolder) {
    write("elsewhere/mill.tbl", "T1 P1 Z10 D5\n");
    std::string ini =
        "[TRAJ]\nCOORDINATES = X Y Z\nLINEAR_UNITS = mm\n[KINS]\nJOINTS = 3\n"
        "[EMCIO]\nTOOL_TABLE = ../elsewhere/mill.tbl\n";
    for (const int joint : {0, 1, 2}) {
        ini += fmt::format(
            "[JOINT_{}]\nTYPE = LINEAR\nMIN_LIMIT = -100\nMAX_LIMIT = 100\nMAX_VELOCITY = 50\n"
            "MAX_ACCELERATION = 500\n",
            joint);
    }
    write("here/mill.ini", ini);
    const Ended ended =
        run_program(tests::program_path("gsim-data"),
                    {"import", "here/mill.ini", "-o", "out/mill.toml", "--data", "out/mill.txt"}, folder_);
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_TRUE(contains(read("out/mill.txt"), "TOOL")) << read("out/mill.txt");
}

TEST_F(Confinement, WritesDevicesAndSymbolicLinks) {
    fs::create_symlink("../elsewhere/target.json", folder_ / "out" / "link.json");
    write("elsewhere/target.json", "old");
    EXPECT_EQ(gsim_run({"--moves", "/dev/null", "--report", "out/link.json", "here/part.nc"}).status, 0);
    EXPECT_TRUE(contains(read("elsewhere/target.json"), "cycle_time_s"));
    EXPECT_EQ(gsim_run({"--report", "/dev/full", "here/part.nc"}).status, 2);
}

}  // namespace
}  // namespace gsim::apps::confined_test
