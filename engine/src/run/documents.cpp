#include "engine/src/run/documents.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "engine/src/values.h"
#include "runtime/outputs/moves_writer.h"
#include "toolpath/json/json_writer.h"

namespace gsim::engine {

using simulation::TextStream;

namespace {

std::optional<Plane> plane_named(std::string_view name) {
    if (name == "xy") return Plane::xy;
    if (name == "zx") return Plane::zx;
    if (name == "yz") return Plane::yz;
    return std::nullopt;
}

std::string named(const std::string& name) {
    return name.empty() ? name : name + ": ";
}

}  // namespace

TextStream& Documents::stream(TextSink sink) {
    return *streams_.emplace_back(std::make_unique<TextStream>(std::move(sink)));
}

void Documents::add_output(std::unique_ptr<simulation::RunOutput> output) {
    simulator_.add_output(*outputs_.emplace_back(std::move(output)));
}

tl::expected<void, std::string> Documents::add(Document document, TextSink sink,
                                               const DocumentOptions& options) {
    const machine::Machine& machine = simulator_.machine();
    switch (document) {
        case Document::moves:
            add_output(std::make_unique<simulation::MovesWriter>(stream(std::move(sink)), machine,
                                                                 simulator_.files()));
            return {};
        case Document::trajectory: return add_trajectory(stream(std::move(sink)), options);
        case Document::dxf: {
            auto drawing = std::make_unique<simulation::DxfWriter>(stream(std::move(sink)), machine);
            drawing_ = drawing.get();
            drawing_name_ = options.name;
            add_output(std::move(drawing));
            return {};
        }
        case Document::path: add_path(std::move(sink)); return {};
        case Document::plot: return add_plot(std::move(sink), options);
    }
    return tl::unexpected(std::string("there is no such document"));
}

tl::expected<void, std::string> Documents::add_trajectory(TextStream& out, const DocumentOptions& options) {
    if (auto fault = fault_of_step(options.step_s)) return tl::unexpected(*std::move(fault));
    trajectory_name_ = options.name;
    auto trajectory = std::make_unique<simulation::TrajectoryWriter>(out, simulator_.machine(),
                                                                     options.step_s, simulator_.max_time_s());
    if (options.forces) {
        if (simulator_.dynamics() == nullptr) return tl::unexpected(std::string(kNoMasses));
        trajectory->add_efforts(*simulator_.dynamics());
    }
    if (options.following) {
        const auto setup = simulator_.following_setup();
        if (!setup) return tl::unexpected(std::string(kNoServos));
        trajectory->add_following(*setup);
    }
    trajectory_ = trajectory.get();
    add_output(std::move(trajectory));
    return {};
}

tl::expected<void, std::string> Documents::add_plot(TextSink sink, const DocumentOptions& options) {
    const machine::Machine& machine = simulator_.machine();
    const auto plane = plane_named(options.plane);
    if (!plane)
        return tl::unexpected(
            fmt::format("'{}' is no plane of a plot; there are xy, zx and yz", options.plane));
    if (auto lacks = simulation::PlotData::lacks_axes(machine, *plane)) return tl::unexpected(*lacks);
    plot_ = std::make_unique<Plot>(machine, *plane, options.bitmap, std::move(sink));
    if (simulator_.dynamics() != nullptr) plot_->data.add_efforts(*simulator_.dynamics());
    if (const auto setup = simulator_.following_setup()) plot_->data.add_following(*setup);
    simulator_.add_output(plot_->data);
    return {};
}

void Documents::add_path(TextSink sink) {
    path_ = std::make_unique<Path>(simulator_.machine(), std::move(sink));
    simulator_.set_observer(path_->recorder);
}

void Documents::explain() {
    causes_ = std::make_unique<Causes>(simulator_.machine());
    simulator_.add_output(causes_->times);
    if (simulator_.sampled()) return;
    simulator_.add_output(causes_->bound.emplace(simulator_.machine()));
}

void Documents::complete(simulation::Report& report) const {
    if (path_ != nullptr) {
        const std::set<std::string>& notes = path_->recorder.notes();
        report.warnings.insert(report.warnings.end(), notes.begin(), notes.end());
    }
    if (causes_ == nullptr) return;
    std::optional<double> bound_s;
    if (causes_->bound) bound_s = causes_->bound->bound_s();
    report.explanation = simulation::Explanation{causes_->times.list(causes_->machine), bound_s};
}

std::vector<Failure> Documents::finish(const simulation::Report& report) {
    std::vector<Failure> faults;
    for (const auto& stream : streams_) stream->flush();
    if (auto fault = fault_of_size()) faults.push_back(*std::move(fault));
    if (plot_) write_plot(report);
    if (auto written = write_path(report.program); !written)
        faults.push_back(failure_of(text::DiagnosticKind::path, written.error()));
    return faults;
}

std::optional<Failure> Documents::fault_of_size() const {
    if (trajectory_ != nullptr && trajectory_->cut_short()) {
        return failure_of(
            text::DiagnosticKind::output,
            fmt::format("{}the trajectory would have more than {} samples; a longer --step or a "
                        "lower --max-time makes it shorter",
                        named(trajectory_name_), simulation::TrajectoryWriter::kMostSamples));
    }
    if (drawing_ != nullptr && drawing_->cut_short()) {
        return failure_of(
            text::DiagnosticKind::output,
            fmt::format("{}the drawing would have more than {} points; does an arc have too many turns?",
                        named(drawing_name_), simulation::DxfWriter::kMostPoints));
    }
    return std::nullopt;
}

tl::expected<void, std::string> Documents::write_path(const std::string& program) {
    if (path_ == nullptr) return {};
    return path_->recorder.finish(std::filesystem::path(program).stem().string())
        .map([this](const path::Program& made) {
            path::write_json(made, [this](std::string_view text) { static_cast<void>(path_->sink(text)); });
        })
        .map_error(
            [](const std::string& sentence) { return fmt::format("no path is recorded: {}", sentence); });
}

void Documents::write_plot(const simulation::Report& report) {
    if (report.cell) {
        for (const simulation::Collision& collision : report.cell->collisions)
            plot_->data.mark_collision(collision.joints);
    }
    if (report.status == simulation::RunStatus::alarm) plot_->data.mark_alarm();
    static_cast<void>(plot_->sink(plot_script(plot_->data, plot_->format, report.program)));
}

}  // namespace gsim::engine
