// Runs the check of each target over its corpus and over earlier findings of fuzzing, in the folders `corpus`
// and `findings` of the given one. A corpus without any valid input tries errors alone, and fails.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "tests/fuzz/target.h"

namespace {

namespace fs = std::filesystem;
using gsim::fuzz::Outcome;
using gsim::fuzz::Target;

/// Returns none if the folder is missing.
std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        const bool ground_truth = entry.path().filename().string().starts_with('.');
        if (entry.is_regular_file() && !ground_truth) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

struct Count {
    int inputs = 0;
    int accepted = 0;
    int broken = 0;

    bool passes() const { return accepted > 0 && broken == 0; }
};

void check_folder(const Target& target, const fs::path& folder, Count& count) {
    for (const fs::path& file : files_in(folder)) {
        const Outcome outcome = target.check(read(file));
        ++count.inputs;
        if (outcome.accepted) ++count.accepted;
        if (!outcome.broken) continue;
        ++count.broken;
        fmt::print("{}: {}: {}\n", target.name, file.string(), *outcome.broken);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    bool passes = true;
    for (const Target& target : gsim::fuzz::targets()) {
        Count count;
        check_folder(target, fs::path(argv[1]) / "corpus" / target.family, count);
        check_folder(target, fs::path(argv[1]) / "findings" / target.name, count);
        fmt::print("{}: {} inputs, {} of them right, {} break a promise{}\n", target.name, count.inputs,
                   count.accepted, count.broken, count.passes() ? "" : ": FAILED");
        passes = passes && count.passes();
    }
    return passes ? 0 : 1;
}
