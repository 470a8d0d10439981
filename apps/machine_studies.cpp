#include "apps/machine_studies.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "apps/exit_status.h"
#include "apps/print.h"
#include "base/os/output_file.h"
#include "base/text/letter_case.h"
#include "base/text/printable.h"
#include "runtime/check/machine_check.h"
#include "runtime/envelope/outline_files.h"
#include "runtime/envelope/stl.h"
#include "runtime/envelope/volume.h"

namespace gsim::apps {

namespace {

tl::expected<int, std::string> print_check(const machine::Machine& machine, const CellChoice& choice,
                                           const StudyOutput& output) {
    const tl::expected<cell::Cell, std::string> bodies = read_bodies(choice, machine);
    if (!bodies) return tl::unexpected(bodies.error());
    const check::MachineCheck found = check::check_machine(machine, *bodies);
    if (output.json) {
        print(check::to_json(found));
    } else if (!output.quiet) {
        print(text::printable(check::to_text(found)));
    }
    return found.is_clean() ? kDone : kProgramFault;
}

/// The contents of envelope files; each kind is made once, however many files want it.
class Envelope {
  public:
    Envelope(const machine::Machine& machine, envelope::TipChain chain)
        : machine_(machine), chain_(std::move(chain)) {}

    static bool is_known(const std::string& file) {
        const std::string ending = ending_of(file);
        return ending == ".stl" || ending == ".csv" || ending == ".svg";
    }

    std::string contents(const std::string& file) {
        const std::string ending = ending_of(file);
        if (ending == ".stl") return envelope::to_stl(volume().surface);
        return ending == ".csv" ? envelope::to_csv(machine_, outlines())
                                : envelope::to_svg(machine_, outlines());
    }

    /// How exact it is, in sentences for people.
    std::string summary() const {
        std::string text;
        if (volume_) {
            text +=
                fmt::format("volume: {:.6g} l, {} triangles, ", envelope::volume_mm3(volume_->surface) / 1e6,
                            volume_->surface.triangles.size());
            text += volume_->step_mm > 0 ? fmt::format("to {:.3g} mm (grid of {:.3g} mm)\n",
                                                       volume_->error_mm, volume_->step_mm)
                                         : std::string("exact\n");
        }
        if (outlines_) {
            double error_mm = 0;
            for (const envelope::PairOutline& outline : *outlines_)
                error_mm = std::max(error_mm, outline.error_mm);
            text += fmt::format("pairs of axes: {}, outlines to {:.3g} mm\n", outlines_->size(), error_mm);
        }
        return text;
    }

  private:
    static std::string ending_of(const std::string& file) {
        return text::lower(std::filesystem::path(file).extension().string());
    }

    const envelope::Volume& volume() {
        if (!volume_) volume_ = envelope::reached_volume(chain_);
        return *volume_;
    }
    const std::vector<envelope::PairOutline>& outlines() {
        if (!outlines_) outlines_ = envelope::pair_outlines(chain_, machine::home_position(machine_));
        return *outlines_;
    }

    const machine::Machine& machine_;
    envelope::TipChain chain_;
    std::optional<envelope::Volume> volume_;
    std::optional<std::vector<envelope::PairOutline>> outlines_;
};

tl::expected<void, std::string> write_envelopes(const std::vector<std::string>& files,
                                                const machine::Machine& machine, const StudyOutput& output) {
    for (const std::string& file : files) {
        if (!Envelope::is_known(file))
            return tl::unexpected(fmt::format("{}: an envelope's file ends in .stl, .csv or .svg", file));
        if (auto writable = os::OutputFile::check(file); !writable) return writable;
    }
    auto chain = envelope::envelope_chain(machine);
    if (!chain) return tl::unexpected(chain.error());
    Envelope envelope(machine, *std::move(chain));
    for (const std::string& file : files) {
        if (auto written = os::write_file(file, envelope.contents(file)); !written) return written;
    }
    if (!output.json && !output.quiet) print(envelope.summary());
    return {};
}

tl::expected<void, std::string> draw_axes(const std::string& file, const machine::Machine& machine) {
    if (text::lower(std::filesystem::path(file).extension().string()) != ".svg")
        return tl::unexpected(fmt::format("{}: the picture of the axes is a file that ends in .svg", file));
    return os::write_file(file, check::axes_svg(machine));
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

tl::expected<int, std::string> run_studies(const MachineStudies& studies, const machine::Machine& machine,
                                           const CellChoice& cell, const StudyOutput& output) {
    int status = kDone;
    if (!studies.check.empty()) {
        auto checked = print_check(machine, cell, output);
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
