#include "cam/surface/surface_lead.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace gsim::surface {

namespace {

constexpr double kMinLeadRadius_mm = 0.05;
constexpr double kClearanceTolerance_mm =
    0.02;  // of which points of edges between those that are known may be nearer
constexpr int kProbeCount = 9;
constexpr double kProbesPerKerf = 4;  // of a straight lead
constexpr int kMaxStarts = 24;

// Returns a point of a quarter circle that ends on the path: the offset at `turn` of its sweep, back against
// the path.
Vector lead_offset(const JetPoint& at, double radius_mm, double turn, double sense) {
    const Vector waste_direction = at.tangent.cross(at.normal).normalized();
    return radius_mm * ((1 - std::cos(turn)) * waste_direction + sense * std::sin(turn) * at.tangent);
}

bool is_clear(const JetPoint& at, const JetShape& jet, const EdgeProximity& edges, double radius_mm,
              double sense) {
    for (int i = 1; i <= kProbeCount; ++i) {
        const double turn = std::numbers::pi / 2 * i / kProbeCount;
        const Vector middle = jet_center(at, jet) + lead_offset(at, radius_mm, turn, sense);
        if (edges.nearest(middle, at.axis, at.depth_mm).distance_mm <
            jet.kerf_mm / 2 - kClearanceTolerance_mm)
            return false;
    }
    return true;
}

// Returns points in the middle of long sections, the longest first.
std::vector<std::size_t> start_candidates(const std::vector<JetPoint>& points) {
    std::vector<std::pair<double, std::size_t>> sections;
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
        sections.emplace_back(-length, at);
        begin = end + 1;
    }
    std::sort(sections.begin(), sections.end());
    std::vector<std::size_t> starts;
    starts.reserve(sections.size());
    for (const auto& [length, at] : sections) starts.push_back(at);
    if (starts.size() > kMaxStarts) starts.resize(kMaxStarts);
    return starts;
}

void rotate_start(std::size_t start, std::vector<JetPoint>& points) {
    points.pop_back();
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(start % points.size()),
                points.end());
    points.push_back(points.front());
}

Leads::Lead quarter_arc(const JetPoint& at, const JetShape& jet, double radius_mm, double sense) {
    const Vector tcp = tcp_position(at, jet);
    return {tcp + lead_offset(at, radius_mm, std::numbers::pi / 2, sense),
            tcp + lead_offset(at, radius_mm, std::numbers::pi / 4, sense)};
}

// Returns a lead past an end of an open path, along its tangent.
std::optional<Leads::Lead> straight_lead(const JetPoint& at, const JetShape& jet, const EdgeProximity& edges,
                                         double length_mm, double sense) {
    const Vector lead_vector = sense * length_mm * at.tangent;
    const int sample_count =
        std::max(kProbeCount, static_cast<int>(std::ceil(kProbesPerKerf * length_mm / jet.kerf_mm)));
    for (int i = 1; i <= sample_count; ++i) {
        const Vector middle = jet_center(at, jet) + static_cast<double>(i) / sample_count * lead_vector;
        if (edges.nearest(middle, at.axis, at.depth_mm).distance_mm <
            jet.kerf_mm / 2 - kClearanceTolerance_mm)
            return std::nullopt;
    }
    return Leads::Lead{tcp_position(at, jet) + lead_vector, std::nullopt};
}

std::optional<Leads> straight_leads(const JetPath& jet_path, const JetShape& jet, const EdgeProximity& edges,
                                    double length_mm) {
    const Leads leads{straight_lead(jet_path.points.front(), jet, edges, length_mm, -1),
                      straight_lead(jet_path.points.back(), jet, edges, length_mm, 1), length_mm};
    if (!leads.in && !leads.out) return std::nullopt;
    return leads;
}

}  // namespace

std::optional<Leads> find_leads(JetPath& jet_path, const JetShape& jet, const EdgeProximity& edges,
                                double radius_mm) {
    if (jet_path.is_open) return straight_leads(jet_path, jet, edges, radius_mm);
    const std::vector<std::size_t> starts = start_candidates(jet_path.points);
    for (double radius = radius_mm; radius >= kMinLeadRadius_mm; radius /= 2) {
        for (const std::size_t start : starts) {
            const JetPoint& at = jet_path.points[start];
            if (!is_clear(at, jet, edges, radius, -1) || !is_clear(at, jet, edges, radius, 1)) continue;
            const Leads leads{quarter_arc(at, jet, radius, -1), quarter_arc(at, jet, radius, 1),
                              radius * std::numbers::pi / 2};
            rotate_start(start, jet_path.points);
            return leads;
        }
    }
    if (!starts.empty()) rotate_start(starts.front(), jet_path.points);
    return std::nullopt;
}

}  // namespace gsim::surface
