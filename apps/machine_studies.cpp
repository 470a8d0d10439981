#include "apps/machine_studies.h"

#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "apps/to_error.h"
#include "base/os/output_file.h"
#include "base/text/letter_case.h"
#include "base/text/printable.h"
#include "cli/exit_status.h"
#include "cli/print.h"

namespace gsim::apps {

namespace {

using engine::EnvelopeKind;

std::string file_extension(const std::string& file) {
    return text::lower(std::filesystem::path(file).extension().string());
}

std::optional<EnvelopeKind> envelope_kind(const std::string& file) {
    const std::string file_suffix = file_extension(file);
    if (file_suffix == ".stl") return EnvelopeKind::volume_stl;
    if (file_suffix == ".csv") return EnvelopeKind::outlines_csv;
    if (file_suffix == ".svg") return EnvelopeKind::outlines_svg;
    return std::nullopt;
}

Result<int> print_check(const engine::Machine& machine, const StudyOutput& output) {
    return machine.check().map_error(to_error).map([&](const engine::MachineCheck& found) {
        if (output.json) {
            print(found.json);
        } else if (!output.quiet) {
            print(text::printable(found.text));
        }
        return found.is_clean ? kSuccess : kProgramError;
    });
}

Result<void> write_envelopes(const std::vector<std::string>& files, engine::Machine& machine,
                             const StudyOutput& output) {
    for (const std::string& file : files) {
        if (!envelope_kind(file))
            return Unexpected(
                fmt::format("{}: the file of an envelope must end in .stl, .csv or .svg", file));
        if (auto writable = os::OutputFile::check(file); !writable) return writable;
    }
    for (const std::string& file : files) {
        const auto contents = machine.envelope(*envelope_kind(file)).map_error(to_error);
        if (!contents) return tl::unexpected(contents.error());
        if (auto written = os::write_file(file, *contents); !written) return written;
    }
    if (!output.json && !output.quiet) print(machine.envelope_summary());
    return {};
}

Result<void> draw_axes(const std::string& file, const engine::Machine& machine) {
    if (file_extension(file) != ".svg")
        return Unexpected(fmt::format("{}: the picture of the axes must be a file that ends in .svg", file));
    return machine.axes_svg().map_error(to_error).and_then(
        [&](const std::string& svg) { return os::write_file(file, svg); });
}

}  // namespace

void add_study_options(CommandLine& line, MachineStudies& studies) {
    line.add("--check-machine", &studies.check,
             "check this machine file, without a program: limits, inverse, singular ranges, collisions of "
             "its bodies (with --cell: of the cell's) for all joint values")
        .takes_file(FileKind::input, {".toml"});
    line.add("--envelope", &studies.envelopes,
             "write the range of the TCP, without a program, to this .stl file (the volume), .csv or .svg "
             "file (for each pair of joints); may be given more than once")
        .takes_file(FileKind::output, {".stl", ".csv", ".svg"});
    line.add("--draw-axes", &studies.axes,
             "draw the direction in which each axis moves the tool, without a program, to this .svg file")
        .takes_file(FileKind::output, {".svg"});
}

Result<int> run_studies(const MachineStudies& studies, engine::Machine& machine, const StudyOutput& output) {
    int status = kSuccess;
    if (!studies.check.empty()) {
        auto checked = print_check(machine, output);
        if (!checked) return checked;
        status = *checked;
    }
    if (!studies.axes.empty()) {
        if (auto result = draw_axes(studies.axes, machine); !result) return tl::unexpected(result.error());
    }
    if (studies.envelopes.empty()) return status;
    return write_envelopes(studies.envelopes, machine, output).map([status] { return status; });
}

}  // namespace gsim::apps
