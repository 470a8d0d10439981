// Compares cycle times and positions of gsim with those that controllers were recorded with.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/parse.h"
#include "tests/accuracy/controller.h"
#include "tests/accuracy/distribution.h"
#include "tests/accuracy/estimators.h"
#include "tests/accuracy/gsim_program.h"
#include "tests/accuracy/klipper_estimator.h"
#include "tests/accuracy/known.h"
#include "tests/accuracy/report.h"

namespace gsim::accuracy {

namespace {

namespace fs = std::filesystem;

constexpr int kGood = 0;
constexpr int kExitFailed = 1;
constexpr int kUsage = 2;
constexpr int kSkipped = 77;  // exit status that CTest takes for a test that was not run

struct Arguments {
    std::string folder;
    std::string gsim_run = "gsim-run";
    std::vector<std::string> machines;
    bool markdown = false;
    bool positions = false;
    bool summary = false;
};

void add_options(apps::CommandLine& line, Arguments& arguments) {
    if (const char* folder = std::getenv("GSIM_REFERENCE"); folder != nullptr) arguments.folder = folder;
    line.add(
        "folder", &arguments.folder,
        "folder with recordings in linuxcnc/, linuxcnc-master/, grbl/, grblhal/, klipper/; else that of the "
        "environment's "
        "GSIM_REFERENCE");
    line.add("--gsim-run", &arguments.gsim_run, "the program gsim-run").show_default();
    line.add("--machines", &arguments.machines,
             "folder of machine files CONTROLLER-MACHINE.toml; the first one that has a file counts")
        .make_required();
    line.add("--markdown", &arguments.markdown, "tables in Markdown");
    line.add("--positions", &arguments.positions,
             "compare the positions of programs in G61.1 too; they count for the exit status");
    line.add("--summary", &arguments.summary,
             "one table of all controllers at the end, with what other estimators say of the same programs");
}

std::string known_difference(const Controller& controller, const std::string& program) {
    const auto all = known_differences();
    const auto found = all.find(fmt::format("{}/{}", controller.name, program));
    return found == all.end() ? std::string() : found->second;
}

std::vector<TimeOutcome> compare_times(const std::vector<Recording>& recordings, const Controller& controller,
                                       const GsimProgram& gsim) {
    std::vector<TimeOutcome> outcomes;
    outcomes.reserve(recordings.size());
    for (const Recording& recording : recordings) {
        outcomes.push_back({recording.name, recording.note, recording.counted, recording.cycle_time_s,
                            gsim.cycle_time_s(recording), known_difference(controller, recording.name)});
    }
    return outcomes;
}

Result<Distance> distance(const Recording& recording, const GsimProgram& gsim) {
    const auto recorded = recorded_path(recording);
    if (!recorded) return tl::unexpected(recorded.error());
    return gsim.path(recording).and_then(
        [&recorded](const TimedPath& found) { return largest_distance(*recorded, found); });
}

std::vector<PathOutcome> compare_paths(const std::vector<Recording>& recordings, const Controller& controller,
                                       const GsimProgram& gsim) {
    std::vector<PathOutcome> outcomes;
    for (const Recording& recording : recordings) {
        if (!recording.exact_stop || !recording.counted) continue;
        outcomes.push_back(
            {recording.name, distance(recording, gsim), known_difference(controller, recording.name)});
    }
    return outcomes;
}

bool all_good(const std::vector<PathOutcome>& outcomes) {
    return std::all_of(outcomes.begin(), outcomes.end(),
                       [](const PathOutcome& outcome) { return outcome.good() || !outcome.known.empty(); });
}

using Moves = std::span<const ProgrammedMove>;

struct Estimator {
    const char* name;
    double (*time_s)(Moves moves, const machine::Machine& machine);
    bool limits_may_change = true;  // else programs that change the limits of their machine are left out
};

// Estimators for all controllers, and for Klipper alone.
constexpr std::array kEstimators{
    Estimator{"length over feed",
              [](Moves moves, const machine::Machine&) { return length_over_feed_s(moves); }},
    Estimator{"CAMotics", [](Moves moves, const machine::Machine&) { return camotics_s(moves); }},
    Estimator{"proposed to LinuxCNC",
              [](Moves moves, const machine::Machine&) { return linuxcnc_parse_s(moves); }},
    Estimator{"klipper_estimator", klipper_estimator_s, false}};
constexpr std::size_t kCommonEstimators = 3;

std::span<const Estimator> estimators_of(const Controller& controller) {
    return std::span(kEstimators)
        .first(controller.name == "klipper" ? kEstimators.size() : kCommonEstimators);
}

// By words of Klipper's.
bool changes_limits(const fs::path& program) {
    std::ifstream file(program);
    for (std::string line; std::getline(file, line);) {
        if (line.find("M204") != std::string::npos || line.find("SET_VELOCITY_LIMIT") != std::string::npos)
            return true;
    }
    return false;
}

// Returns the times of foreign estimators for the same programs, in their order. Runs with overrides are left
// out, because the estimators know none.
std::vector<std::vector<TimeOutcome>> estimate(const std::vector<TimeOutcome>& outcomes,
                                               const std::vector<Recording>& recordings,
                                               std::span<const Estimator> estimators,
                                               const GsimProgram& gsim) {
    std::vector<std::vector<TimeOutcome>> all(estimators.size());
    for (std::size_t i = 0; i < recordings.size(); ++i) {
        if (!recordings[i].counted || !recordings[i].overrides.empty()) continue;
        const auto run = gsim.programmed_run(recordings[i]);
        const bool changes = changes_limits(recordings[i].program);
        for (std::size_t k = 0; k < estimators.size(); ++k) {
            if (changes && !estimators[k].limits_may_change) continue;
            TimeOutcome& outcome = all[k].emplace_back(outcomes[i]);
            outcome.found_s =
                run.map([&](const ProgrammedRun& of) { return estimators[k].time_s(of.moves, of.machine); });
        }
    }
    return all;
}

void add_rows(const std::vector<TimeOutcome>& outcomes, const std::vector<Recording>& recordings,
              const Controller& controller, const GsimProgram& gsim, std::vector<EstimatedController>& rows) {
    const std::string name(controller.name);
    rows.push_back({name, "gsim", distribution_of(outcomes)});
    const auto estimators = estimators_of(controller);
    const auto estimated = estimate(outcomes, recordings, estimators, gsim);
    for (std::size_t k = 0; k < estimators.size(); ++k)
        rows.push_back({name, estimators[k].name, distribution_of(estimated[k])});
}

// Prints how a controller's programs fared; whether well enough.
bool compare(const std::vector<Recording>& recordings, const Controller& controller, const GsimProgram& gsim,
             const Arguments& arguments, std::vector<EstimatedController>& rows) {
    const Format format = arguments.markdown ? Format::markdown : Format::plain;
    const auto times = compare_times(recordings, controller, gsim);
    fmt::print("{}", time_report(times, controller, format));
    std::vector<PathOutcome> paths;
    if (arguments.positions) paths = compare_paths(recordings, controller, gsim);
    fmt::print("{}", path_report(paths, controller, format));
    std::fflush(stdout);
    if (arguments.summary) add_rows(times, recordings, controller, gsim, rows);
    return summarize(times, controller).good() && all_good(paths);
}

std::vector<Recording> recordings_of(const Controller& controller, const fs::path& folder) {
    if (!fs::is_directory(folder)) return {};
    auto recordings = find_recordings(folder, controller);
    if (!recordings) throw std::runtime_error(recordings.error().message);
    return *std::move(recordings);
}

int run(const Arguments& arguments) {
    if (!fs::is_directory(arguments.folder)) {
        fmt::print("skipped: there is no folder '{}' of recordings (GSIM_REFERENCE)\n", arguments.folder);
        return kSkipped;
    }
    if (arguments.gsim_run.find('/') != std::string::npos && !fs::exists(arguments.gsim_run))
        throw std::runtime_error(fmt::format("there is no program '{}' (--gsim-run)", arguments.gsim_run));
    const GsimProgram gsim(arguments.gsim_run, arguments.machines);
    bool any = false;
    bool good = true;
    std::vector<EstimatedController> rows;
    for (const Controller& controller : kControllers) {
        const auto recordings = recordings_of(controller, fs::path(arguments.folder) / controller.name);
        if (recordings.empty()) {
            fmt::print("no recordings of {}\n\n", controller.name);
            continue;
        }
        any = true;
        good = compare(recordings, controller, gsim, arguments, rows) && good;
    }
    if (!any) throw std::runtime_error(fmt::format("no recordings in {}", arguments.folder));
    if (arguments.summary) fmt::print("{}", distribution_table(rows, arguments.markdown));
    return good ? kGood : kExitFailed;
}

}  // namespace

}  // namespace gsim::accuracy

int main(int argc, char** argv) {
    using namespace gsim;
    try {
        accuracy::Arguments arguments;
        apps::CommandLine line(
            "gsim-accuracy", "Compares cycle times and positions of gsim with those of recorded controllers");
        accuracy::add_options(line, arguments);
        const auto parsed = apps::parse(line, std::vector<std::string>(argv + 1, argv + argc));
        if (!parsed) throw std::runtime_error(parsed.error().message);
        if (*parsed) return **parsed;
        return accuracy::run(arguments);
    } catch (const std::exception& error) {
        fmt::print(stderr, "gsim-accuracy: {}\n", error.what());
        return accuracy::kUsage;
    }
}
