// Converts a drawing to a cutting path, and lists the available materials.

#include <array>
#include <string>
#include <utility>

#include "engine/drawing_path.h"
#include "engine/materials.h"
#include "studio/engine/answer.h"
#include "studio/engine/contour_keys.h"
#include "studio/engine/keys.h"
#include "studio/engine/message.h"

namespace gsim::studio {

using engine::DrawingRequest;
using nlohmann::json;

namespace {

constexpr double kMost = 1e6;
constexpr double kLeast = 1e-6;

void take_reading(Keys& keys, engine::DrawingChoice& reading) {
    std::optional<std::size_t> up;
    keys.number("unit_mm", kLeast, kMost, reading.unit_mm);
    keys.number("curve_tolerance_mm", 1e-5, 10, reading.curve_tolerance_mm);
    keys.number("gap_mm", 1e-6, 10, reading.gap_mm);
    keys.texts("layers", reading.layers);
    keys.word("up", kContourSides, up);
    keys.truth("flip", reading.flip);
    if (up) reading.up = kContourSides[*up];
}

void take_cutting(Keys& keys, engine::CuttingChoice& cutting) {
    keys.text("material", cutting.material);
    keys.text("materials", cutting.materials);
    keys.number("thickness_mm", 0, kMost, cutting.thickness_mm);
    keys.number("quality", 1, 5, cutting.quality);
    keys.number("speed_mm_min", 1e-3, 1e6, cutting.speed_mm_min);
    keys.number("kerf_mm", 1e-3, 100, cutting.kerf_mm);
    keys.number("pierce_s", 0, 3600, cutting.pierce_s);
    keys.truth("moving_pierce", cutting.moving_pierce);
    keys.truth("straighten", cutting.straighten);
    if (cutting.material.empty() && !(cutting.speed_mm_min && cutting.kerf_mm))
        keys.fault("a drawing needs 'material' and 'thickness_mm', or 'speed_mm_min' and 'kerf_mm'");
}

void take_ways(Keys& keys, engine::CuttingWays& ways) {
    keys.point("origin_mm", -kMost, kMost, ways.origin_mm);
    keys.number("lead_mm", 0.05, 1000, ways.lead_mm);
    keys.number("safe_height_mm", 0, 10'000, ways.safe_height_mm);
    keys.number("cut_height_mm", 0, 1000, ways.cut_height_mm);
    keys.number("bevel_deg", -60, 60, ways.bevel_deg);
}

// {"cell": "cell.toml"}
void take_place(Keys& keys, std::optional<engine::CuttingPlace>& place) {
    const json* given = keys.object("place");
    if (given == nullptr) return;
    engine::CuttingPlace& chosen = place.emplace();
    Keys own(*given, "place");
    own.text("cell", chosen.cell);
    own.text("machine", chosen.machine);
    own.text("machine_data", chosen.machine_data);
    if (auto read = own.end(); !read) keys.fault(read.error());
}

tl::expected<DrawingRequest, engine::Failure> drawing_request(const json& own) {
    DrawingRequest request;
    Keys keys(own, "a drawing");
    keys.needed_text("drawing", request.drawing);
    take_reading(keys, request.reading);
    take_ways(keys, request.ways);
    take_cutting(keys, request.cutting);
    take_contours(keys, request.surface);
    take_place(keys, request.place);
    return end_of(keys).map([&] { return std::move(request); });
}

nlohmann::ordered_json figures_json(const engine::CuttingFigures& figures) {
    return {{"outlines", figures.outlines},
            {"pierces", figures.pierces},
            {"without_leads", figures.without_leads},
            {"cut_mm", figures.cut_mm},
            {"travel_mm", figures.travel_mm},
            {"cut_s", figures.cut_s},
            {"ways", figures.ways},
            {"ways_round", figures.ways_round}};
}

nlohmann::ordered_json job_json(const std::optional<engine::JobFigures>& job) {
    if (!job) return nullptr;
    return {{"thickness_mm", job->thickness_mm}, {"quality", job->quality},
            {"speed_mm_min", job->speed_mm_min}, {"kerf_mm", job->kerf_mm},
            {"pierce_s", job->pierce_s},         {"jet_s", job->jet_s},
            {"machine_s", job->machine_s},       {"water_l", job->water_l},
            {"abrasive_kg", job->abrasive_kg},   {"price", job->price},
            {"currency", job->currency}};
}

void post_path(const engine::DrawingPath& path, const Post& post) {
    std::string text;
    path.write([&text](std::string_view part) {
        text += part;
        return true;
    });
    Message message("path");
    message.header()["summary"] = path.summary();
    message.header()["figures"] = figures_json(path.figures());
    message.header()["job"] = job_json(path.job());
    message.header()["job_text"] = path.job_report();
    message.add("text", text);
    post(message.bytes());
}

}  // namespace

Done answer_drawing(const json& own, const engine::Request& request, const Post& post) {
    auto asked = drawing_request(own);
    if (!asked) return tl::unexpected(asked.error());
    asked->host = request.host;
    auto path = engine::DrawingPath::open(*std::move(asked));
    if (!path) return tl::unexpected(path.error());
    if (auto read = path->read(); !read) return read;
    auto made = path->make([&post](const engine::Diagnostic& told) { post_told(told, post); });
    if (!made) return made;
    post_path(*path, post);
    return {};
}

Done answer_materials(const json& own, const engine::Request& request, const Post& post) {
    std::string file;
    Keys keys(own, "materials");
    keys.text("materials", file);
    if (auto read = end_of(keys); !read) return read;
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
