// Runs the fuzzer's check over the files of the folders given: the seeds and what fuzzing once found.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "tests/fuzz/translation_check.h"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const bool hidden = entry.path().filename().string().starts_with('.');
        if (entry.is_regular_file() && !hidden) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int argc, char** argv) {
    int checked = 0;
    int failed = 0;
    for (int i = 1; i < argc; ++i) {
        for (const fs::path& file : files_in(argv[i])) {
            ++checked;
            if (const auto broken = gsim::fuzz::broken_promise(read(file))) {
                ++failed;
                fmt::print("{}: {}\n", file.string(), *broken);
            }
        }
    }
    fmt::print("{} inputs, {} of them break a promise\n", checked, failed);
    return checked > 0 && failed == 0 ? 0 : 1;
}
