// Converts a drawing to a cutting path, and lists the available materials.

#include <array>
#include <string>
#include <utility>

#include "engine/drawing_path.h"
#include "engine/materials.h"
#include "studio/engine/contour_keys.h"
#include "studio/engine/key_reader.h"
#include "studio/engine/message.h"
#include "studio/engine/request_handlers.h"

namespace gsim::studio {

using engine::DrawingRequest;
using nlohmann::json;

namespace {

constexpr double kMax = 1e6;
constexpr double kMinPositive = 1e-6;

void read_drawing_options(KeyReader& keys, engine::DrawingOptions& reading) {
    std::optional<std::size_t> up;
    keys.number("unit_mm", kMinPositive, kMax, reading.unit_mm);
    keys.number("curve_tolerance_mm", 1e-5, 10, reading.curve_tolerance_mm);
    keys.number("gap_mm", 1e-6, 10, reading.gap_mm);
    keys.texts("layers", reading.layers);
    keys.word("up", kViewDirections, up);
    keys.boolean("flip", reading.flip);
    if (up) reading.up = kViewDirections[*up];
}

void read_cutting_options(KeyReader& keys, engine::CuttingOptions& cutting) {
    keys.text("material", cutting.material);
    keys.text("materials", cutting.materials);
    keys.number("thickness_mm", 0, kMax, cutting.thickness_mm);
    keys.number("quality", 1, 5, cutting.quality);
    keys.number("speed_mm_min", 1e-3, 1e6, cutting.speed_mm_min);
    keys.number("kerf_mm", 1e-3, 100, cutting.kerf_mm);
    keys.number("pierce_s", 0, 3600, cutting.pierce_s);
    keys.boolean("dynamic_pierce", cutting.dynamic_pierce);
    keys.boolean("taper_compensation", cutting.taper_compensation);
    if (cutting.material.empty() && !(cutting.speed_mm_min && cutting.kerf_mm))
        keys.add_error("a drawing needs 'material' and 'thickness_mm', or 'speed_mm_min' and 'kerf_mm'");
}

void read_cutting_paths(KeyReader& keys, engine::CuttingPathOptions& path) {
    keys.point("origin_mm", -kMax, kMax, path.origin_mm);
    keys.number("lead_mm", 0.05, 1000, path.lead_mm);
    keys.number("safe_height_mm", 0, 10'000, path.safe_height_mm);
    keys.number("cut_height_mm", 0, 1000, path.cut_height_mm);
    keys.number("bevel_deg", -60, 60, path.bevel_deg);
}

// {"cell": "cell.toml"}
void read_placement(KeyReader& keys, std::optional<engine::CuttingCellOptions>& work_cell) {
    const json* object_json = keys.object("place");
    if (object_json == nullptr) return;
    engine::CuttingCellOptions& placement_options = work_cell.emplace();
    KeyReader parameters(*object_json, "place");
    parameters.text("cell", placement_options.cell);
    parameters.text("machine", placement_options.machine);
    parameters.text("machine_data", placement_options.machine_data);
    if (auto read = parameters.end(); !read) keys.add_error(read.error().message);
}

tl::expected<DrawingRequest, engine::Error> drawing_request(const json& parameters) {
    DrawingRequest request;
    KeyReader keys(parameters, "a drawing");
    keys.required_text("drawing", request.drawing);
    read_drawing_options(keys, request.reading);
    read_cutting_paths(keys, request.cutting_path);
    read_cutting_options(keys, request.cutting);
    unpack_contours(keys, request.surface);
    read_placement(keys, request.work_cell);
    return finish_keys(keys).map([&] { return std::move(request); });
}

nlohmann::ordered_json cutting_metrics_json(const engine::CuttingMetrics& metrics) {
    return {{"outlines", metrics.outlines},           {"pierces", metrics.pierces},
            {"without_leads", metrics.without_leads}, {"cut_mm", metrics.cut_mm},
            {"travel_mm", metrics.travel_mm},         {"cut_s", metrics.cut_s},
            {"linking_paths", metrics.linking_paths}, {"rerouted_moves", metrics.rerouted_moves}};
}

nlohmann::ordered_json job_json(const std::optional<engine::JobMetrics>& job) {
    if (!job) return nullptr;
    return {{"thickness_mm", job->thickness_mm}, {"quality", job->quality},
            {"speed_mm_min", job->speed_mm_min}, {"kerf_mm", job->kerf_mm},
            {"pierce_s", job->pierce_s},         {"jet_s", job->jet_s},
            {"machine_s", job->machine_s},       {"water_l", job->water_l},
            {"abrasive_kg", job->abrasive_kg},   {"price", job->price},
            {"currency", job->currency}};
}

void send_path(const engine::DrawingPath& path, const Post& post) {
    std::string text;
    path.write([&text](std::string_view part) {
        text += part;
        return true;
    });
    Message message("path");
    message.header()["summary"] = path.summary();
    message.header()["figures"] = cutting_metrics_json(path.metrics());
    message.header()["job"] = job_json(path.job());
    message.header()["job_text"] = path.job_report();
    message.add("text", text);
    post(message.bytes());
}

}  // namespace

VoidResult handle_drawing(const json& parameters, const engine::Request& request, const Post& post) {
    auto parsed_request = drawing_request(parameters);
    if (!parsed_request) return tl::unexpected(parsed_request.error());
    parsed_request->host = request.host;
    auto path = engine::DrawingPath::open(*std::move(parsed_request));
    if (!path) return tl::unexpected(path.error());
    if (auto read = path->read(); !read) return read;
    auto result =
        path->make([&post](const engine::Diagnostic& reported) { send_diagnostic(reported, post); });
    if (!result) return result;
    send_path(*path, post);
    return {};
}

VoidResult handle_materials(const json& parameters, const engine::Request& request, const Post& post) {
    std::string file;
    KeyReader keys(parameters, "materials");
    keys.text("materials", file);
    if (auto read = finish_keys(keys); !read) return read;
    const auto materials = engine::cutting_materials(request.host, file);
    if (!materials) return tl::unexpected(materials.error());
    Message message("materials");
    auto& list = message.header()["materials"] = nlohmann::ordered_json::array();
    for (const engine::CuttingMaterial& material : *materials) {
        nlohmann::ordered_json known{{"name", material.name}, {"machinability", material.machinability}};
        if (!material.like.empty()) known["like"] = material.like;
        if (material.measured) known["measured"] = true;
        if (!material.source.empty()) known["source"] = material.source;
        list.push_back(std::move(known));
    }
    post(message.bytes());
    return {};
}

}  // namespace gsim::studio
