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

solid::WallEdge to_wall_edge(Contours::Edge given) {
    solid::WallEdge edge{std::move(given.name), {}, given.next_surface_mm, std::move(given.label)};
    edge.points.reserve(given.points.size());
    for (const Contours::Point& point : given.points)
        edge.points.push_back({point.position_mm, point.normal, point.tangent, point.wall_normal,
                               point.along_wall, point.depth_mm, point.exit_normal});
    return edge;
}

solid::WallContours to_wall_contours(Contours given) {
    solid::WallContours contours;
    contours.low_mm = given.low_mm;
    contours.high_mm = given.high_mm;
    contours.notes = std::move(given.notes);
    for (Contours::Contour& each : given.contours) {
        solid::WallContour contour{std::move(each.face), each.is_hole, {}, each.is_open};
        for (Contours::Edge& edge : each.edges) contour.edges.push_back(to_wall_edge(std::move(edge)));
        contours.contours.push_back(std::move(contour));
    }
    for (Contours::PartEdge& edge : given.other_edges)
        contours.other_edges.push_back({std::move(edge.name), std::move(edge.points_mm)});
    return contours;
}

double angle_deg(const surface::Vector& a, const surface::Vector& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * kDegPerRad;
}

std::array<double, 3> to_vec3(const surface::Vector& v) {
    return {v.x(), v.y(), v.z()};
}

}  // namespace

script::ContourDescription describe_contour(const solid::WallContour& contour) {
    script::ContourDescription facts{
        .face = contour.face, .is_hole = contour.is_hole, .is_open = contour.is_open};
    surface::Vector low = surface::Vector::Constant(std::numeric_limits<double>::infinity());
    surface::Vector high = -low;
    surface::Vector normal = surface::Vector::Zero();
    for (const solid::WallEdge& edge : contour.edges) {
        script::ContourDescription::Edge edge_description{edge.name, 0};
        for (std::size_t i = 0; i < edge.points.size(); ++i) {
            const solid::WallPoint& point = edge.points[i];
            const surface::Vector at = surface::to_vector(point.position_mm);
            low = low.cwiseMin(at);
            high = high.cwiseMax(at);
            facts.depth_mm = std::max(facts.depth_mm, point.depth_mm);
            const surface::Vector up = surface::to_vector(point.normal);
            const surface::Vector wall = -surface::to_vector(point.along_wall);
            if (wall.norm() > 0) facts.tilt_deg = std::max(facts.tilt_deg, angle_deg(wall, up));
            if (i == 0) continue;
            const double step_mm = (at - surface::to_vector(edge.points[i - 1].position_mm)).norm();
            edge_description.length_mm += step_mm;
            normal += step_mm * up;
        }
        facts.length_mm += edge_description.length_mm;
        facts.edges.push_back(std::move(edge_description));
    }
    facts.low_mm = to_vec3(low);
    facts.high_mm = to_vec3(high);
    if (normal.norm() > 0) facts.normal = to_vec3(normal.normalized());
    return facts;
}

std::optional<gsim::Error> find_contour_option_error(const DrawingRequest& request) {
    const DrawingOptions& reading = request.reading;
    if (request.cutting.taper_compensation || request.cutting.dynamic_pierce) {
        return fmt::format("{} applies to drawings and flat parts: it cannot be combined with --contours",
                           request.cutting.taper_compensation ? "--taper-compensation" : "--dynamic-pierce");
    }
    if (reading.flip || !reading.up.empty()) return "--up and --flip apply to flat parts, without --contours";
    if (reading.unit_mm != 0 || !reading.layers.empty())
        return "--unit and --layer apply to drawings; a STEP or IGES file defines its unit";
    if (std::abs(request.cutting_path.bevel_deg) > 0)
        return "--bevel applies to flat parts; with --contours the jet follows the walls, or is tilted by "
               "--tilt-angle";
    const SurfaceCuttingOptions& surface = *request.surface;
    if (surface.contours.kind == "edges" && surface.contours.edges.empty())
        return "--contours edges requires the numbers of edges (--edge)";
    if (surface.contours.along_walls && std::abs(surface.tilt_deg) > 0)
        return "--tilt-angle is relative to the face normal (--axis normal); along walls, the walls define "
               "the tilt angle";
    return {};
}

Result<solid::WallContours> read_part_contours(const Host& host, const std::string& file,
                                               const ContourSelection& selection) {
    if (!solid::is_solid_file(file)) return Unexpected("--contours applies to STEP and IGES files");
    if (!host.read_contours) {
        return Unexpected(
            fmt::format("{}: STEP and IGES files are not supported here, only DXF and SVG files", file));
    }
    return host.read_contours(file, selection).map(to_wall_contours);
}

Result<solid::WallContours> read_surface_input(const Host& host, const std::string& file,
                                               const DrawingRequest& request) {
    ContourSelection selection = request.surface->contours;
    selection.tolerance_mm = request.reading.curve_tolerance_mm;
    return read_part_contours(host, file, selection);
}

Result<void> choose_contours(std::string_view script, const std::string& file_name,
                             solid::WallContours& part) {
    std::vector<script::ContourDescription> facts;
    facts.reserve(part.contours.size());
    for (const solid::WallContour& contour : part.contours) facts.push_back(describe_contour(contour));
    const auto selected = script::choose_contours(script, file_name, facts);
    if (!selected) return tl::unexpected(selected.error());
    std::vector<solid::WallContour> kept;
    for (std::size_t i = 0; i < selected->size(); ++i) {
        if ((*selected)[i]) kept.push_back(std::move(part.contours[i]));
    }
    if (kept.empty()) {
        return Unexpected(
            fmt::format("{}:1: the script selects 0 of the {} contours", file_name, part.contours.size()));
    }
    part.contours = std::move(kept);
    return {};
}

surface::SurfaceOptions surface_options(const DrawingRequest& request) {
    const SurfaceCuttingOptions& selection = *request.surface;
    surface::SurfaceOptions options;
    options.name = std::filesystem::path(request.drawing).stem().string();
    options.jet = {selection.contours.along_walls, selection.tilt_deg, selection.lead_angle_deg,
                   selection.max_tilt_deg};
    options.tolerance_mm = request.reading.curve_tolerance_mm;
    options.lead_mm = request.cutting_path.lead_mm;
    options.safe_height_mm = request.cutting_path.safe_height_mm;
    options.cut_height_mm = request.cutting_path.cut_height_mm;
    options.origin_mm = surface::to_vector(request.cutting_path.origin_mm);
    options.bridges = {selection.bridges, selection.bridge_mm};
    if (selection.start_mm) options.start_mm = surface::to_vector(*selection.start_mm);
    return options;
}

}  // namespace gsim::engine
