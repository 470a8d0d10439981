#include "apps/machine_studies.h"

#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "apps/sentence_of.h"
#include "base/os/output_file.h"
#include "base/text/letter_case.h"
#include "base/text/printable.h"
#include "cli/exit_status.h"
#include "cli/print.h"

namespace gsim::apps {

namespace {

using engine::EnvelopeKind;

std::string ending_of(const std::string& file) {
    return text::lower(std::filesystem::path(file).extension().string());
}

std::optional<EnvelopeKind> kind_of(const std::string& file) {
    const std::string ending = ending_of(file);
    if (ending == ".stl") return EnvelopeKind::volume_stl;
    if (ending == ".csv") return EnvelopeKind::outlines_csv;
    if (ending == ".svg") return EnvelopeKind::outlines_svg;
    return std::nullopt;
}

tl::expected<int, std::string> print_check(const engine::Machine& machine, const StudyOutput& output) {
    return machine.check().map_error(sentence_of).map([&](const engine::MachineCheck& found) {
        if (output.json) {
            print(found.json);
        } else if (!output.quiet) {
            print(text::printable(found.text));
        }
        return found.clean ? kDone : kProgramFault;
    });
}

tl::expected<void, std::string> write_envelopes(const std::vector<std::string>& files,
                                                engine::Machine& machine, const StudyOutput& output) {
    for (const std::string& file : files) {
        if (!kind_of(file))
            return tl::unexpected(fmt::format("{}: an envelope's file ends in .stl, .csv or .svg", file));
        if (auto writable = os::OutputFile::check(file); !writable) return writable;
    }
    for (const std::string& file : files) {
        const auto contents = machine.envelope(*kind_of(file)).map_error(sentence_of);
        if (!contents) return tl::unexpected(contents.error());
        if (auto written = os::write_file(file, *contents); !written) return written;
    }
    if (!output.json && !output.quiet) print(machine.envelope_summary());
    return {};
}

tl::expected<void, std::string> draw_axes(const std::string& file, const engine::Machine& machine) {
    if (ending_of(file) != ".svg")
        return tl::unexpected(fmt::format("{}: the picture of the axes is a file that ends in .svg", file));
    return machine.axes_svg().map_error(sentence_of).and_then([&](const std::string& svg) {
        return os::write_file(file, svg);
    });
}

}  // namespace

void add_study_options(CommandLine& line, MachineStudies& studies) {
    line.add(
            "--check-machine", &studies.check,
            "check this machine file, without a program: limits, inverse, singular ranges, collisions of its "
            "bodies (with --cell: of the cell's) whatever the joints do")
        .of_file(FileKind::input, {".toml"});
    line.add(
            "--envelope", &studies.envelopes,
            "write what the tool's tip can reach, without a program, to this .stl file (the volume), .csv or "
            ".svg file (for each pair of joints); may be given several times")
        .of_file(FileKind::output, {".stl", ".csv", ".svg"});
    line.add("--draw-axes", &studies.axes,
             "draw which way each axis moves the tool, without a program, into this .svg file")
        .of_file(FileKind::output, {".svg"});
}

tl::expected<int, std::string> run_studies(const MachineStudies& studies, engine::Machine& machine,
                                           const StudyOutput& output) {
    int status = kDone;
    if (!studies.check.empty()) {
        auto checked = print_check(machine, output);
        if (!checked) return checked;
        status = *checked;
    }
    if (!studies.axes.empty()) {
        if (auto drawn = draw_axes(studies.axes, machine); !drawn) return tl::unexpected(drawn.error());
    }
    if (studies.envelopes.empty()) return status;
    return write_envelopes(studies.envelopes, machine, output).map([status] { return status; });
}

}  // namespace gsim::apps
