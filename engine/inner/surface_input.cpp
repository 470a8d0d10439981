#include "engine/inner/surface_input.h"

#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "cam/solid/mesh.h"

namespace gsim::engine {

namespace {

solid::WallEdge inner_edge(Contours::Edge given) {
    solid::WallEdge edge{std::move(given.name), {}, given.behind_mm};
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
        solid::WallContour contour{std::move(each.face), each.is_hole, {}};
        for (Contours::Edge& edge : each.edges) contour.edges.push_back(inner_edge(std::move(edge)));
        contours.contours.push_back(std::move(contour));
    }
    return contours;
}

// What is for flat parts and drawings alone.
std::string misplaced(const DrawingRequest& request) {
    const DrawingChoice& reading = request.reading;
    if (reading.flip || !reading.up.empty()) return "--up and --flip are for flat parts, without --contours";
    if (reading.unit_mm != 0 || !reading.layers.empty())
        return "--unit and --layer are for drawings; a STEP or IGES file says its unit";
    if (std::abs(request.ways.bevel_deg) > 0)
        return "--bevel is for flat parts; with --contours the jet goes along the walls, or leans by --lean";
    const SurfaceChoice& surface = *request.surface;
    if (surface.contours.along_walls && std::abs(surface.lean_deg) > 0)
        return "--lean is from the face's normal (--axis normal); along walls they say how the jet leans";
    return {};
}

}  // namespace

tl::expected<solid::WallContours, std::string> read_surface_input(const Host& host, const std::string& file,
                                                                  const DrawingRequest& request) {
    if (!solid::is_solid_file(file))
        return tl::unexpected(std::string("--contours is for STEP and IGES files"));
    if (auto fault = misplaced(request); !fault.empty()) return tl::unexpected(std::move(fault));
    if (!host.read_contours) {
        return tl::unexpected(
            fmt::format("{}: STEP and IGES files are not read here; DXF and SVG files are", file));
    }
    ContourChoice choice = request.surface->contours;
    choice.tolerance_mm = request.reading.curve_tolerance_mm;
    return host.read_contours(file, choice).map(inner_contours);
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
