#include "cam/surface/surface_lead.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace gsim::surface {

namespace {

constexpr double kLeastRadius_mm = 0.05;
constexpr double kTouch_mm = 0.02;  // of which points of edges between those that are known may be nearer
constexpr int kProbes = 9;
constexpr double kProbesOfKerf = 4;  // of a straight lead
constexpr int kMostStarts = 24;

// Returns a point of a quarter circle that ends on the path: the offset after `turn` of its sweep, back
// against the path.
Vector off_way(const JetPoint& at, double radius_mm, double turn, double sense) {
    const Vector waste = at.tangent.cross(at.normal).normalized();
    return radius_mm * ((1 - std::cos(turn)) * waste + sense * std::sin(turn) * at.tangent);
}

bool is_clear(const JetPoint& at, const JetShape& jet, const NearEdges& edges, double radius_mm,
              double sense) {
    for (int i = 1; i <= kProbes; ++i) {
        const double turn = std::numbers::pi / 2 * i / kProbes;
        const Vector middle = middle_of(at, jet) + off_way(at, radius_mm, turn, sense);
        if (edges.nearest(middle, at.axis, at.depth_mm).distance_mm < jet.kerf_mm / 2 - kTouch_mm)
            return false;
    }
    return true;
}

// Returns points in the middle of long sections, the longest first.
std::vector<std::size_t> starts_of(const std::vector<JetPoint>& points) {
    std::vector<std::pair<double, std::size_t>> stretches;
    for (std::size_t begin = 0; begin + 1 < points.size();) {
        std::size_t end = begin;
        double length = 0;
        while (end + 1 < points.size() && points[end + 1].edge == points[begin].edge) {
            length += (points[end + 1].edge_mm - points[end].edge_mm).norm();
            ++end;
        }
        double half = length / 2;
        std::size_t at = begin;
        while (at < end && half > 0) {
            ++at;
            half -= (points[at].edge_mm - points[at - 1].edge_mm).norm();
        }
        stretches.emplace_back(-length, at);
        begin = end + 1;
    }
    std::sort(stretches.begin(), stretches.end());
    std::vector<std::size_t> starts;
    starts.reserve(stretches.size());
    for (const auto& [length, at] : stretches) starts.push_back(at);
    if (starts.size() > kMostStarts) starts.resize(kMostStarts);
    return starts;
}

void begin_at(std::size_t start, std::vector<JetPoint>& points) {
    points.pop_back();
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(start % points.size()),
                points.end());
    points.push_back(points.front());
}

Leads::Lead quarter(const JetPoint& at, const JetShape& jet, double radius_mm, double sense) {
    const Vector tip = tip_of(at, jet);
    return {tip + off_way(at, radius_mm, std::numbers::pi / 2, sense),
            tip + off_way(at, radius_mm, std::numbers::pi / 4, sense)};
}

// Returns a lead past an end of an open path, along its tangent.
std::optional<Leads::Lead> straight(const JetPoint& at, const JetShape& jet, const NearEdges& edges,
                                    double length_mm, double sense) {
    const Vector along = sense * length_mm * at.tangent;
    const int probes =
        std::max(kProbes, static_cast<int>(std::ceil(kProbesOfKerf * length_mm / jet.kerf_mm)));
    for (int i = 1; i <= probes; ++i) {
        const Vector middle = middle_of(at, jet) + static_cast<double>(i) / probes * along;
        if (edges.nearest(middle, at.axis, at.depth_mm).distance_mm < jet.kerf_mm / 2 - kTouch_mm)
            return std::nullopt;
    }
    return Leads::Lead{tip_of(at, jet) + along, std::nullopt};
}

std::optional<Leads> straight_leads(const JetWay& way, const JetShape& jet, const NearEdges& edges,
                                    double length_mm) {
    const Leads leads{straight(way.points.front(), jet, edges, length_mm, -1),
                      straight(way.points.back(), jet, edges, length_mm, 1), length_mm};
    if (!leads.in && !leads.out) return std::nullopt;
    return leads;
}

}  // namespace

std::optional<Leads> find_leads(JetWay& way, const JetShape& jet, const NearEdges& edges, double radius_mm) {
    if (way.is_open) return straight_leads(way, jet, edges, radius_mm);
    const std::vector<std::size_t> starts = starts_of(way.points);
    for (double radius = radius_mm; radius >= kLeastRadius_mm; radius /= 2) {
        for (const std::size_t start : starts) {
            const JetPoint& at = way.points[start];
            if (!is_clear(at, jet, edges, radius, -1) || !is_clear(at, jet, edges, radius, 1)) continue;
            const Leads leads{quarter(at, jet, radius, -1), quarter(at, jet, radius, 1),
                              radius * std::numbers::pi / 2};
            begin_at(start, way.points);
            return leads;
        }
    }
    if (!starts.empty()) begin_at(starts.front(), way.points);
    return std::nullopt;
}

}  // namespace gsim::surface
