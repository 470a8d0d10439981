#include "calibrate/servo_command.h"

#include <algorithm>
#include <memory>
#include <string_view>

#include <fmt/format.h>

#include "base/os/input_file.h"
#include "base/text/printable.h"
#include "calibrate/command.h"
#include "calibrate/servo/servo_fit.h"
#include "calibrate/servo/servo_record.h"
#include "cli/print.h"
#include "machine/file/machine_file.h"

namespace gsim::calibrate {

namespace {

struct ServoArguments {
    std::string record;
    std::string machine;
    std::string output;
    ServoFormat columns_format;
    double sample_period_ms = 0;
};

void add_servo_options(apps::CommandLine& line, ServoArguments& arguments) {
    line.add("record", &arguments.record,
             "set points and actual positions of axes over time: CSV with t_s, x_mm and x_at_mm or "
             "x_error_mm, or the output of halsampler")
        .takes_file(apps::FileKind::input, {".csv", ".txt"})
        .make_required();
    line.add("--machine", &arguments.machine, "machine file to which the servo loops of the axes are added")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::input, {".toml"})
        .make_required();
    line.add("-o,--output", &arguments.output, "the machine file with the loops; default: standard output")
        .with_value_name("FILE")
        .takes_file(apps::FileKind::output, {".toml"})
        .may_share_file_with("--machine");
    line.add("--sample-period", &arguments.sample_period_ms,
             "time between samples of recordings without times (halsampler)")
        .with_value_name("MS")
        .within(0.001, 60'000);
    line.add("--sample-columns", &arguments.columns_format.columns,
             "columns of such recordings, one letter each: X the set point of X, x its actual position; '-': "
             "ignored")
        .with_value_name("XxYy")
        .show_default();
}

/// Returns the report on an axis.
std::string report_text(const ServoFit& fit, const machine::Axis& axis) {
    const bool turns = axis.kind == machine::AxisKind::rotary;
    const std::string_view unit = turns ? "mdeg" : "um";
    std::string text = fmt::format("{}: the following error is {:.4g} {} (rms), the residual is {:.3g}\n",
                                   fit.letter, 1000 * fit.error_rms, unit, 1000 * fit.residual_rms);
    for (const FittedServoParameter& parameter : fit.fitted_parameters)
        text += fmt::format("  {} = {:.6g} +- {:.2g} (one standard deviation)\n", parameter.key,
                            parameter.value, parameter.standard_deviation);
    return text;
}

Result<void> fit_all(const ServoArguments& arguments) {
    auto machine = read_machine_argument(arguments.machine);
    if (!machine) return tl::unexpected(machine.error());
    const auto text = os::read_text_file(arguments.record);
    if (!text) return tl::unexpected(text.error());
    ServoFormat columns_format = arguments.columns_format;
    columns_format.period_s = arguments.sample_period_ms / 1000;
    const auto records = read_servo_record(*text, columns_format);
    if (!records) return Unexpected(fmt::format("{}: {}", arguments.record, records.error().message));
    std::size_t fitted_count = 0;
    for (const AxisRecord& record : *records) {
        const auto axis =
            std::find_if(machine->axes.begin(), machine->axes.end(),
                         [&](const machine::Axis& each) { return each.letter == record.letter; });
        if (axis == machine->axes.end())
            return Unexpected(fmt::format("{} has no axis {}", arguments.machine, record.letter));
        const auto fit = fit_servo(record);
        if (!fit) {
            apps::print_to_standard_error(
                fmt::format("{}: {}; its parameters are unchanged\n", record.letter, fit.error().message));
            continue;
        }
        apps::print_to_standard_error(text::printable(report_text(*fit, *axis)));
        axis->servo = fit->servo;
        ++fitted_count;
    }
    if (fitted_count == 0) return Unexpected(fmt::format("{} determines no servo loop", arguments.record));
    return write_or_print(arguments.output, machine::print_machine(*machine));
}

}  // namespace

void add_servo_command(apps::CommandLine& line, SelectedCommand& selected) {
    const auto arguments = std::make_shared<ServoArguments>();
    add_servo_options(
        add_command(line, selected, "servo",
                    "identify the servo loops of axes from their set points and actual positions",
                    [arguments] { return fit_all(*arguments); }),
        *arguments);
    line.add_example("gsim-calibrate servo servo.csv --machine mine.toml -o followed.toml",
                     "gains, lags and feed-forward of the axes in the recording");
}

}  // namespace gsim::calibrate
