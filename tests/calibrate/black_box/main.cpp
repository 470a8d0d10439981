// Accuracy of generic models that are fitted to recorded controllers as black boxes.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/os/output_file.h"
#include "cli/parse.h"
#include "machine/file/machine_file.h"
#include "tests/accuracy/controller.h"
#include "tests/calibrate/black_box/black_box.h"
#include "tests/conformance/scratch_folder.h"
#include "tests/support/machine_folders.h"

namespace gsim::calibrate {

namespace {

namespace fs = std::filesystem;

constexpr int kGood = 0;
constexpr int kExitFailed = 1;
constexpr int kUsage = 2;
constexpr int kSkipped = 77;
constexpr double kMost_percent = 3;  // of a run, as Realistic Robot Simulation I requires
constexpr double kMean_percent = 1;

struct Arguments {
    std::string folder;
    std::vector<std::string> machines;
    std::string only;
    std::uint64_t fitted = 30;
    std::uint64_t most_moves = 700;
    std::uint64_t seed = 1;
    std::uint64_t worst = 3;
    bool print_progress = false;
};

void add_options(apps::CommandLine& line, Arguments& arguments) {
    if (const char* folder = std::getenv("GSIM_REFERENCE"); folder != nullptr) arguments.folder = folder;
    line.add("folder", &arguments.folder,
             "folder with recordings in linuxcnc/, grbl/ and so on; else that of the environment's "
             "GSIM_REFERENCE");
    line.add("--machines", &arguments.machines,
             "folder of machine files CONTROLLER-MACHINE.toml; the first one that has a file counts")
        .make_required();
    line.add("--only", &arguments.only, "machines whose names begin so").with_value_name("NAME");
    line.add("--fit", &arguments.fitted, "runs that a model is fitted to").within(6, 1000).show_default();
    line.add("--most-moves", &arguments.most_moves,
             "moves of a run that it is fitted to at most; longer ones are foretold")
        .within(1, 1'000'000)
        .show_default();
    line.add("--seed", &arguments.seed, "chooses them").within(0, 1'000'000).show_default();
    line.add("--worst", &arguments.worst, "how many of the worst runs are named").show_default();
    line.add("--tell", &arguments.print_progress, "tell what is tried");
}

/// Tools 1 to 9, without lengths.
std::string table_of_tools() {
    std::string text = "NCFILE\nTOOL\n";
    for (int number = 1; number <= 9; ++number) text += fmt::format("{} 0 0 CUTTER\n", number);
    return text + "ENDFILE\n";
}

void print_outcome(const BlackBox& box, BoxOutcome outcome, const Arguments& arguments) {
    fmt::print("{}: {}\n  foretold {} runs: {:.2f} % off in the mean, {:.2f} % at worst, {} within {} %\n",
               box.name, outcome.choice.candidate.name, outcome.foretold.size(), outcome.mean_percent(),
               outcome.largest_percent(), outcome.within(kMost_percent), kMost_percent);
    for (const FittedParameter& parameter : outcome.parameters) {
        fmt::print("    {} = {:.6g}{}\n", machine::parameter_name(parameter.parameter_id), parameter.value,
                   parameter.identified ? fmt::format(", to {:.2g} %", 100 * parameter.standard_deviation)
                                        : ", not told");
    }
    std::sort(outcome.foretold.begin(), outcome.foretold.end(), [](const Foretold& a, const Foretold& b) {
        return std::abs(a.error_percent()) > std::abs(b.error_percent());
    });
    for (std::size_t i = 0; i < std::min<std::size_t>(arguments.worst, outcome.foretold.size()); ++i) {
        const Foretold& run = outcome.foretold[i];
        fmt::print("    {}: {:.3f} s for {:.3f} s, {:+.2f} %\n", fs::path(run.run.program).stem().string(),
                   run.time_s, run.run.time_s, run.error_percent());
    }
    for (const std::string& reason : outcome.left_out) fmt::print("    left out: {}\n", reason);
    std::fflush(stdout);
}

/// Results of all boxes.
struct Sums {
    std::size_t boxes = 0;
    std::size_t good = 0;  ///< Boxes with all runs within 3 %, and 1 % in the mean.
    std::size_t runs = 0;
    std::size_t within = 0;
    double percent = 0;
};

void count(const BoxOutcome& outcome, Sums& sums) {
    ++sums.boxes;
    sums.runs += outcome.foretold.size();
    sums.within += outcome.within(kMost_percent);
    sums.percent += outcome.mean_percent() * static_cast<double>(outcome.foretold.size());
    if (outcome.largest_percent() <= kMost_percent && outcome.mean_percent() <= kMean_percent) ++sums.good;
}

void add_boxes(const accuracy::Controller& controller, const Arguments& arguments,
               std::vector<BlackBox>& boxes) {
    const fs::path folder = fs::path(arguments.folder) / controller.name;
    if (!fs::is_directory(folder)) return;
    const auto recordings = accuracy::find_recordings(folder, controller);
    if (!recordings) throw std::runtime_error(recordings.error().message);
    for (BlackBox& box : black_boxes(*recordings)) {
        const auto same = std::find_if(boxes.begin(), boxes.end(),
                                       [&](const BlackBox& other) { return other.name == box.name; });
        if (same == boxes.end()) {
            boxes.push_back(std::move(box));
        } else {
            std::move(box.recordings.begin(), box.recordings.end(), std::back_inserter(same->recordings));
        }
    }
}

int run(const Arguments& arguments) {
    if (!fs::is_directory(arguments.folder)) {
        fmt::print("skipped: there is no folder '{}' of recordings (GSIM_REFERENCE)\n", arguments.folder);
        return kSkipped;
    }
    const conformance::ScratchFolder scratch;
    const std::string data = scratch.write("tools.txt", table_of_tools()).string();
    std::vector<BlackBox> boxes;
    for (const accuracy::Controller& controller : accuracy::kControllers)
        add_boxes(controller, arguments, boxes);
    Sums sums;
    const auto print_progress = [&](const std::string& words) {
        if (arguments.print_progress) fmt::print(stderr, "  {}\n", words);
    };
    for (const BlackBox& box : boxes) {
        if (box.name.rfind(arguments.only, 0) != 0) continue;
        const auto machine =
            machine::load_machine(tests::machine_file_in(arguments.machines, box.name + ".toml"));
        if (!machine) throw std::runtime_error(machine.error().message);
        auto outcome = try_box(box, without_inside(*machine), arguments.fitted, arguments.most_moves,
                               static_cast<std::uint32_t>(arguments.seed), data, print_progress);
        if (!outcome) {
            fmt::print("{}: {}\n", box.name, outcome.error().message);
            continue;
        }
        count(*outcome, sums);
        print_outcome(box, *std::move(outcome), arguments);
    }
    fmt::print("\n{} controls and machines, {} with each run within {} % and {} % in the mean\n", sums.boxes,
               sums.good, kMost_percent, kMean_percent);
    fmt::print("{} runs foretold, {} within {} %, {:.2f} % off in the mean\n", sums.runs, sums.within,
               kMost_percent, sums.percent / std::max(1.0, static_cast<double>(sums.runs)));
    return sums.good == sums.boxes ? kGood : kExitFailed;
}

}  // namespace

}  // namespace gsim::calibrate

int main(int argc, char** argv) {
    using namespace gsim;
    try {
        calibrate::Arguments arguments;
        apps::CommandLine line("gsim-black-box",
                               "Fits generic models to recorded controls, and tells how near they foretell");
        calibrate::add_options(line, arguments);
        const auto parsed = apps::parse(line, std::vector<std::string>(argv + 1, argv + argc));
        if (!parsed) throw std::runtime_error(parsed.error().message);
        if (*parsed) return **parsed;
        return calibrate::run(arguments);
    } catch (const std::exception& error) {
        fmt::print(stderr, "gsim-black-box: {}\n", error.what());
        return calibrate::kUsage;
    }
}
