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

struct BenchmarkEntry {
    std::string label;
    std::vector<std::string> command;
    std::vector<Usage> runs;
    bool installed = true;
};

struct Benchmark {
    std::string title;
    double blocks = 0.0;
    int runs = 0;
    std::string reference;
    std::vector<BenchmarkEntry> entries;
};

std::optional<BenchmarkEntry> parse_entry(std::string_view argument) {
    const std::size_t equals = argument.find('=');
    if (equals == std::string_view::npos) return {};
    BenchmarkEntry entry;
    entry.label = argument.substr(0, equals);
    std::istringstream words{std::string(argument.substr(equals + 1))};
    for (std::string word; words >> word;) entry.command.push_back(word);
    if (entry.command.empty()) return {};
    return entry;
}

std::optional<Benchmark> parse(int argc, char** argv) {
    if (argc < 6) return {};
    Benchmark benchmark{argv[1], std::strtod(argv[2], nullptr), std::atoi(argv[3]), argv[4], {}};
    if (benchmark.blocks <= 0.0 || benchmark.runs < 1) return {};
    for (int i = 5; i < argc; ++i) {
        auto entry = parse_entry(argv[i]);
        if (!entry) return {};
        benchmark.entries.push_back(std::move(*entry));
    }
    return benchmark;
}

/// Runs each contender once; returns false if one failed that must not.
bool run_round(Benchmark& benchmark, bool is_recorded) {
    for (BenchmarkEntry& entry : benchmark.entries) {
        if (!entry.installed) continue;
        const Usage measured = measure(entry.command);
        if (measured.status == 127 && entry.label == benchmark.reference) {
            entry.installed = false;
        } else if (measured.status != 0) {
            fmt::print(stderr, "gsim-bench-compare: {} ended with status {}\n", fmt::join(entry.command, " "),
                       measured.status);
            return false;
        } else if (is_recorded) {
            entry.runs.push_back(measured);
        }
    }
    return true;
}

/// A warm-up fills the file cache. A single run measures memory, for which the cache does not matter.
bool run(Benchmark& benchmark) {
    if (benchmark.runs > 1 && !run_round(benchmark, false)) return false;
    for (int i = 0; i < benchmark.runs; ++i) {
        if (!run_round(benchmark, true)) return false;
    }
    return true;
}

std::vector<double> sorted_cpu_s(const BenchmarkEntry& entry) {
    std::vector<double> times_s;
    for (const Usage& measured : entry.runs) times_s.push_back(measured.cpu_s);
    std::sort(times_s.begin(), times_s.end());
    return times_s;
}

double median_s(const BenchmarkEntry& entry) {
    const std::vector<double> times_s = sorted_cpu_s(entry);
    const std::size_t middle = times_s.size() / 2;
    return times_s.size() % 2 == 1 ? times_s[middle] : (times_s[middle - 1] + times_s[middle]) / 2.0;
}

std::optional<double> reference_s(const Benchmark& benchmark) {
    for (const BenchmarkEntry& entry : benchmark.entries) {
        if (entry.label == benchmark.reference && !entry.runs.empty()) return median_s(entry);
    }
    return {};
}

void print_row(const Benchmark& benchmark, const BenchmarkEntry& entry) {
    if (entry.runs.empty()) {
        fmt::print("| {} | {} | not installed: skipped | | | |\n", benchmark.title, entry.label);
        return;
    }
    const std::vector<double> times_s = sorted_cpu_s(entry);
    const double cpu_s = median_s(entry);
    double peak_mb = 0.0;
    for (const Usage& measured : entry.runs) peak_mb = std::max(peak_mb, measured.peak_mb);
    const auto reference_time_s = reference_s(benchmark);
    const std::string ratio = reference_time_s ? fmt::format("{:.3f}", cpu_s / *reference_time_s) : "";
    const std::string million_blocks_s =
        cpu_s > 0.0 ? fmt::format("{:.3f}", benchmark.blocks / cpu_s / 1e6) : "";
    fmt::print("| {} | {} | {:.2f} [{:.2f} .. {:.2f}] | {} | {:.1f} | {} |\n", benchmark.title, entry.label,
               cpu_s, times_s.front(), times_s.back(), million_blocks_s, peak_mb, ratio);
}

int compare(int argc, char** argv) {
    auto benchmark = parse(argc, argv);
    if (!benchmark) {
        fmt::print(stderr, "{}", usage);
        return 2;
    }
    if (!run(*benchmark)) return 1;
    for (const BenchmarkEntry& entry : benchmark->entries) print_row(*benchmark, entry);
    return 0;
}

}  // namespace
}  // namespace gsim::bench

int main(int argc, char** argv) {
    try {
        return gsim::bench::compare(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "gsim-bench-compare: {}\n", error.what());
        return 1;
    }
}
