#include "engine/src/run/output_set.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "engine/src/conversions.h"
#include "runtime/outputs/moves_writer.h"
#include "toolpath/json/json_writer.h"

namespace gsim::engine {

using simulation::TextStream;

namespace {

std::optional<Plane> find_plane(std::string_view name) {
    if (name == "xy") return Plane::xy;
    if (name == "zx") return Plane::zx;
    if (name == "yz") return Plane::yz;
    return std::nullopt;
}

std::string quoted_name(const std::string& name) {
    return name.empty() ? name : name + ": ";
}

}  // namespace

TextStream& OutputSet::stream(TextSink sink) {
    return *streams_.emplace_back(std::make_unique<TextStream>(std::move(sink)));
}

void OutputSet::add_output(std::unique_ptr<simulation::RunOutput> output) {
    simulator_.add_output(*outputs_.emplace_back(std::move(output)));
}

Result<void> OutputSet::add(OutputKind output_kind, TextSink sink, const OutputOptions& options) {
    const machine::Machine& machine = simulator_.machine();
    switch (output_kind) {
        case OutputKind::moves:
            add_output(std::make_unique<simulation::MovesWriter>(stream(std::move(sink)), machine,
                                                                 simulator_.program().files().names()));
            return {};
        case OutputKind::trajectory: return add_trajectory(stream(std::move(sink)), options);
        case OutputKind::dxf: {
            auto drawing = std::make_unique<simulation::DxfWriter>(stream(std::move(sink)), machine);
            drawing_ = drawing.get();
            drawing_name_ = options.name;
            add_output(std::move(drawing));
            return {};
        }
        case OutputKind::path: add_path(std::move(sink)); return {};
        case OutputKind::plot: return add_plot(std::move(sink), options);
    }
    return Unexpected("the output does not exist");
}

Result<void> OutputSet::add_trajectory(TextStream& out, const OutputOptions& options) {
    if (auto error = find_step_error(options.step_s)) return tl::unexpected(*std::move(error));
    trajectory_name_ = options.name;
    auto trajectory = std::make_unique<simulation::TrajectoryWriter>(
        out, simulator_.machine(), options.step_s, simulator_.outcome().limits().max_time_s);
    if (options.forces) {
        if (simulator_.monitors().dynamics() == nullptr) return tl::unexpected(std::string(kNoMassesError));
        trajectory->add_efforts(*simulator_.monitors().dynamics());
    }
    if (options.following) {
        const auto setup = simulator_.monitors().following_setup();
        if (!setup) return tl::unexpected(std::string(kNoServosError));
        trajectory->add_following(*setup);
    }
    trajectory_ = trajectory.get();
    add_output(std::move(trajectory));
    return {};
}

Result<void> OutputSet::add_plot(TextSink sink, const OutputOptions& options) {
    const machine::Machine& machine = simulator_.machine();
    const auto plane = find_plane(options.plane);
    if (!plane)
        return Unexpected(fmt::format("'{}' is not a plane of a plot; use xy, zx or yz", options.plane));
    if (auto missing_axes = simulation::PlotData::find_missing_axes_error(machine, *plane))
        return tl::unexpected(*missing_axes);
    plot_ = std::make_unique<Plot>(machine, *plane, options.bitmap, std::move(sink));
    if (simulator_.monitors().dynamics() != nullptr)
        plot_->data.add_efforts(*simulator_.monitors().dynamics());
    if (const auto setup = simulator_.monitors().following_setup()) plot_->data.add_following(*setup);
    simulator_.add_output(plot_->data);
    return {};
}

void OutputSet::add_path(TextSink sink) {
    path_ = std::make_unique<Path>(simulator_.machine(), std::move(sink));
    simulator_.set_observer(path_->recorder);
}

void OutputSet::explain() {
    explanation_data_ = std::make_unique<ExplanationData>(simulator_.machine());
    simulator_.add_output(explanation_data_->times);
    if (simulator_.motion().source().is_sampled()) return;
    simulator_.add_output(explanation_data_->bound.emplace(simulator_.machine()));
}

void OutputSet::complete(simulation::Report& report) const {
    if (path_ != nullptr) {
        const std::set<std::string>& notes = path_->recorder.notes();
        report.messages.warnings.insert(report.messages.warnings.end(), notes.begin(), notes.end());
    }
    if (explanation_data_ == nullptr) return;
    std::optional<double> bound_s;
    if (explanation_data_->bound) bound_s = explanation_data_->bound->bound_s();
    report.explanation =
        simulation::Explanation{explanation_data_->times.list(explanation_data_->machine), bound_s};
}

std::vector<Error> OutputSet::finish(const simulation::Report& report) {
    std::vector<Error> errors;
    for (const auto& stream : streams_) stream->flush();
    if (auto error = check_output_size()) errors.push_back(*std::move(error));
    if (plot_) write_plot(report);
    if (auto written = write_path(report.source.program); !written)
        errors.push_back(make_error(text::DiagnosticKind::path, written.error()));
    return errors;
}

std::optional<Error> OutputSet::check_output_size() const {
    if (trajectory_ != nullptr && trajectory_->is_truncated()) {
        return make_error(
            text::DiagnosticKind::output,
            fmt::format(
                "{}the trajectory would have more than {} samples; increase --step or reduce --max-time",
                quoted_name(trajectory_name_), simulation::TrajectoryWriter::kMaxSamples));
    }
    if (drawing_ != nullptr && drawing_->is_truncated()) {
        return make_error(
            text::DiagnosticKind::output,
            fmt::format("{}the drawing would have more than {} points; does an arc have too many turns?",
                        quoted_name(drawing_name_), simulation::DxfWriter::kMaxPoints));
    }
    return std::nullopt;
}

Result<void> OutputSet::write_path(const std::string& program) {
    if (path_ == nullptr) return {};
    return path_->recorder.finish(std::filesystem::path(program).stem().string())
        .map([this](const path::Program& recorded_program) {
            path::write_json(recorded_program,
                             [this](std::string_view text) { static_cast<void>(path_->sink(text)); });
        })
        .map_error([](const gsim::Error& error) {
            return gsim::Error(fmt::format("no path is recorded: {}", error.message));
        });
}

void OutputSet::write_plot(const simulation::Report& report) {
    if (report.cell) {
        for (const simulation::Collision& collision : report.cell->collisions)
            plot_->data.mark_collision(collision.joints);
    }
    if (report.status == simulation::RunStatus::alarm) plot_->data.mark_alarm();
    static_cast<void>(plot_->sink(plot_script(plot_->data, plot_->format, report.source.program)));
}

}  // namespace gsim::engine
