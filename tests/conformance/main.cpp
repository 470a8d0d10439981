// Compares runs of gsim with canonical output that LinuxCNC's interpreter recorded.

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/parse.h"
#include "tests/conformance/compare.h"
#include "tests/conformance/known.h"
#include "tests/conformance/moves_reader.h"
#include "tests/conformance/programs.h"
#include "tests/conformance/random_run.h"

namespace gsim::conformance {

namespace {

constexpr int kAgree = 0;
constexpr int kDiffer = 1;
constexpr int kUsage = 2;
constexpr int kSkipped = 77;  // exit status that CTest takes for a test that was not run

struct Arguments {
    std::string folder;
    GsimOptions gsim;
    double least_percent = 100;
    std::string known_file;
    bool failures_only = false;
    std::string moves_file;
    std::string canon_file;
    RandomRun random;
};

using Outcome = Result<Verdict>;

Outcome compare_with(const std::filesystem::path& canon_file, const std::vector<Move>& moves) {
    return read_text(canon_file).and_then([&moves](const std::string& text) -> Outcome {
        std::istringstream canon(text);
        const auto expected = read_canon(canon);
        if (!expected) return tl::unexpected(expected.error());
        return compare(*expected, moves);
    });
}

// A file that is known not to agree does as the list says, and any other agrees; else says what does not.
bool is_as_known(const std::string& name, const Outcome& outcome, const std::vector<Known>& known) {
    const Known* const entry = find_known(known, name);
    const bool agrees = outcome && !outcome->difference;
    if (entry == nullptr) return agrees;
    if (!outcome && outcome.error().message.find(entry->reason) != std::string::npos) return true;
    fmt::print("{}: is not refused by \"{}\", as the list of known files has it\n", name, entry->reason);
    return false;
}

// Prints how a file fared; whether it agrees wholly.
bool print(const std::string& name, const Outcome& outcome, bool failures_only) {
    if (!outcome) {
        fmt::print("{}: refused: {}\n", name, outcome.error().message);
        return false;
    }
    if (!outcome->difference) {
        if (!failures_only) fmt::print("{}: agree {} moves\n", name, outcome->agreed);
        return true;
    }
    const Difference& difference = *outcome->difference;
    fmt::print("{}: differs after {} moves: {}\n    expected {}\n    found    {}\n", name, outcome->agreed,
               difference.what, difference.expected, difference.found);
    return false;
}

int compare_two_files(const Arguments& arguments) {
    const Outcome outcome = read_text(arguments.moves_file).and_then([&](const std::string& text) -> Outcome {
        std::istringstream lines(text);
        const auto moves = read_moves(lines);
        if (!moves) return tl::unexpected(moves.error());
        return compare_with(arguments.canon_file, *moves);
    });
    return print(arguments.moves_file, outcome, arguments.failures_only) ? kAgree : kDiffer;
}

int compare_folder(const Arguments& arguments) {
    if (!std::filesystem::is_directory(arguments.folder)) {
        fmt::print("skipped: there is no folder '{}' of recorded programs (GSIM_CORPUS)\n", arguments.folder);
        return kSkipped;
    }
    const auto programs = find_recorded(arguments.folder);
    if (!programs) throw std::runtime_error(programs.error().message);
    if (programs->empty()) throw std::runtime_error("no recorded programs in " + arguments.folder);
    const bool has_list = !arguments.known_file.empty();
    const auto known = has_list ? read_known(arguments.known_file) : std::vector<Known>{};
    if (!known) throw std::runtime_error(known.error().message);
    const GsimRuns gsim(arguments.gsim, recorded_tools());
    std::size_t agreeing = 0, as_known = 0;
    for (const Recorded& recorded : *programs) {
        const auto moves = gsim.moves(recorded);
        const Outcome outcome = moves ? compare_with(recorded.canon, *moves) : tl::unexpected(moves.error());
        const std::string name = recorded.program.lexically_relative(arguments.folder);
        if (print(name, outcome, arguments.failures_only)) ++agreeing;
        if (is_as_known(name, outcome, *known)) ++as_known;
        std::fflush(stdout);
    }
    const double percent = 100.0 * static_cast<double>(agreeing) / static_cast<double>(programs->size());
    fmt::print("{} of {} files agree wholly ({:.1f} %)\n", agreeing, programs->size(), percent);
    if (!has_list) return percent >= arguments.least_percent ? kAgree : kDiffer;
    fmt::print("{} of {} files are as they are known to be\n", as_known, programs->size());
    return as_known == programs->size() ? kAgree : kDiffer;
}

int compare_random_programs(const Arguments& arguments) {
    const auto tally = compare_random(arguments.random, arguments.gsim);
    if (!tally) {
        fmt::print("skipped: {}\n", tally.error().message);
        return kSkipped;
    }
    fmt::print("{} of {} random programs agree, {} are refused by both, {} differ\n", tally->agree,
               arguments.random.count, tally->rejected, tally->differ);
    const double percent =
        100.0 * static_cast<double>(tally->agree) / static_cast<double>(arguments.random.count);
    return tally->differ == 0 && percent >= arguments.least_percent ? kAgree : kDiffer;
}

void add_options(apps::CommandLine& line, Arguments& arguments) {
    if (const char* folder = std::getenv("GSIM_CORPUS"); folder != nullptr) arguments.folder = folder;
    line.add("folder", &arguments.folder,
             "folder of part programs FILE with canonical output FILE.canon.gz beside them; else that of the "
             "environment's GSIM_CORPUS");
    line.add("--gsim-run", &arguments.gsim.gsim_run, "the program gsim-run").show_default();
    line.add("--machine", &arguments.gsim.machine, "machine file without limits, axes X Y Z A B C U V W");
    line.add("--gsim-option", &arguments.gsim.extra, "a further option for gsim-run");
    line.add("--least", &arguments.least_percent, "percentage of files that must agree wholly")
        .within(0, 100)
        .show_default();
    line.add("--known", &arguments.known_file,
             "list of files that are known not to agree, and how: all others must");
    line.add("--failures", &arguments.failures_only, "list only the files that do not agree");
    line.add("--random", &arguments.random.count,
             "compare so many random programs with LinuxCNC's interpreter");
    line.add("--seed", &arguments.random.first_seed, "seed of the first of them").show_default();
    line.add("--reference", &arguments.random.reference, "LinuxCNC's interpreter").show_default();
    line.add("--keep", &arguments.random.keep_folder, "folder for the random programs that do not agree");
    line.add("--moves", &arguments.moves_file, "compare this file of moves ...");
    line.add("--canon", &arguments.canon_file, "... with this canonical output (or .gz)");
}

int run(const Arguments& arguments) {
    if (arguments.moves_file.empty() != arguments.canon_file.empty())
        throw std::runtime_error("--moves and --canon go together");
    if (!arguments.moves_file.empty()) return compare_two_files(arguments);
    if (!arguments.folder.empty() && arguments.gsim.machine.empty()) {
        throw std::runtime_error("--machine is needed to run a folder");
    }
    if (arguments.random.count > 0) return compare_random_programs(arguments);
    return compare_folder(arguments);
}

}  // namespace

}  // namespace gsim::conformance

int main(int argc, char** argv) {
    using namespace gsim;
    try {
        conformance::Arguments arguments;
        apps::CommandLine line("gsim-conformance",
                               "Compares moves of gsim with canonical output of LinuxCNC's interpreter");
        conformance::add_options(line, arguments);
        const auto parsed = apps::parse(line, std::vector<std::string>(argv + 1, argv + argc));
        if (!parsed) throw std::runtime_error(parsed.error().message);
        if (*parsed) return **parsed;
        return conformance::run(arguments);
    } catch (const std::exception& error) {
        fmt::print(stderr, "gsim-conformance: {}\n", error.what());
        return conformance::kUsage;
    }
}
