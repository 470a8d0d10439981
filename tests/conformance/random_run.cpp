#include "tests/conformance/random_run.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "tests/conformance/compare.h"
#include "tests/conformance/generator/ngc_generator.h"
#include "tests/conformance/reference_interpreter.h"

namespace gsim::conformance {

namespace {

namespace fs = std::filesystem;

enum class Outcome { agree, rejected, differ };

void print_difference(std::size_t seed, const std::string& what) {
    fmt::print("seed {}: {}\n", seed, what);
}

Outcome judge(std::size_t seed, const std::optional<std::vector<ExpectedMove>>& expected,
              const Result<std::vector<Move>>& found) {
    if (!expected && !found) return Outcome::rejected;
    if (!expected) {
        print_difference(seed, "only the reference refuses it");
        return Outcome::differ;
    }
    if (!found) {
        print_difference(seed, "only gsim refuses it: " + found.error().message);
        return Outcome::differ;
    }
    const Verdict verdict = compare(*expected, *found);
    if (!verdict.difference) return Outcome::agree;
    print_difference(
        seed, fmt::format("differs after {} moves: {}\n    expected {}\n    found    {}", verdict.agreed,
                          verdict.difference->what, verdict.difference->expected, verdict.difference->found));
    return Outcome::differ;
}

void keep(const std::string& folder, std::size_t seed, Outcome outcome, const std::string& text) {
    if (folder.empty()) return;
    fs::create_directories(folder);
    const std::string_view suffix = outcome == Outcome::rejected ? ".refused" : "";
    std::ofstream(fs::path(folder) / fmt::format("{}{}.ngc", seed, suffix)) << text;
}

void count(Outcome outcome, RandomTally& tally) {
    switch (outcome) {
        case Outcome::agree: ++tally.agree; return;
        case Outcome::rejected: ++tally.rejected; return;
        case Outcome::differ: ++tally.differ; return;
    }
}

}  // namespace

Result<RandomTally> compare_random(const RandomRun& run, const GsimOptions& gsim) {
    const ReferenceInterpreter reference(run.reference, random_program_tools());
    if (!reference.is_installed())
        return Unexpected(fmt::format("'{}' of LinuxCNC is not installed", run.reference));
    const GsimRuns runs(gsim, random_program_tools());
    const ScratchFolder scratch;
    RandomTally tally;
    for (std::size_t seed = run.first_seed; seed - run.first_seed < run.count; ++seed) {
        const std::string text = NgcGenerator(seed).program();
        const fs::path program = scratch.write("program.ngc", text);
        const auto expected = reference.moves(program);
        if (!expected) return tl::unexpected(expected.error());
        const Outcome outcome = judge(seed, *expected, runs.moves({.program = program, .canon = {}}));
        if (outcome != Outcome::agree) keep(run.keep_folder, seed, outcome, text);
        count(outcome, tally);
        std::fflush(stdout);
    }
    return tally;
}

}  // namespace gsim::conformance
