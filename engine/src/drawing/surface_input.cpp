#include "engine/src/drawing/surface_input.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/units.h"
#include "geometry/mesh/mesh.h"

namespace gsim::engine {

namespace {

solid::WallEdge inner_edge(Contours::Edge given) {
    solid::WallEdge edge{std::move(given.name), {}, given.behind_mm, std::move(given.label)};
    edge.points.reserve(given.points.size());
    for (const Contours::Point& point : given.points)
        edge.points.push_back({point.position_mm, point.normal, point.tangent, point.wall_normal,
                               point.along_wall, point.depth_mm, point.far_normal});
    return edge;
}

solid::WallContours inner_contours(Contours given) {
    solid::WallContours contours;
    contours.low_mm = given.low_mm;
    contours.high_mm = given.high_mm;
    contours.notes = std::move(given.notes);
    for (Contours::Contour& each : given.contours) {
        solid::WallContour contour{std::move(each.face), each.is_hole, {}, each.is_open};
        for (Contours::Edge& edge : each.edges) contour.edges.push_back(inner_edge(std::move(edge)));
        contours.contours.push_back(std::move(contour));
    }
    for (Contours::PartEdge& edge : given.other_edges)
        contours.other_edges.push_back({std::move(edge.name), std::move(edge.points_mm)});
    return contours;
}

double angle_deg(const surface::Vector& a, const surface::Vector& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * kDegPerRad;
}

std::array<double, 3> triple_of(const surface::Vector& v) {
    return {v.x(), v.y(), v.z()};
}

}  // namespace

script::ContourFacts facts_of(const solid::WallContour& contour) {
    script::ContourFacts facts{.face = contour.face, .is_hole = contour.is_hole, .is_open = contour.is_open};
    surface::Vector low = surface::Vector::Constant(std::numeric_limits<double>::infinity());
    surface::Vector high = -low;
    surface::Vector normal = surface::Vector::Zero();
    for (const solid::WallEdge& edge : contour.edges) {
        script::ContourFacts::Edge of_edge{edge.name, 0};
        for (std::size_t i = 0; i < edge.points.size(); ++i) {
            const solid::WallPoint& point = edge.points[i];
            const surface::Vector at = surface::vector_of(point.position_mm);
            low = low.cwiseMin(at);
            high = high.cwiseMax(at);
            facts.depth_mm = std::max(facts.depth_mm, point.depth_mm);
            const surface::Vector up = surface::vector_of(point.normal);
            const surface::Vector wall = -surface::vector_of(point.along_wall);
            if (wall.norm() > 0) facts.lean_deg = std::max(facts.lean_deg, angle_deg(wall, up));
            if (i == 0) continue;
            const double step_mm = (at - surface::vector_of(edge.points[i - 1].position_mm)).norm();
            of_edge.length_mm += step_mm;
            normal += step_mm * up;
        }
        facts.length_mm += of_edge.length_mm;
        facts.edges.push_back(std::move(of_edge));
    }
    facts.low_mm = triple_of(low);
    facts.high_mm = triple_of(high);
    if (normal.norm() > 0) facts.normal = triple_of(normal.normalized());
    return facts;
}

std::string misplaced_with_contours(const DrawingRequest& request) {
    const DrawingChoice& reading = request.reading;
    if (request.cutting.straighten || request.cutting.moving_pierce) {
        return fmt::format("{} is for drawings and flat parts: it does not go with --contours",
                           request.cutting.straighten ? "--straighten" : "--moving-pierce");
    }
    if (reading.flip || !reading.up.empty()) return "--up and --flip are for flat parts, without --contours";
    if (reading.unit_mm != 0 || !reading.layers.empty())
        return "--unit and --layer are for drawings; a STEP or IGES file says its unit";
    if (std::abs(request.ways.bevel_deg) > 0)
        return "--bevel is for flat parts; with --contours the jet goes along the walls, or leans by --lean";
    const SurfaceChoice& surface = *request.surface;
    if (surface.contours.kind == "edges" && surface.contours.edges.empty())
        return "--contours edges needs the numbers of edges (--edge)";
    if (surface.contours.along_walls && std::abs(surface.lean_deg) > 0)
        return "--lean is from the face's normal (--axis normal); along walls they say how the jet leans";
    return {};
}

tl::expected<solid::WallContours, std::string> read_part_contours(const Host& host, const std::string& file,
                                                                  const ContourChoice& choice) {
    if (!solid::is_solid_file(file))
        return tl::unexpected(std::string("--contours is for STEP and IGES files"));
    if (!host.read_contours) {
        return tl::unexpected(
            fmt::format("{}: STEP and IGES files are not read here; DXF and SVG files are", file));
    }
    return host.read_contours(file, choice).map(inner_contours);
}

tl::expected<solid::WallContours, std::string> read_surface_input(const Host& host, const std::string& file,
                                                                  const DrawingRequest& request) {
    ContourChoice choice = request.surface->contours;
    choice.tolerance_mm = request.reading.curve_tolerance_mm;
    return read_part_contours(host, file, choice);
}

tl::expected<void, std::string> choose_contours(std::string_view script, const std::string& file_name,
                                                solid::WallContours& part) {
    std::vector<script::ContourFacts> facts;
    facts.reserve(part.contours.size());
    for (const solid::WallContour& contour : part.contours) facts.push_back(facts_of(contour));
    const auto chosen = script::choose_contours(script, file_name, facts);
    if (!chosen) return tl::unexpected(chosen.error());
    std::vector<solid::WallContour> kept;
    for (std::size_t i = 0; i < chosen->size(); ++i) {
        if ((*chosen)[i]) kept.push_back(std::move(part.contours[i]));
    }
    if (kept.empty()) {
        return tl::unexpected(
            fmt::format("{}:1: the script chooses none of the {} contours", file_name, part.contours.size()));
    }
    part.contours = std::move(kept);
    return {};
}

surface::SurfaceOptions surface_options(const DrawingRequest& request) {
    const SurfaceChoice& choice = *request.surface;
    surface::SurfaceOptions options;
    options.name = std::filesystem::path(request.drawing).stem().string();
    options.jet = {choice.contours.along_walls, choice.lean_deg, choice.tilt_deg, choice.max_lean_deg};
    options.tolerance_mm = request.reading.curve_tolerance_mm;
    options.lead_mm = request.ways.lead_mm;
    options.safe_height_mm = request.ways.safe_height_mm;
    options.cut_height_mm = request.ways.cut_height_mm;
    options.origin_mm = surface::vector_of(request.ways.origin_mm);
    options.bridges = {choice.bridges, choice.bridge_mm};
    if (choice.start_mm) options.start_mm = surface::vector_of(*choice.start_mm);
    return options;
}

}  // namespace gsim::engine
