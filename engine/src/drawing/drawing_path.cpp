#include "engine/drawing_path.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "cam/cutting/autopath.h"
#include "cam/waterjet/job_report.h"
#include "engine/src/drawing/cutting_rules.h"
#include "engine/src/drawing/cutting_site.h"
#include "engine/src/drawing/drawing_input.h"
#include "engine/src/drawing/surface_input.h"
#include "engine/src/guarded.h"
#include "engine/src/host_names.h"
#include "engine/src/values.h"
#include "geometry/mesh/mesh.h"
#include "toolpath/json/json_writer.h"

namespace gsim::engine {

using text::DiagnosticKind;

namespace {

cutting::AutopathOptions options_of(const DrawingRequest& request) {
    cutting::AutopathOptions options;
    options.gap_mm = request.reading.gap_mm;
    options.lead_mm = request.ways.lead_mm;
    options.program.name = std::filesystem::path(request.drawing).stem().string();
    options.program.heights = {request.ways.safe_height_mm, request.ways.cut_height_mm};
    options.program.origin_mm = request.ways.origin_mm;
    options.program.bevel_deg = request.ways.bevel_deg;
    return options;
}

CuttingFigures figures_of(const cutting::CutSummary& summary) {
    return {.outlines = summary.outlines,
            .pierces = summary.pierces,
            .without_leads = summary.without_leads,
            .cut_mm = summary.cut_mm,
            .travel_mm = summary.travel_mm,
            .cut_s = summary.cut_s,
            .slower_s = summary.slower_s,
            .turning_s = summary.turning_s,
            .straightening_s = summary.straightening_s,
            .moving_pierces = summary.moving_pierces};
}

// Returns the max depth that the jet has to cut, at the deepest walls.
double greatest_depth_mm(const solid::WallContours& part) {
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
          std::string script, std::optional<CuttingSite> site)
        : request_(std::move(request)),
          file_(std::move(file)),
          materials_(std::move(materials)),
          script_(std::move(script)),
          site_(std::move(site)) {}

    const std::string& file() const { return file_; }
    const CuttingFigures& figures() const { return figures_; }
    const path::Program& program() const { return program_; }

    tl::expected<void, Failure> read();
    tl::expected<void, Failure> read_surface();
    tl::expected<void, Failure> make(const Tell& tell);
    std::optional<JobFigures> job() const;
    std::string job_report() const;

  private:
    Failure fault_of_drawing(const std::string& sentence) const {
        Failure failure = failure_of(DiagnosticKind::path, fmt::format("{}: {}", request_.drawing, sentence),
                                     request_.drawing);
        failure.in_program = true;
        return failure;
    }
    tl::expected<void, Failure> settle(double thickness_mm);
    waterjet::JobPrice price() const {
        return waterjet::price_job(*cutting_.plan, materials_->prices,
                                   {.cut_length_mm = figures_.cut_mm,
                                    .pierces = figures_.pierces,
                                    .moving_pierces = figures_.moving_pierces,
                                    .cut_time_s = figures_.cut_s});
    }

