// gsim-bench-compare: runs commands that do the same work, in turn, and prints the resource use of each as
// rows of a Markdown table.
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "bench/measure.h"

namespace gsim::bench {
namespace {

constexpr std::string_view usage =
    "usage: gsim-bench-compare TITLE BLOCKS RUNS REFERENCE LABEL=COMMAND...\n"
    "  Runs every command once unmeasured if RUNS is more than 1, then RUNS times, the commands alternating. "
    "COMMAND is split\n"
    "  at its blanks. REFERENCE is the label that the last column divides by; a REFERENCE that is not\n"
    "  installed is left out with a word.\n";

struct Contender {
    std::string label;
    std::vector<std::string> command;
    std::vector<Usage> runs;
    bool installed = true;
};

struct Contest {
    std::string title;
    double blocks = 0.0;
    int runs = 0;
    std::string reference;
    std::vector<Contender> contenders;
};

std::optional<Contender> parse_contender(std::string_view argument) {
    const std::size_t equals = argument.find('=');
    if (equals == std::string_view::npos) return {};
    Contender contender;
    contender.label = argument.substr(0, equals);
    std::istringstream words{std::string(argument.substr(equals + 1))};
    for (std::string word; words >> word;) contender.command.push_back(word);
    if (contender.command.empty()) return {};
    return contender;
}

std::optional<Contest> parse(int argc, char** argv) {
    if (argc < 6) return {};
    Contest contest{argv[1], std::strtod(argv[2], nullptr), std::atoi(argv[3]), argv[4], {}};
    if (contest.blocks <= 0.0 || contest.runs < 1) return {};
    for (int i = 5; i < argc; ++i) {
        auto contender = parse_contender(argv[i]);
        if (!contender) return {};
        contest.contenders.push_back(std::move(*contender));
    }
    return contest;
}

/// Runs each contender once; returns false if one failed that must not.
bool run_round(Contest& contest, bool counted) {
    for (Contender& contender : contest.contenders) {
        if (!contender.installed) continue;
        const Usage used = measure(contender.command);
        if (used.status == 127 && contender.label == contest.reference) {
            contender.installed = false;
        } else if (used.status != 0) {
            fmt::print(stderr, "gsim-bench-compare: {} ended with status {}\n",
                       fmt::join(contender.command, " "), used.status);
            return false;
        } else if (counted) {
            contender.runs.push_back(used);
        }
    }
    return true;
}

/// A warm-up fills the file cache. A single run measures memory, for which the cache does not matter.
bool run(Contest& contest) {
    if (contest.runs > 1 && !run_round(contest, false)) return false;
    for (int i = 0; i < contest.runs; ++i) {
        if (!run_round(contest, true)) return false;
    }
    return true;
}

std::vector<double> sorted_cpu_s(const Contender& contender) {
    std::vector<double> times_s;
    for (const Usage& used : contender.runs) times_s.push_back(used.cpu_s);
    std::sort(times_s.begin(), times_s.end());
    return times_s;
}

double median_s(const Contender& contender) {
    const std::vector<double> times_s = sorted_cpu_s(contender);
    const std::size_t middle = times_s.size() / 2;
    return times_s.size() % 2 == 1 ? times_s[middle] : (times_s[middle - 1] + times_s[middle]) / 2.0;
}

std::optional<double> reference_s(const Contest& contest) {
    for (const Contender& contender : contest.contenders) {
        if (contender.label == contest.reference && !contender.runs.empty()) return median_s(contender);
    }
    return {};
}

void print_row(const Contest& contest, const Contender& contender) {
    if (contender.runs.empty()) {
        fmt::print("| {} | {} | not installed: skipped | | | |\n", contest.title, contender.label);
        return;
    }
    const std::vector<double> times_s = sorted_cpu_s(contender);
    const double cpu_s = median_s(contender);
    double peak_mb = 0.0;
    for (const Usage& used : contender.runs) peak_mb = std::max(peak_mb, used.peak_mb);
    const auto by_s = reference_s(contest);
    const std::string ratio = by_s ? fmt::format("{:.3f}", cpu_s / *by_s) : "";
    const std::string million_blocks_s =
        cpu_s > 0.0 ? fmt::format("{:.3f}", contest.blocks / cpu_s / 1e6) : "";
    fmt::print("| {} | {} | {:.2f} [{:.2f} .. {:.2f}] | {} | {:.1f} | {} |\n", contest.title, contender.label,
               cpu_s, times_s.front(), times_s.back(), million_blocks_s, peak_mb, ratio);
}

int compare(int argc, char** argv) {
    auto contest = parse(argc, argv);
    if (!contest) {
        fmt::print(stderr, "{}", usage);
        return 2;
    }
    if (!run(*contest)) return 1;
    for (const Contender& contender : contest->contenders) print_row(*contest, contender);
    return 0;
}

}  // namespace
}  // namespace gsim::bench

int main(int argc, char** argv) {
    try {
        return gsim::bench::compare(argc, argv);
    } catch (const std::exception& failure) {
        fmt::print(stderr, "gsim-bench-compare: {}\n", failure.what());
        return 1;
    }
}
