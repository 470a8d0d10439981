#include "engine/machine.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "analysis/check/machine_check.h"
#include "analysis/envelope/outline_files.h"
#include "analysis/envelope/stl.h"
#include "analysis/envelope/volume.h"
#include "base/text/nearest_name.h"
#include "base/units.h"
#include "engine/src/conversions.h"
#include "engine/src/guard_exceptions.h"
#include "engine/src/machine/machine_parts.h"
#include "engine/src/run/run_cell.h"
#include "machine/file/machine_file.h"
#include "motion/kinematics/pose.h"

namespace gsim::engine {

using text::DiagnosticKind;

namespace {

FramePose to_frame_pose(const rrs::CartPos& base, const rrs::CartPos& pose) {
    const kinematics::Rpy rpy = kinematics::rpy_from_pose(base.inverse(Eigen::Isometry) * pose);
    return {{rpy.x_mm, rpy.y_mm, rpy.z_mm},
            {rpy.roll_rad / kRadPerDeg, rpy.pitch_rad / kRadPerDeg, rpy.yaw_rad / kRadPerDeg}};
}

}  // namespace

class Machine::State {
  public:
    State(ResolvedRequest found, MachineInput input) : parts_{std::move(found), std::move(input)} {}

    const Parts& parts() const { return parts_; }
    const machine::Machine& machine() const { return parts_.input.machine; }

    tl::expected<void, Error> read_bodies() {
        auto cell = read_cell_contents(make_cell_source(parts_.found), machine());
        if (!cell)
            return tl::unexpected(
                make_error(DiagnosticKind::input_file, cell.error(), parts_.found.request.cell));
        parts_.bodies = std::make_shared<const cell::Cell>(*std::move(cell));
        return {};
    }

    tl::expected<FramePose, Error> frame_in_work(const std::string& name) const {
        const auto unexpected_error = [&](const std::string& reason) {
            return tl::unexpected(make_error(DiagnosticKind::input_file, reason, parts_.found.request.cell));
        };
        if (parts_.bodies == nullptr) return unexpected_error("the cell has not been read");
        const cell::FrameTree& frames = parts_.bodies->frames;
        const auto frame = frames.find(name);
        if (!frame) {
            const std::vector<std::string_view> names = frames.names();
            const auto nearest = text::nearest_name(name, names);
            return unexpected_error(
                fmt::format("the cell has no frame or object '{}'{}", name,
                            nearest ? fmt::format("; did you mean '{}'?", *nearest) : ""));
        }
        const std::size_t work = frames.find("work").value();
        if (frames.link(*frame) != frames.link(work))
            return unexpected_error(fmt::format("'{}' does not move with the workpiece", name));
        return to_frame_pose(frames.pose_in_link(work), frames.pose_in_link(*frame));
    }

    tl::expected<MachineCheck, Error> check() const {
        const auto bodies = engine::read_bodies(make_cell_source(parts_.found), machine());
        if (!bodies) return tl::unexpected(make_error(DiagnosticKind::input_file, bodies.error()));
        const check::MachineCheck found = check::check_machine(machine(), *bodies);
        return MachineCheck{found.is_clean(), check::to_json(found), check::to_text(found)};
    }

    tl::expected<std::string, Error> envelope(EnvelopeKind kind) {
        if (!chain_) {
            auto chain = envelope::envelope_chain(machine());
            if (!chain) return tl::unexpected(make_error(DiagnosticKind::input_file, chain.error()));
            chain_ = *std::move(chain);
        }
        if (kind == EnvelopeKind::volume_stl) return envelope::to_stl(volume().surface);
        return kind == EnvelopeKind::outlines_csv ? envelope::to_csv(machine(), outlines())
                                                  : envelope::to_svg(machine(), outlines());
    }

    std::string envelope_summary() const {
        std::string text;
        if (volume_) {
            text +=
                fmt::format("volume: {:.6g} l, {} triangles, ", envelope::volume_mm3(volume_->surface) / 1e6,
                            volume_->surface.triangles.size());
            text += volume_->step_mm > 0 ? fmt::format("within {:.3g} mm (grid of {:.3g} mm)\n",
                                                       volume_->error_mm, volume_->step_mm)
                                         : std::string("exact\n");
        }
        if (!outlines_) return text;
        double error_mm = 0;
        for (const envelope::PairOutline& outline : *outlines_)
            error_mm = std::max(error_mm, outline.error_mm);
        return text +
               fmt::format("pairs of axes: {}, outlines within {:.3g} mm\n", outlines_->size(), error_mm);
    }

  private:
    const envelope::Volume& volume() {
        if (!volume_) volume_ = envelope::reached_volume(*chain_);
        return *volume_;
    }
    const std::vector<envelope::PairOutline>& outlines() {
        if (!outlines_) outlines_ = envelope::pair_outlines(*chain_, machine::home_position(machine()));
        return *outlines_;
    }

    Parts parts_;
    std::optional<envelope::TcpChain> chain_;
    std::optional<envelope::Volume> volume_;
    std::optional<std::vector<envelope::PairOutline>> outlines_;
};

tl::expected<Machine, Error> Machine::read(const Request& request) {
    return guard_exceptions([&]() -> tl::expected<Machine, Error> {
        auto found = resolve_machine_files(request);
        if (!found)
            return tl::unexpected(make_error(DiagnosticKind::input_file, found.error(), request.cell));
        auto input = read_machine_input(request.host, found->request.machine, found->machine_named_by);
        if (!input)
            return tl::unexpected(
                make_error(DiagnosticKind::input_file, input.error(), found->request.machine));
        return Machine(std::make_unique<State>(*std::move(found), *std::move(input)));
    });
}

Machine::Machine(std::unique_ptr<State> state) : state_(std::move(state)) {}
Machine::Machine(Machine&&) noexcept = default;
Machine& Machine::operator=(Machine&&) noexcept = default;
Machine::~Machine() = default;

const std::vector<std::string>& Machine::notes() const {
    return state_->parts().input.notes;
}

std::vector<Diagnostic> Machine::diagnostics() const {
    std::vector<Diagnostic> diagnostics;
    for (const text::Diagnostic& diagnostic : machine_diagnostics(state_->parts().input))
        diagnostics.push_back(to_diagnostic(diagnostic));
    return diagnostics;
}

const std::string& Machine::machine_file() const {
    return state_->parts().found.request.machine;
}

const std::string& Machine::machine_data_file() const {
    return state_->parts().found.request.machine_data;
}

const std::string& Machine::dialect() const {
    return state_->machine().program.dialect;
}

std::string Machine::file() const {
    return machine::print_machine(state_->machine());
}

tl::expected<FramePose, Error> Machine::frame_in_work(const std::string& name) const {
    return guard_exceptions([&] { return state_->frame_in_work(name); });
}

tl::expected<void, Error> Machine::read_bodies() {
    return guard_exceptions([this] { return state_->read_bodies(); });
}

const Machine::Parts& Machine::parts() const {
    return state_->parts();
}

tl::expected<MachineCheck, Error> Machine::check() const {
    return guard_exceptions([this] { return state_->check(); });
}

tl::expected<std::string, Error> Machine::envelope(EnvelopeKind kind) {
    return guard_exceptions([&] { return state_->envelope(kind); });
}

std::string Machine::envelope_summary() const {
    return state_->envelope_summary();
}

tl::expected<std::string, Error> Machine::axes_svg() const {
    return guard_exceptions(
        [this]() -> tl::expected<std::string, Error> { return check::axes_svg(state_->machine()); });
}

}  // namespace gsim::engine
