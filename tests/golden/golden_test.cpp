// Translates each NAME.nc, NAME.ngc (RS274/NGC) and NAME.gcode (Klipper) of this folder and of samples/ and
// compares the Lua with NAME.lua and the messages with NAME.err of this folder; a file that does not exist
// stands for no output. With GSIM_RENEW_GOLDEN=1 in the environment it writes both instead: read what changed
// before you keep it.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "codegen/translate.h"
#include "tests/build_files/build_files.h"

namespace gsim::codegen::golden_test {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = tests::source_path("tests/golden");
constexpr std::string_view kNgc = ".ngc";
constexpr std::string_view kKlipper = ".gcode";

std::vector<fs::path> programs() {
    std::vector<fs::path> files;
    for (const fs::path& folder : {kFolder, fs::path(tests::source_path("samples"))}) {
        for (const auto& entry : fs::directory_iterator(folder)) {
            const fs::path extension = entry.path().extension();
            if (extension == ".nc" || extension == kNgc || extension == kKlipper)
                files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void renew(const fs::path& path, const std::string& text) {
    if (text.empty()) {
        fs::remove(path);
    } else {
        std::ofstream(path, std::ios::binary) << text;
    }
}

class Golden : public testing::TestWithParam<fs::path> {};

TEST_P(Golden, TranslatesAsExpected) {
    TranslateOptions options;
    options.source_name = GetParam().filename().string();
    if (GetParam().extension() == kNgc) options.dialect = &grammar::dialect_rs274ngc();
    if (GetParam().extension() == kKlipper) options.dialect = &grammar::dialect_klipper();
    const TextTranslation result = translate_text(read(GetParam()), options);
    fs::path expected = kFolder / GetParam().filename();
    const fs::path lua = expected.replace_extension(".lua");
    const fs::path messages = expected.replace_extension(".err");
    if (const char* wish = std::getenv("GSIM_RENEW_GOLDEN");
        wish != nullptr && std::string_view(wish) == "1") {
        renew(lua, result.lua);
        renew(messages, result.diagnostics);
        return;
    }
    EXPECT_EQ(result.lua, read(lua));
    EXPECT_EQ(result.diagnostics, read(messages));
}

std::string test_name(const testing::TestParamInfo<fs::path>& program) {
    std::string name = program.param.stem().string();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Programs, Golden, testing::ValuesIn(programs()), test_name);

}  // namespace
}  // namespace gsim::codegen::golden_test
