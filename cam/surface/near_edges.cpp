#include "cam/surface/near_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gsim::surface {

namespace {

constexpr double kKerfShare = 0.25;  // distance between positions of an edge
constexpr std::size_t kGroupPlaces = 64;

Vector place_of(const solid::WallPoint& point, WallEnd end) {
    const Vector upper = vector_of(point.position_mm);
    return end == WallEnd::upper ? upper : upper + point.depth_mm * vector_of(point.along_wall);
}

}  // namespace

void NearEdges::add_line(const Vector& from, const Vector& to, const std::string& edge,
                         std::vector<Place>& places) {
    const double step_mm = kKerfShare * jet_.kerf_mm;
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / step_mm)));
    for (int k = 0; k < steps; ++k)
        places.push_back({from + static_cast<double>(k) / steps * (to - from), &edge});
}

NearEdges::NearEdges(std::span<const solid::WallContour> contours, const JetShape& jet, WallEnd which,
                     std::span<const solid::PartEdge> others)
    : jet_(jet) {
    std::vector<Place> places;
    for (const solid::WallContour& contour : contours) {
        for (const solid::WallEdge& edge : contour.edges) {
            for (std::size_t i = 1; i < edge.points.size(); ++i)
                add_line(place_of(edge.points[i - 1], which), place_of(edge.points[i], which), edge.name,
                         places);
        }
    }
    for (const solid::PartEdge& edge : others) {
        for (std::size_t i = 1; i < edge.points_mm.size(); ++i)
            add_line(vector_of(edge.points_mm[i - 1]), vector_of(edge.points_mm[i]), edge.name, places);
    }
    for (std::size_t begin = 0; begin < places.size(); begin += kGroupPlaces) {
        const std::size_t end = std::min(places.size(), begin + kGroupPlaces);
        Group group{places[(begin + end) / 2].at,
                    0,
                    {places.begin() + static_cast<std::ptrdiff_t>(begin),
                     places.begin() + static_cast<std::ptrdiff_t>(end)}};
        for (const Place& place : group.places)
            group.radius_mm = std::max(group.radius_mm, (place.at - group.middle).norm());
        groups_.push_back(std::move(group));
    }
}

NearEdges::Nearest NearEdges::nearest(const Vector& middle, const Vector& axis, double depth_mm) const {
    Nearest found{std::numeric_limits<double>::infinity()};
    const double up_mm = jet_.height_mm + jet_.kerf_mm;
    const auto distance = [&](const Vector& place) {
        const double along = std::clamp((place - middle).dot(axis), -depth_mm, up_mm);
        return (place - middle - along * axis).norm();
    };
    for (const Group& group : groups_) {
        if (distance(group.middle) - group.radius_mm >= found.distance_mm) continue;
        for (const Place& place : group.places) {
            const double each = distance(place.at);
            if (each < found.distance_mm) found = {each, place.at, *place.edge};
        }
    }
    return found;
}

}  // namespace gsim::surface
