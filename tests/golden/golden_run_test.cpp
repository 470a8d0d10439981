// Runs each NAME.lua of this folder with gsim-run and compares its report with NAME.json: a script that is
// only compared may be one that no run gets through. Programs that ask for what they were not made for end in
// an alarm, which the report has. With GSIM_RENEW_GOLDEN=1 in the environment it writes the reports instead:
// read what changed before you keep it.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::golden_run_test {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = tests::source_path("tests/golden");
const std::string kMachine = tests::source_path("samples/machines/unlimited.toml");
const std::string kPrinter = tests::source_path("samples/machines/klipper-fast-ext.toml");

std::vector<fs::path> scripts() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(kFolder)) {
        if (entry.path().extension() == ".lua") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class GoldenRun : public testing::TestWithParam<fs::path> {};

TEST_P(GoldenRun, ReportsAsExpected) {
    const std::string text = read(GetParam());
    const bool ngc = text.find("\"gsim.rs274ngc\"") != std::string::npos;
    const bool klipper = text.find("\"gsim.klipper\"") != std::string::npos;
    const std::string setup = ngc       ? "conditions/rs274ngc.lua"
                              : klipper ? "conditions/klipper.lua"
                                        : "conditions/ab9.lua";
    // Programs that go round for ever do so for a few blocks and steps.
    const apps::Ended run = apps::run_program(
        tests::program_path("gsim-run"),
        {"--machine", klipper ? kPrinter : kMachine, "--machine-data", "conditions/data.txt", "--setup",
         setup, "--max-blocks", "2000", "--max-steps", "200000", "--json", GetParam().filename().string()},
        kFolder);
    const fs::path expected = fs::path(GetParam()).replace_extension(".json");
    const char* wish = std::getenv("GSIM_RENEW_GOLDEN");
    if (wish != nullptr && std::string_view(wish) == "1") {
        std::ofstream(expected, std::ios::binary) << run.out;
        return;
    }
    EXPECT_EQ(run.out, read(expected));
    const bool completed = run.out.find("\"status\": \"completed\"") != std::string::npos;
    EXPECT_EQ(run.status, completed ? 0 : 1) << run.err;
}

/// A report of a script that is gone would never be looked at.
TEST(GoldenRuns, EachReportHasScript) {
    for (const auto& entry : fs::directory_iterator(kFolder)) {
        if (entry.path().extension() != ".json") continue;
        EXPECT_TRUE(fs::exists(fs::path(entry.path()).replace_extension(".lua"))) << entry.path();
    }
}

std::string test_name(const testing::TestParamInfo<fs::path>& script) {
    std::string name = script.param.stem().string();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scripts, GoldenRun, testing::ValuesIn(scripts()), test_name);

}  // namespace
}  // namespace gsim::golden_run_test
