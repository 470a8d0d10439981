#include "cam/surface/edge_proximity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gsim::surface {

namespace {

constexpr double kSampleSpacingKerfs = 0.25;  // distance between positions of an edge
constexpr std::size_t kPointsPerGroup = 64;

Vector wall_end_position(const solid::WallPoint& point, WallEnd end) {
    const Vector upper = to_vector(point.position_mm);
    return end == WallEnd::upper ? upper : upper + point.depth_mm * to_vector(point.along_wall);
}

}  // namespace

void EdgeProximity::add_line(const Vector& from, const Vector& to, const std::string& edge,
                             std::vector<EdgePoint>& samples) {
    const double step_mm = kSampleSpacingKerfs * jet_.kerf_mm;
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / step_mm)));
    for (int k = 0; k < steps; ++k)
        samples.push_back({from + static_cast<double>(k) / steps * (to - from), &edge});
}

EdgeProximity::EdgeProximity(std::span<const solid::WallContour> contours, const JetShape& jet,
                             WallEnd wall_end, std::span<const solid::PartEdge> others)
    : jet_(jet) {
    std::vector<EdgePoint> samples;
    for (const solid::WallContour& contour : contours) {
        for (const solid::WallEdge& edge : contour.edges) {
            for (std::size_t i = 1; i < edge.points.size(); ++i)
                add_line(wall_end_position(edge.points[i - 1], wall_end),
                         wall_end_position(edge.points[i], wall_end), edge.name, samples);
        }
    }
    for (const solid::PartEdge& edge : others) {
        for (std::size_t i = 1; i < edge.points_mm.size(); ++i)
            add_line(to_vector(edge.points_mm[i - 1]), to_vector(edge.points_mm[i]), edge.name, samples);
    }
    for (std::size_t begin = 0; begin < samples.size(); begin += kPointsPerGroup) {
        const std::size_t end = std::min(samples.size(), begin + kPointsPerGroup);
        Group group{samples[(begin + end) / 2].at,
                    0,
                    {samples.begin() + static_cast<std::ptrdiff_t>(begin),
                     samples.begin() + static_cast<std::ptrdiff_t>(end)}};
        for (const EdgePoint& position : group.samples)
            group.radius_mm = std::max(group.radius_mm, (position.at - group.middle).norm());
        groups_.push_back(std::move(group));
    }
}

EdgeProximity::NearestSample EdgeProximity::nearest(const Vector& middle, const Vector& axis,
                                                    double depth_mm) const {
    NearestSample found{std::numeric_limits<double>::infinity()};
    const double reach_mm = jet_.height_mm + jet_.kerf_mm;
    const auto distance = [&](const Vector& position) {
        const double axial_position = std::clamp((position - middle).dot(axis), -depth_mm, reach_mm);
        return (position - middle - axial_position * axis).norm();
    };
    for (const Group& group : groups_) {
        if (distance(group.middle) - group.radius_mm >= found.distance_mm) continue;
        for (const EdgePoint& position : group.samples) {
            const double each = distance(position.at);
            if (each < found.distance_mm) found = {each, position.at, *position.edge};
        }
    }
    return found;
}

}  // namespace gsim::surface
