#include "engine/drawing_path.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "base/os/files.h"
#include "cam/cutting/autopath.h"
#include "cam/waterjet/job_report.h"
#include "engine/src/conversions.h"
#include "engine/src/drawing/cutting_cell.h"
#include "engine/src/drawing/cutting_rules.h"
#include "engine/src/drawing/drawing_input.h"
#include "engine/src/drawing/surface_input.h"
#include "engine/src/guard_exceptions.h"
#include "engine/src/host_names.h"
#include "geometry/mesh/mesh.h"
#include "toolpath/json/json_writer.h"

namespace gsim::engine {

using text::DiagnosticKind;

namespace {

cutting::AutopathOptions make_options(const DrawingRequest& request) {
    cutting::AutopathOptions options;
    options.gap_mm = request.reading.gap_mm;
    options.lead_mm = request.cutting_path.lead_mm;
    options.program.name = std::filesystem::path(request.drawing).stem().string();
    options.program.heights = {request.cutting_path.safe_height_mm, request.cutting_path.cut_height_mm};
    options.program.origin_mm = request.cutting_path.origin_mm;
    options.program.bevel_deg = request.cutting_path.bevel_deg;
    return options;
}

CuttingMetrics to_metrics(const cutting::CutSummary& summary) {
    return {.outlines = summary.outlines,
            .pierces = summary.pierces,
            .without_leads = summary.without_leads,
            .cut_mm = summary.cut_mm,
            .travel_mm = summary.travel_mm,
            .cut_s = summary.cut_s,
            .slowdown_s = summary.slowdown_s,
            .reorientation_s = summary.reorientation_s,
            .taper_compensation_s = summary.taper_compensation_s,
            .dynamic_pierces = summary.dynamic_pierces};
}

// Returns the max depth that the jet has to cut, at the deepest walls.
double max_depth_mm(const solid::WallContours& part) {
    double depth_mm = 0;
    for (const solid::WallContour& contour : part.contours) {
        for (const solid::WallEdge& edge : contour.edges) {
            for (const solid::WallPoint& point : edge.points) depth_mm = std::max(depth_mm, point.depth_mm);
        }
    }
    return depth_mm;
}

}  // namespace

class DrawingPath::State {
  public:
    State(DrawingRequest request, std::string file, std::optional<waterjet::Materials> materials,
          std::string script, std::optional<CuttingCell> cutting_cell)
        : request_(std::move(request)),
          file_(std::move(file)),
          materials_(std::move(materials)),
          script_(std::move(script)),
          cutting_cell_(std::move(cutting_cell)) {}

    const std::string& file() const { return file_; }
    const CuttingMetrics& metrics() const { return metrics_; }
    const path::Program& program() const { return program_; }

    tl::expected<void, Error> read();
    tl::expected<void, Error> read_surface();
    tl::expected<void, Error> make(const DiagnosticHandler& on_diagnostic);
    std::optional<JobMetrics> job() const;
    std::string job_report() const;

  private:
    Error drawing_error(const std::string& message) const {
        Error error = make_error(DiagnosticKind::path, fmt::format("{}: {}", request_.drawing, message),
                                 request_.drawing);
        error.in_program = true;
        return error;
    }
    tl::expected<void, Error> resolve_cutting(double thickness_mm);
    waterjet::JobPrice price() const {
        return waterjet::price_job(*resolved_cutting_.plan, materials_->prices,
                                   {.cut_length_mm = metrics_.cut_mm,
                                    .pierces = metrics_.pierces,
                                    .dynamic_pierces = metrics_.dynamic_pierces,
                                    .cut_time_s = metrics_.cut_s});
    }

