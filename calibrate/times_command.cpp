#include "calibrate/times_command.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <tl/expected.hpp>

#include "base/os/input_file.h"
#include "base/text/printable.h"
#include "calibrate/command.h"
#include "calibrate/times/choice.h"
#include "calibrate/times/outcome.h"
#include "cli/print.h"
#include "machine/file/machine_file.h"
#include "machine/model/torque_limit.h"

namespace gsim::calibrate {

namespace {

constexpr std::size_t kLeastRuns = 4;

struct Arguments {
    std::string runs;
    std::string machine;
    Reading reading;
    RecordForm form;
    double sample_period_ms = 0;
    std::string output;
    std::string json;
    std::string picture;
    std::string program;
    std::uint64_t parts = 3;
    OpenFigures open;
    bool keep_model = false;
    bool quiet = false;
};

void add_options(apps::CommandLine& line, Arguments& arguments) {
    line.add("runs", &arguments.runs,
             "list of recorded runs, one a line: program,time_s under a line that names the columns")
        .of_file(apps::FileKind::input, {".csv", ".tsv"})
        .must_be_given();
    line.add("--machine", &arguments.machine,
             "machine file to begin with: what is known of the machine, and a guess of what is not")
        .called("FILE")
        .of_file(apps::FileKind::input, {".toml"})
        .must_be_given();
    line.add("--dialect", &arguments.reading.dialect,
             "language of the programs; else as the machine file says")
        .called("NAME");
    line.add("--machine-data", &arguments.reading.machine_data, "tools and offsets that the programs use")
        .called("FILE")
        .of_file(apps::FileKind::input, {".txt", ".tbl"});
    line.add("--sample-period", &arguments.sample_period_ms,
             "time between samples of recordings that have no times (halsampler)")
        .called("MS")
        .within(0.001, 60'000);
    line.add("--sample-columns", &arguments.form.columns,
             "what the columns of such recordings are, a letter each; '-': nothing that counts")
        .called("XYZ")
        .shows_default();
    line.add("-o,--output", &arguments.output, "the fitted machine file; else standard output")
        .called("FILE")
        .of_file(apps::FileKind::output, {".toml"})
        .may_be_file_of("--machine");
    line.add("--json", &arguments.json, "values, covariance, runs and models as JSON")
        .called("FILE")
        .of_file(apps::FileKind::output, {".json"});
    line.add("--picture", &arguments.picture, "what is left of the errors, run by run, as a picture")
        .called("FILE")
        .of_file(apps::FileKind::output, {".svg"});
    line.add("--test-program", &arguments.program,
             "part program that tells what these runs do not; not written where there is nothing")
        .called("FILE")
        .of_file(apps::FileKind::output, {".nc", ".ngc"});
    line.add("--parts", &arguments.parts, "parts of the cross-validation that chooses the model")
        .called("N")
        .within(2, 20)
        .shows_default();
    line.add("--keep-model", &arguments.keep_model,
             "keep the machine file's controller, and fit its figures; else generic ones are tried");
    line.add("--each-axis", &arguments.open.each_axis,
             "figures of each axis by themselves, where axes begin with the same");
    line.add("--speeds", &arguments.open.speeds,
             "speeds of axes and along the path, too: those of the machine file are guesses");
    line.add("-q,--quiet", &arguments.quiet, "no word on the way");
}

/// Data that are known before a fit.
struct Task {
    machine::Machine machine;
    std::vector<RecordedRun> runs;
};

bool has_positions(const RecordedRun& run) {
    return !run.samples.empty();
}

Done add_records(const RecordForm& form, std::vector<RecordedRun>& runs) {
    for (RecordedRun& run : runs) {
        if (run.record.empty()) continue;
        const auto text = os::read_text_file(run.record);
        if (!text) return tl::unexpected(text.error());
        if (const auto added = add_record(*text, form, run); !added)
            return tl::unexpected(fmt::format("{}: {}", run.record, added.error()));
    }
    return {};
}

tl::expected<Task, std::string> read_task(const Arguments& arguments) {
    auto machine = machine::load_machine(arguments.machine);
    if (!machine) return tl::unexpected(machine.error());
    if (machine::is_torque_limited(*machine))
        return tl::unexpected(
            fmt::format("{}: accelerations of axes are not fitted where torques limit them "
                        "('limit = \"torque\"' of [dynamics])",
                        arguments.machine));
    const auto list = os::read_text_file(arguments.runs);
    if (!list) return tl::unexpected(list.error());
    const std::size_t slash = arguments.runs.rfind('/');
    const std::string folder = slash == std::string::npos ? "" : arguments.runs.substr(0, slash);
    auto runs = read_recorded_runs(*list, folder);
    if (!runs) return tl::unexpected(fmt::format("{}: {}", arguments.runs, runs.error()));
    RecordForm form = arguments.form;
    form.period_s = arguments.sample_period_ms / 1000;
    if (const auto added = add_records(form, *runs); !added) return tl::unexpected(added.error());
    const bool tell_enough = arguments.keep_model && std::all_of(runs->begin(), runs->end(), has_positions);
    if (runs->size() < kLeastRuns && !tell_enough) {
        return tl::unexpected(fmt::format(
            "{} has {} runs: a fit needs {} at least, and tells more of each figure with 10 or more; with "
            "positions over time and --keep-model one is enough",
            arguments.runs, runs->size(), kLeastRuns));
    }
    return Task{*std::move(machine), *std::move(runs)};
}

Done write_all(const Arguments& arguments, const Task& task, const Fit& fit,
               const std::optional<Choice>& choice) {
    const std::string machine = machine_text(fit, task.runs);
    const std::string program = test_program(fit);
    return write_or_print(arguments.output, machine)
        .and_then([&] { return write_if(arguments.json, fit_json(fit, task.runs, choice)); })
        .and_then([&] { return write_if(arguments.picture, residuals_svg(fit, task.runs)); })
        .and_then([&] { return write_if(program.empty() ? "" : arguments.program, program); });
}

Done fit_to_times(const Arguments& arguments) {
    const auto tell = [&](const std::string& words) {
        if (!arguments.quiet) apps::tell(text::printable(words + '\n'));
    };
    auto task = read_task(arguments);
    if (!task) return tl::unexpected(task.error());
    const auto predictor = Predictor::of(task->runs, arguments.reading, task->machine);
    if (!predictor) return tl::unexpected(predictor.error());
    std::optional<Choice> choice;
    OpenFigures open = arguments.open;
    if (!arguments.keep_model) {
        auto chosen = choose_model(generic_candidates(task->machine, open), task->runs, *predictor,
                                   std::min<std::size_t>(arguments.parts, task->runs.size()), tell);
        if (!chosen) return tl::unexpected(chosen.error());
        choice = *std::move(chosen);
        task->machine = choice->candidate.machine;
        open = choice->candidate.open;
        tell(fmt::format("chosen: {}", choice->candidate.name));
    }
    const auto fit =
        fit_times(task->machine, task->runs, *predictor, {.open = open, .other_starts = true}, tell);
    if (!fit) return tl::unexpected(fit.error());
    tell(fit_table(*fit, task->runs));
    return write_all(arguments, *task, *fit, choice);
}

}  // namespace

void add_times(apps::CommandLine& line, Chosen& chosen) {
    const auto arguments = std::make_shared<Arguments>();
    add_options(add_command(line, chosen, "times", "fit what a machine file leaves open to recorded runs",
                            [arguments] { return fit_to_times(*arguments); }),
                *arguments);
    line.add_example("gsim-calibrate times runs.csv --machine mine.toml -o fitted.toml",
                     "accelerations, corners and so on from how long programs took");
}

}  // namespace gsim::calibrate
