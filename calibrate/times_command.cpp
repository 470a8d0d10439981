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
#include "calibrate/times/fit_output.h"
#include "calibrate/times/model_selection.h"
#include "cli/print.h"
#include "machine/file/machine_file.h"
#include "machine/model/torque_limit.h"

namespace gsim::calibrate {

namespace {

constexpr std::size_t kMinRuns = 4;

struct Arguments {
    std::string runs;
    std::string machine;
    ReadingOptions reading_options;
    RecordFormat record_format;
    double sample_period_ms = 0;
    std::string output;
    std::string json;
    std::string picture;
    std::string program;
    std::uint64_t parts = 3;
    FreeParameters open;
    bool keep_model = false;
    bool quiet = false;
};

void add_options(apps::CommandLine& line, Arguments& arguments) {
    line.add("runs", &arguments.runs,
             "list of recorded runs, one per line: program,time_s after a line that names the columns")
        .takes_file(apps::FileKind::input, {".csv", ".tsv"})
        .make_required();
    line.add("--machine", &arguments.machine,
             "machine file to start with: known parameters of the machine, and estimates of the unknown ones")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::input, {".toml"})
        .make_required();
    line.add("--dialect", &arguments.reading_options.dialect,
             "language of the programs; default: as in the machine file")
        .with_value_name("NAME");
    line.add("--machine-data", &arguments.reading_options.machine_data,
             "tools and offsets that the programs use")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::input, {".txt", ".tbl"});
    line.add("--sample-period", &arguments.sample_period_ms,
             "time between samples of recordings without times (halsampler)")
        .with_value_name("MS")
        .within(0.001, 60'000);
    line.add("--sample-columns", &arguments.record_format.columns,
             "columns of such recordings, one letter each; '-': ignored")
        .with_value_name("XYZ")
        .show_default();
    line.add("-o,--output", &arguments.output, "the fitted machine file; default: standard output")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::output, {".toml"})
        .may_share_file_with("--machine");
    line.add("--json", &arguments.json, "values, covariance, runs and models as JSON")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::output, {".json"});
    line.add("--picture", &arguments.picture, "picture of the residuals of each run")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::output, {".svg"});
    line.add(
            "--test-program", &arguments.program,
            "part program for the parameters that these runs do not determine; not written if there are none")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::output, {".nc", ".ngc"});
    line.add("--parts", &arguments.parts, "number of parts of the cross-validation that selects the model")
        .with_value_name("N")
        .within(2, 20)
        .show_default();
    line.add("--keep-model", &arguments.keep_model,
             "keep the machine file's controller, and fit its parameters; otherwise generic controllers are "
             "tried");
    line.add("--each-axis", &arguments.open.each_axis,
             "separate parameters for each axis, even if the axes start with equal ones");
    line.add("--speeds", &arguments.open.speeds,
             "also fit the speeds of axes and along the path: those of the machine file are estimates");
    line.add("-q,--quiet", &arguments.quiet, "no progress");
}

/// Data that are known before a fit.
struct FitInputs {
    machine::Machine machine;
    std::vector<RecordedRun> runs;
};

bool has_positions(const RecordedRun& run) {
    return !run.samples.empty();
}

Result<void> add_records(const RecordFormat& record_format, std::vector<RecordedRun>& runs) {
    for (RecordedRun& run : runs) {
        if (run.record.empty()) continue;
        const auto text = os::read_text_file(run.record);
        if (!text) return tl::unexpected(text.error());
        if (const auto result = add_record(*text, record_format, run); !result)
            return Unexpected(fmt::format("{}: {}", run.record, result.error().message));
    }
    return {};
}

Result<FitInputs> read_fit_inputs(const Arguments& arguments) {
    auto machine = read_machine_argument(arguments.machine);
    if (!machine) return tl::unexpected(machine.error());
    if (machine::is_torque_limited(*machine))
        return Unexpected(
            fmt::format("{}: accelerations of axes cannot be fitted if torques limit them ('limit = "
                        "\"torque\"' of [dynamics])",
                        arguments.machine));
    const auto list = os::read_text_file(arguments.runs);
    if (!list) return tl::unexpected(list.error());
    const std::size_t slash = arguments.runs.rfind('/');
    const std::string folder = slash == std::string::npos ? "" : arguments.runs.substr(0, slash);
    auto runs = read_recorded_runs(*list, folder);
    if (!runs) return Unexpected(fmt::format("{}: {}", arguments.runs, runs.error().message));
    RecordFormat record_format = arguments.record_format;
    record_format.period_s = arguments.sample_period_ms / 1000;
    if (const auto result = add_records(record_format, *runs); !result) return tl::unexpected(result.error());
    const bool are_sufficient =
        arguments.keep_model && std::all_of(runs->begin(), runs->end(), has_positions);
    if (runs->size() < kMinRuns && !are_sufficient) {
        return Unexpected(
            fmt::format("{} has {} runs: a fit requires at least {}, and determines each parameter better "
                        "with 10 or more; with positions over time and --keep-model one is enough",
                        arguments.runs, runs->size(), kMinRuns));
    }
    return FitInputs{*std::move(machine), *std::move(runs)};
}

Result<void> write_all(const Arguments& arguments, const FitInputs& inputs, const Fit& fit,
                       const std::optional<ModelSelection>& selection) {
    const std::string machine = machine_text(fit, inputs.runs);
    const std::string program = test_program(fit);
    return write_or_print(arguments.output, machine)
        .and_then([&] { return write_if_named(arguments.json, fit_json(fit, inputs.runs, selection)); })
        .and_then([&] { return write_if_named(arguments.picture, residuals_svg(fit, inputs.runs)); })
        .and_then([&] { return write_if_named(program.empty() ? "" : arguments.program, program); });
}

Result<void> fit_to_times(const Arguments& arguments) {
    const auto print_to_standard_error = [&](const std::string& words) {
        if (!arguments.quiet) apps::print_to_standard_error(text::printable(words + '\n'));
    };
    auto inputs = read_fit_inputs(arguments);
    if (!inputs) return tl::unexpected(inputs.error());
    const auto predictor = Predictor::of(inputs->runs, arguments.reading_options, inputs->machine);
    if (!predictor) return tl::unexpected(predictor.error());
    std::optional<ModelSelection> selection;
    FreeParameters open = arguments.open;
    if (!arguments.keep_model) {
        auto selected = select_model(generic_candidates(inputs->machine, open), inputs->runs, *predictor,
                                     std::min<std::size_t>(arguments.parts, inputs->runs.size()),
                                     print_to_standard_error);
        if (!selected) return tl::unexpected(selected.error());
        selection = *std::move(selected);
        inputs->machine = selection->candidate.machine;
        open = selection->candidate.open;
        print_to_standard_error(fmt::format("chosen: {}", selection->candidate.name));
    }
    const auto fit = fit_times(inputs->machine, inputs->runs, *predictor, {.open = open, .multi_start = true},
                               print_to_standard_error);
    if (!fit) return tl::unexpected(fit.error());
    print_to_standard_error(fit_table(*fit, inputs->runs));
    return write_all(arguments, *inputs, *fit, selection);
}

}  // namespace

void add_times_command(apps::CommandLine& line, SelectedCommand& selected) {
    const auto arguments = std::make_shared<Arguments>();
    add_options(
        add_command(line, selected, "times", "fit the open parameters of a machine file to recorded runs",
                    [arguments] { return fit_to_times(*arguments); }),
        *arguments);
    line.add_example("gsim-calibrate times runs.csv --machine mine.toml -o fitted.toml",
                     "accelerations, corners and so on from the times of programs");
}

}  // namespace gsim::calibrate