    DrawingRequest request_;
    std::string file_;
    std::optional<waterjet::Materials> materials_;  ///< None without a requested material.
    std::string script_;                            ///< Text of the one that chooses contours.
    std::optional<CuttingCell> cutting_cell_;       ///< None: the surroundings are not checked.
    drawing::Drawing drawing_;
    solid::WallContours contours_;  ///< Instead of a drawing, if a surface is requested.
    ResolvedCutting resolved_cutting_;
    path::Program program_;
    CuttingMetrics metrics_;
};

/// Settles the cutting parameters for this thickness.
tl::expected<void, Error> DrawingPath::State::resolve_cutting(double thickness_mm) {
    auto resolved = resolve_cutting_options(request_.cutting, materials_, thickness_mm);
    if (!resolved) return tl::unexpected(make_error(DiagnosticKind::usage, resolved.error()));
    resolved_cutting_ = *std::move(resolved);
    return {};
}

tl::expected<void, Error> DrawingPath::State::read_surface() {
    if (auto error = find_contour_option_error(request_))
        return tl::unexpected(make_error(DiagnosticKind::usage, *std::move(error)));
    auto contours = read_surface_input(request_.host, file_, request_);
    if (!contours)
        return tl::unexpected(make_error(DiagnosticKind::input_file, contours.error(), request_.drawing));
    contours_ = *std::move(contours);
    if (!request_.surface->choose.empty()) {
        auto selected = choose_contours(script_, request_.surface->choose, contours_);
        if (!selected) {
            Error error = make_error(DiagnosticKind::path, selected.error());
            error.in_program = true;
            return tl::unexpected(std::move(error));
        }
    }
    return resolve_cutting(max_depth_mm(contours_));
}

tl::expected<void, Error> DrawingPath::State::read() {
    if (request_.surface) return read_surface();
    auto plate = read_drawing_input(request_.host, file_, request_.reading);
    if (!plate)
        return tl::unexpected(make_error(DiagnosticKind::input_file, plate.error(), request_.drawing));
    drawing_ = std::move(plate->drawing);
    if (auto note = thickness_mismatch(request_.cutting, plate->thickness_mm))
        drawing_.notes.push_back(*std::move(note));
    return resolve_cutting(plate->thickness_mm);
}

tl::expected<void, Error> DrawingPath::State::make(const DiagnosticHandler& on_diagnostic) {
    auto result =
        request_.surface
            ? surface::surface_path(contours_, resolved_cutting_.rules, surface_options(request_))
            : cutting::autopath(std::move(drawing_), resolved_cutting_.rules, make_options(request_));
    if (!result) return tl::unexpected(drawing_error(result.error().message));
    const auto note = [&](const std::string& message) {
        if (!on_diagnostic) return;
        on_diagnostic({.severity = Severity::note,
                       .code = std::string(text::diagnostic_code(DiagnosticKind::path)),
                       .file = request_.drawing,
                       .text = message});
    };
    for (const std::string& message : result->notes) note(message);
    metrics_ = to_metrics(result->summary);
    if (cutting_cell_) {
        for (const std::string& message : cutting_cell_->notes()) note(message);
        if (auto clear = cutting_cell_->avoid_collisions(*result, metrics_); !clear)
            return tl::unexpected(drawing_error(clear.error().message));
    }
    program_ = std::move(result->program);
    return {};
}

std::optional<JobMetrics> DrawingPath::State::job() const {
    if (!resolved_cutting_.plan) return std::nullopt;
    const waterjet::CuttingPlan& plan = *resolved_cutting_.plan;
    const waterjet::JobPrice price = this->price();
    return JobMetrics{.thickness_mm = plan.thickness_mm,
                      .quality = plan.quality,
                      .speed_mm_min = plan.cutting_speed_mm_min,
                      .kerf_mm = plan.kerf_mm,
                      .pierce_s = plan.pierce_s,
                      .jet_s = price.jet_time_s,
                      .machine_s = price.machine_time_s,
                      .water_l = price.water_l,
                      .abrasive_kg = price.abrasive_kg,
                      .price = price.total,
                      .currency = materials_->prices.currency};
}

std::string DrawingPath::State::job_report() const {
    if (!resolved_cutting_.plan) return {};
    const waterjet::AccuracyTimes times{
        .slowdown_s = metrics_.slowdown_s,
        .taper_compensation_s = request_.cutting.taper_compensation
                                    ? std::optional(metrics_.taper_compensation_s)
                                    : std::nullopt};
    return waterjet::job_report_text({*resolved_cutting_.plan, price(), times, materials_->prices.currency});
}

tl::expected<DrawingPath, Error> DrawingPath::open(DrawingRequest request) {
    return guard_exceptions([&]() -> tl::expected<DrawingPath, Error> {
        auto file = resolve_name(request.host, NameKind::sample, request.drawing);
        if (!file) return tl::unexpected(make_error(DiagnosticKind::input_file, file.error()));
        std::optional<waterjet::Materials> materials;
        if (const CuttingOptions& cutting = request.cutting; !cutting.material.empty()) {
            auto read = read_materials_input(request.host, cutting.materials);
            if (!read) {
                return tl::unexpected(
                    make_error(DiagnosticKind::input_file, read.error(), cutting.materials));
            }
            materials = *std::move(read);
        }
        std::string script;
        if (request.surface && !request.surface->choose.empty()) {
            const std::string& name = request.surface->choose;
            auto text = request.host.files.impl().read_text(name, os::NameSource::command_line);
            if (!text) return tl::unexpected(make_error(DiagnosticKind::input_file, text.error(), name));
            script = *std::move(text);
        }
        std::optional<CuttingCell> cutting_cell;
        if (request.work_cell) {
            auto read = CuttingCell::read(request.host, *request.work_cell);
            if (!read) return tl::unexpected(read.error());
            cutting_cell.emplace(*std::move(read));
        }
        return DrawingPath(std::make_unique<State>(std::move(request), *std::move(file), std::move(materials),
                                                   std::move(script), std::move(cutting_cell)));
    });
}

DrawingPath::DrawingPath(std::unique_ptr<State> state) : state_(std::move(state)) {}
DrawingPath::DrawingPath(DrawingPath&&) noexcept = default;
DrawingPath& DrawingPath::operator=(DrawingPath&&) noexcept = default;
DrawingPath::~DrawingPath() = default;

const std::string& DrawingPath::drawing_file() const {
    return state_->file();
}

bool DrawingPath::is_solid() const {
    return solid::is_solid_file(state_->file());
}

tl::expected<void, Error> DrawingPath::read() {
    return guard_exceptions([this] { return state_->read(); });
}

tl::expected<void, Error> DrawingPath::make(const DiagnosticHandler& on_diagnostic) {
    return guard_exceptions([&] { return state_->make(on_diagnostic); });
}

void DrawingPath::write(const TextSink& sink) const {
    path::write_json(state_->program(), [&sink, continues = true](std::string_view text) mutable {
        continues = continues && sink(text);
    });
}

const CuttingMetrics& DrawingPath::metrics() const {
    return state_->metrics();
}

std::string DrawingPath::summary() const {
    const CuttingMetrics& metrics = state_->metrics();
    std::string message =
        fmt::format("{} contours, {} pierces, {:.1f} mm cut in {:.1f} s, {:.1f} mm between the cuts",
                    metrics.outlines, metrics.pierces, metrics.cut_mm, metrics.cut_s, metrics.travel_mm);
    if (metrics.linking_paths == 0) return message;
    return message + fmt::format("; there are no collisions, and {} of {} linking moves were rerouted",
                                 metrics.rerouted_moves, metrics.linking_paths);
}

std::optional<JobMetrics> DrawingPath::job() const {
    return state_->job();
}

std::string DrawingPath::job_report() const {
    return state_->job_report();
}

}  // namespace gsim::engine
