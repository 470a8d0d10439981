// One file by two names on a command line: refused before anything is opened.

#include <filesystem>

#include <fmt/format.h>

#include "apps/outputs.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::named_files_test {
namespace {

namespace fs = std::filesystem;

const std::string kPart = "G0 X100\nG1 X110 F3000\n";
const std::string kData = "NCFILE\nOFFSET\n54 1 2 3\nENDFILE\n";

class NamedFiles : public Apps {
  protected:
    Ended gsim(const std::vector<std::string>& arguments, const std::string& input = {}) const {
        return run_program(tests::program_path("gsim"), arguments, folder_, input);
    }
    Ended shell(const std::string& line) const {
        return run_program("/bin/sh", {"-c", fmt::format("G='{}'; {}", tests::program_path("gsim"), line)},
                           folder_);
    }
    /// Returns the error message, without the program's name and the hint after it.
    std::string rejected(const std::vector<std::string>& arguments) const {
        const std::size_t before = files();
        const Ended ended = gsim(arguments);
        EXPECT_EQ(ended.status, 2) << fmt::format("{}", arguments.back());
        EXPECT_EQ(files(), before) << "no file is made";
        EXPECT_EQ(read("p.nc"), kPart);
        EXPECT_EQ(read("d.txt"), kData);
        const std::string line = ended.err.substr(0, ended.err.find('\n'));
        return line.substr(line.find(": ") + 2);
    }
    const std::string part_ = write("p.nc", kPart);
    const std::string data_ = write("d.txt", kData);
};

std::string destroys(const std::string& output, const std::string& input) {
    return fmt::format(
        "{} and {} are the same file, which would be read and overwritten; use a separate file for the "
        "output",
        output, input);
}

TEST_F(NamedFiles, RejectsInputFileAsOutput) {
    EXPECT_EQ(rejected({"run", "p.nc", "--moves", "p.nc"}),
              destroys("--moves 'p.nc'", "part.lua|part.nc 'p.nc'"));
    fs::create_symlink("p.nc", folder_ / "link");
    fs::create_hard_link(folder_ / "p.nc", folder_ / "hard");
    std::vector<std::string> options = {"--sarif"};
    for (const OutputNames::File& file : OutputNames::files()) options.emplace_back(file.option);
    for (const std::string name : {"./p.nc", "link", "hard"}) {
        for (const std::string& option : options)
            EXPECT_EQ(rejected({"run", "p.nc", option, name}),
                      destroys(fmt::format("{} '{}'", option, name), "part.lua|part.nc 'p.nc'"));
    }
    EXPECT_EQ(rejected({"run", "p.nc", "--machine-data", "d.txt", "--report", "d.txt"}),
              destroys("--report 'd.txt'", "--machine-data 'd.txt'"));
    EXPECT_EQ(rejected({"check", "x.nc", "p.nc", "--sarif", "p.nc"}),
              destroys("--sarif 'p.nc'", "part.nc|part.lua 'p.nc'"));
    EXPECT_EQ(rejected({"translate", "p.nc", "-o", "p.nc"}), destroys("--output 'p.nc'", "part.nc 'p.nc'"));
    EXPECT_EQ(rejected({"write", "p.nc", "-o", "p.nc"}),
              destroys("--output 'p.nc'", "part.path.json|part.lua 'p.nc'"));
    EXPECT_EQ(rejected({"path", "p.nc", "-o", "p.nc"}), destroys("--output 'p.nc'", "drawing 'p.nc'"));
    EXPECT_EQ(rejected({"path", "x.svg", "--materials", "d.txt", "-o", "d.txt"}),
              destroys("--output 'd.txt'", "--materials 'd.txt'"));
    EXPECT_EQ(rejected({"data", "import", "d.txt", "--data", "d.txt"}).find("--data 'd.txt'"), 0U);
    EXPECT_EQ(rejected({"data", "d.txt", "convert", "--from-json", "d.txt"}),
              destroys("FILE 'd.txt'", "--from-json 'd.txt'"));
    EXPECT_EQ(rejected({"run", "p.nc", "--machine-data", "d.txt", "--variables", "d.txt"}),
              destroys("--variables 'd.txt'", "--machine-data 'd.txt'"));
}

TEST_F(NamedFiles, RejectsSameFileForTwoOutputs) {
    const auto same = [](const std::string& a, const std::string& b) {
        return fmt::format("{} and {} are the same file; use a separate file for each output", a, b);
    };
    fs::create_directory_symlink(".", folder_ / "here");
    EXPECT_EQ(rejected({"run", "p.nc", "--report", "a", "--moves", "a"}),
              same("--report 'a'", "--moves 'a'"));
    EXPECT_EQ(rejected({"run", "p.nc", "--report", "a", "--moves", "./a"}),
              same("--report 'a'", "--moves './a'"));
    EXPECT_EQ(rejected({"run", "p.nc", "--variables", "a", "--record", "here/a"}),
              same("--record 'here/a'", "--variables 'a'"));
    EXPECT_EQ(rejected({"run", "--envelope", "a.csv", "--envelope", "./a.csv"}),
              same("--envelope 'a.csv'", "--envelope './a.csv'"));
    EXPECT_EQ(rejected({"translate", "p.nc", "-o", "a", "--sarif", "a"}),
              same("--output 'a'", "--sarif 'a'"));
    EXPECT_EQ(rejected({"data", "d.txt", "convert", "--inch", "-o", "d.txt"}),
              same("FILE 'd.txt'", "--output 'd.txt'"));
}

TEST_F(NamedFiles, RejectsSharedFileOfRobot) {
    write("robots.toml", "[[robot]]\nname = \"left\"\nmachine_data = \"d.left.txt\"\n");
    write("d.left.txt", kData);
    EXPECT_EQ(rejected({"run", "p.nc", "--robots", "robots.toml", "--moves", "m.json", "--report",
                        "./m.left.json"}),
              "'m.left.json' of the robot left is also the report; give one of them another name");
    EXPECT_EQ(rejected({"run", "p.nc", "--robots", "robots.toml", "--moves", "d.txt"}),
              "'d.left.txt' of the robot left is also its machine data; give one of them another name");
    EXPECT_EQ(read("d.left.txt"), kData);
}

TEST_F(NamedFiles, RejectsOutputOverMachineDataOfCell) {
    write("cell.toml", "[cell]\nname = \"c\"\nmachine_data = \"d.txt\"\n");
    EXPECT_EQ(rejected({"run", "p.nc", "--cell", "cell.toml", "--moves", "./d.txt"}),
              "--moves './d.txt' is the machine data of the cell, which would be overwritten; give it "
              "another name");
    EXPECT_EQ(gsim({"run", "p.nc", "--quiet", "--cell", "cell.toml", "--save-machine-data", "d.txt"}).status,
              0);
}

TEST_F(NamedFiles, ChecksRedirectedStandardStreams) {
    const Ended output = shell("$G run p.nc --moves m.jsonl >m.jsonl");
    EXPECT_EQ(output.status, 2);
    EXPECT_TRUE(contains(output.err, "--moves 'm.jsonl' and standard output are the same file"))
        << output.err;
    EXPECT_EQ(shell("$G run p.nc >>p.nc").status, 2);
    EXPECT_EQ(read("p.nc"), kPart);
    EXPECT_EQ(shell("$G translate - -o p.nc <p.nc").status, 2);
    EXPECT_EQ(read("p.nc"), kPart);
    EXPECT_EQ(shell("$G translate p.nc -o p.lua <p.nc").status, 0) << "standard input is not read";
}

TEST_F(NamedFiles, RejectsTwoOutputsOnStandardOutput) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"run", "p.nc", "--moves", "-", "--sarif", "-"},
                                               {"translate", "p.nc", "-o", "-", "--sarif", "-"},
                                               {"translate", "p.nc", "--sarif", "-"},
                                               {"check", "--json", "--sarif", "-", "p.nc"}}) {
        const Ended ended = gsim(arguments);
        EXPECT_EQ(ended.status, 2);
        EXPECT_TRUE(contains(ended.err + ended.out, "both use standard output")) << ended.err << ended.out;
    }
    const Ended check = gsim({"check", "--sarif", "-", "p.nc"});
    EXPECT_TRUE(check.out.starts_with("{")) << "text makes way";
    EXPECT_TRUE(contains(check.err, "p.nc: no errors"));
}

TEST_F(NamedFiles, AcceptsIntendedSharedFiles) {
    EXPECT_EQ(gsim({"run", "p.nc", "--quiet", "--moves", "/dev/null", "--report", "/dev/null"}).status, 0);
    EXPECT_EQ(gsim({"data", "d.txt", "set", "OFFSET", "54", "X=2"}).status, 0);
    EXPECT_EQ(gsim({"data", "d.txt", "convert", "--inch"}).status, 0);
    EXPECT_EQ(
        gsim({"run", "p.nc", "--quiet", "--machine-data", "d.txt", "--save-machine-data", "./d.txt"}).status,
        0);
    EXPECT_EQ(gsim({"check", "p.nc", "p.nc"}).status, 0);
    EXPECT_EQ(gsim({"run", "p.nc", "--quiet", "--moves", "a", "--report", "b"}).status, 0);
    write("ab9", "");
    EXPECT_EQ(gsim({"write", tests::source_path("samples/wheel.path.json"), "--dialect", "ab9", "-o", "ab9"})
                  .status,
              0)
        << "the name of a post is no file";
}

}  // namespace
}  // namespace gsim::apps::named_files_test
