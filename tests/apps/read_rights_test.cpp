// Read permissions: pipes that a file names block no run, those of the command line are read.
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::read_rights_test {
namespace {

class ReadPermissions : public Apps {
  protected:
    void make_pipe(const std::string& name) const { ASSERT_EQ(::mkfifo((folder_ / name).c_str(), 0600), 0); }
    Ended shell(const std::string& command) const {
        return run_program("/bin/bash", {"-c", command}, folder_);
    }
};

TEST_F(ReadPermissions, RejectsPipeNamedInFile) {
    make_pipe("pipe.toml");
    make_pipe("pipe.stl");
    make_pipe("pipe.txt");
    write("part.nc", "G0 X1\nM2\n");
    const std::string message = "it is a pipe; a file or script may name only regular files";
    for (const std::string cell :
         {"[cell]\nname = \"c\"\nmachine = \"pipe.toml\"\n",
          "[cell]\nname = \"c\"\nmachine_data = \"pipe.txt\"\n",
          "[cell]\nname = \"c\"\n[[object]]\nname = \"o\"\nshape = { mesh = \"pipe.stl\" }\n"}) {
        write("cell.toml", cell);
        const Ended ended = gsim_run({"--cell", "cell.toml", "part.nc"});
        EXPECT_EQ(ended.status, 2) << cell;
        EXPECT_TRUE(contains(ended.err, contains(cell, "mesh") ? "pipe.stl: " : message)) << ended.err;
    }
    write("machine.toml", "[machine]\nname = \"m\"\n[controller]\nmodel = \"pipe.toml\"\n");
    const Ended ended = gsim_run({"--machine", "machine.toml", "part.nc"});
    EXPECT_TRUE(contains(ended.err, message)) << ended.err;
}

TEST_F(ReadPermissions, ReadsPipesOfCommandLine) {
    write("part.nc", "G0 X1\nM2\n");
    const std::string machine = tests::source_path("samples/machines/af5.toml");
    write("cell.toml", "[cell]\nname = \"c\"\n");
    write("data.txt", "NCFILE\nENDFILE\n");
    const Ended ended =
        shell(fmt::format("{} --machine <(cat {}) --cell <(cat cell.toml) --machine-data <(cat data.txt) "
                          "--variables <(true) <(cat part.nc)",
                          tests::program_path("gsim-run"), machine));
    EXPECT_TRUE(contains(ended.out, "completed")) << ended.out << ended.err;
    const Ended translated = shell(
        fmt::format("{} --machine <(cat {}) <(cat part.nc)", tests::program_path("gcode2lua"), machine));
    EXPECT_EQ(translated.status, 0) << translated.err;
}

TEST_F(ReadPermissions, RejectsCalledProgramOutsideScriptFolder) {
    std::filesystem::create_directory(folder_ / "inside");
    write("secret.lua", "print('secret')\n");
    write("inside/own.lua", "print('own')\n");
    std::filesystem::create_symlink("../secret.lua", folder_ / "inside" / "sub.lua");
    std::filesystem::create_symlink("own.lua", folder_ / "inside" / "near.lua");
    write("inside/main.lua", "run('sub')\n");
    const Ended ended = gsim_run({"inside/main.lua"});
    EXPECT_NE(ended.status, 0);
    EXPECT_FALSE(contains(ended.out + ended.err, "secret\n")) << ended.out;
    EXPECT_TRUE(
        contains(ended.out + ended.err, "sub.lua is a link to a file outside the folder of the script"))
        << ended.out << ended.err;
    write("inside/main.lua", "run('near')\n");
    const Ended near = gsim_run({"inside/main.lua"});
    EXPECT_TRUE(contains(near.out + near.err, "own\n")) << near.out << near.err;
}

}  // namespace
}  // namespace gsim::apps::read_rights_test