    DrawingRequest request_;
    std::string file_;
    std::optional<waterjet::Materials> materials_;  ///< None without a requested material.
    std::string script_;                            ///< Text of the one that chooses contours.
    std::optional<CuttingSite> site_;               ///< None: the surroundings are not checked.
    drawing::Drawing drawing_;
    solid::WallContours contours_;  ///< Instead of a drawing, if a surface is requested.
    SettledCutting cutting_;
    path::Program program_;
    CuttingFigures figures_;
};

/// Settles the cutting parameters for this thickness.
tl::expected<void, Failure> DrawingPath::State::settle(double thickness_mm) {
    auto settled = settle_cutting(request_.cutting, materials_, thickness_mm);
    if (!settled) return tl::unexpected(failure_of(DiagnosticKind::usage, settled.error()));
    cutting_ = *std::move(settled);
    return {};
}

tl::expected<void, Failure> DrawingPath::State::read_surface() {
    if (std::string fault = misplaced_with_contours(request_); !fault.empty())
        return tl::unexpected(failure_of(DiagnosticKind::usage, std::move(fault)));
    auto contours = read_surface_input(request_.host, file_, request_);
    if (!contours)
        return tl::unexpected(failure_of(DiagnosticKind::input_file, contours.error(), request_.drawing));
    contours_ = *std::move(contours);
    if (!request_.surface->choose.empty()) {
        auto chosen = choose_contours(script_, request_.surface->choose, contours_);
        if (!chosen) {
            Failure failure = failure_of(DiagnosticKind::path, chosen.error());
            failure.in_program = true;
            return tl::unexpected(std::move(failure));
        }
    }
    return settle(greatest_depth_mm(contours_));
}

tl::expected<void, Failure> DrawingPath::State::read() {
    if (request_.surface) return read_surface();
    auto plate = read_drawing_input(request_.host, file_, request_.reading);
    if (!plate)
        return tl::unexpected(failure_of(DiagnosticKind::input_file, plate.error(), request_.drawing));
    drawing_ = std::move(plate->drawing);
    if (auto note = other_thickness(request_.cutting, plate->thickness_mm))
        drawing_.notes.push_back(*std::move(note));
    return settle(plate->thickness_mm);
}

tl::expected<void, Failure> DrawingPath::State::make(const Tell& tell) {
    auto made = request_.surface
                    ? surface::surface_path(contours_, cutting_.rules, surface_options(request_))
                    : cutting::autopath(std::move(drawing_), cutting_.rules, options_of(request_));
    if (!made) return tl::unexpected(fault_of_drawing(made.error()));
    const auto note = [&](const std::string& sentence) {
        if (!tell) return;
        tell({.severity = Severity::note,
              .code = std::string(text::code_of(DiagnosticKind::path)),
              .file = request_.drawing,
              .text = sentence});
    };
    for (const std::string& sentence : made->notes) note(sentence);
    figures_ = figures_of(made->summary);
    if (site_) {
        for (const std::string& sentence : site_->notes()) note(sentence);
        if (auto clear = site_->clear_ways(*made, figures_); !clear)
            return tl::unexpected(fault_of_drawing(clear.error()));
    }
    program_ = std::move(made->program);
    return {};
}

std::optional<JobFigures> DrawingPath::State::job() const {
    if (!cutting_.plan) return std::nullopt;
    const waterjet::CuttingPlan& plan = *cutting_.plan;
    const waterjet::JobPrice price = this->price();
    return JobFigures{.thickness_mm = plan.thickness_mm,
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
    if (!cutting_.plan) return {};
    const waterjet::AccuracyTimes times{.slower_s = figures_.slower_s,
                                        .straightening_s = request_.cutting.straighten
                                                               ? std::optional(figures_.straightening_s)
                                                               : std::nullopt};
    return waterjet::job_report_text({*cutting_.plan, price(), times, materials_->prices.currency});
}

tl::expected<DrawingPath, Failure> DrawingPath::open(DrawingRequest request) {
    return guarded([&]() -> tl::expected<DrawingPath, Failure> {
        auto file = find_name(request.host, NameKind::sample, request.drawing);
        if (!file) return tl::unexpected(failure_of(DiagnosticKind::input_file, file.error()));
        std::optional<waterjet::Materials> materials;
        if (const CuttingChoice& cutting = request.cutting; !cutting.material.empty()) {
            auto read = read_materials_input(request.host, cutting.materials);
            if (!read) {
                return tl::unexpected(
                    failure_of(DiagnosticKind::input_file, read.error(), cutting.materials));
            }
            materials = *std::move(read);
        }
        std::string script;
        if (request.surface && !request.surface->choose.empty()) {
            const std::string& name = request.surface->choose;
            auto text = request.host.files.inner().read_text(name, os::NamedBy::command_line);
            if (!text) return tl::unexpected(failure_of(DiagnosticKind::input_file, text.error(), name));
            script = *std::move(text);
        }
        std::optional<CuttingSite> site;
        if (request.place) {
            auto read = CuttingSite::read(request.host, *request.place);
            if (!read) return tl::unexpected(read.error());
            site.emplace(*std::move(read));
        }
        return DrawingPath(std::make_unique<State>(std::move(request), *std::move(file), std::move(materials),
                                                   std::move(script), std::move(site)));
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

tl::expected<void, Failure> DrawingPath::read() {
    return guarded([this] { return state_->read(); });
}

tl::expected<void, Failure> DrawingPath::make(const Tell& tell) {
    return guarded([&] { return state_->make(tell); });
}

void DrawingPath::write(const TextSink& sink) const {
    path::write_json(state_->program(), [&sink, goes_on = true](std::string_view text) mutable {
        goes_on = goes_on && sink(text);
    });
}

const CuttingFigures& DrawingPath::figures() const {
    return state_->figures();
}

std::string DrawingPath::summary() const {
    const CuttingFigures& figures = state_->figures();
    std::string sentence =
        fmt::format("{} contours, {} pierces, {:.1f} mm cut in {:.1f} s, {:.1f} mm between the cuts",
                    figures.outlines, figures.pierces, figures.cut_mm, figures.cut_s, figures.travel_mm);
    if (figures.ways == 0) return sentence;
    return sentence + fmt::format("; nothing is touched, and {} of {} ways lead round something",
                                  figures.ways_round, figures.ways);
}

std::optional<JobFigures> DrawingPath::job() const {
    return state_->job();
}

std::string DrawingPath::job_report() const {
    return state_->job_report();
}

}  // namespace gsim::engine
