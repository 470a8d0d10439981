#include "cam/cutting/cut_program.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "base/units.h"
#include "cam/cutting/feeds.h"

namespace gsim::cutting {

using geometry::Edge;
using path::MotionType;

namespace {

constexpr double kGreatestRadius_mm = 1e5;  // beyond it arcs are said by a point on them, not by their centre
constexpr double kFlat_mm = 1e-4;           // arcs that are no higher over their chord are lines
constexpr double kUpright_rad = 1e-11;
constexpr double kLeastTipRadius_mm = 0.01;  // of the tip's way about a center
constexpr double kTurnStep_rad = std::numbers::pi / 4;

double rad(double deg) {
    return deg * kRadPerDeg;
}

// How the jet leans: to the right of its way, over the waste.
struct Lean {
    geometry::Point tangent;
    double bevel_rad = 0;
};

// The points of one cut.
class CutPath {
  public:
    CutPath(const CutRules& rules, std::span<const double> bevels_deg, const ProgramOptions& options)
        : rules_(rules), bevels_deg_(bevels_deg), options_(options) {}

    path::Path run(const Cut& cut) {
        const std::vector<FedEdge> edges = with_feeds(cut.loop, rules_);
        leans_ = std::any_of(edges.begin(), edges.end(), [&](const FedEdge& edge) {
            return std::abs(bevel_rad(edge.source)) > kUpright_rad;
        });
        const Edge first = cut.lead_in ? *cut.lead_in : cut.loop.edge(0);
        lean_ = {start_tangent(first), bevel_rad(edges.front().source)};
        const geometry::Point pierce = tip_over(cut.pierce(), lean_);
        path::Point& above = add_point(MotionType::rapid, pierce, options_.heights.safe_mm);
        above.orientation = tool_axis();  // machines with rotary axes want to know it
        path::Point& down = add_point(MotionType::rapid, pierce, options_.heights.cut_mm);
        down.actions = {"waterjet_on", "abrasive_on"};
        if (rules_.pierce_s > 0) {
            path::Point& wait = add_point(MotionType::linear, pierce, options_.heights.cut_mm);
            wait.feed_mm_min = rules_.speed_mm_min;
            wait.dwell_s = rules_.pierce_s;
        }
        if (cut.lead_in) cut_edge({*cut.lead_in, feed_on_mm_min(*cut.lead_in, rules_), edges.front().source});
        for (const FedEdge& edge : edges) cut_edge(edge);
        if (cut.lead_out)
            cut_edge({*cut.lead_out, feed_on_mm_min(*cut.lead_out, rules_), edges.back().source});
        last_point().actions = {"abrasive_off", "waterjet_off"};
        add_point(MotionType::rapid, tip_over(cut.end(), lean_), options_.heights.safe_mm);
        return std::move(path_);
    }

  private:
    double bevel_rad(std::uint32_t source) const {
        const double own = source < bevels_deg_.size() ? bevels_deg_[source] : 0;
        return rad(std::abs(own) > 0 ? own : options_.bevel_deg);
    }

    path::Point& last_point() { return std::get<path::Point>(path_.targets.back()); }

    path::Point& add_point(MotionType motion, geometry::Point at, double height_mm) {
        path::Point point;
        point.motion = motion;
        point.position_mm = in_work(at, height_mm);
        path_.targets.emplace_back(std::move(point));
        return last_point();
    }

    path::Vector in_work(geometry::Point point, double height_mm) const {
        const path::Vector& origin = options_.origin_mm;
        return {origin[0] + point.x, origin[1] + point.y, origin[2] + height_mm};
    }

    // How far the tip is to the right of where an upright one would be.
    double aside_mm(double bevel_rad) const {
        if (std::abs(bevel_rad) <= kUpright_rad) return 0;
        return options_.heights.cut_mm * std::tan(bevel_rad) +
               rules_.kerf_mm / 2 * (1 / std::cos(bevel_rad) - 1);
    }

    geometry::Point tip_over(geometry::Point point, const Lean& lean) const {
        return point + aside_mm(lean.bevel_rad) * right_of(lean.tangent);
    }

    path::ToolAxis tool_axis() const {
        const geometry::Point aside = std::sin(lean_.bevel_rad) * right_of(lean_.tangent);
        return {{aside.x, aside.y, std::cos(lean_.bevel_rad)}};
    }

    void cut_edge(const FedEdge& fed) {
        const Edge& edge = fed.edge;
        const double bevel = bevel_rad(fed.source);
        if (leans_) turn_to(edge.start, {start_tangent(edge), bevel});
        lean_ = {end_tangent(edge), bevel};
        const bool arc = is_arc(edge) && std::abs(edge.bulge) * distance(edge.start, edge.end) / 2 > kFlat_mm;
        const double share = arc ? tip_share(edge) : 1;
        if (arc && std::abs(share) * radius_mm(edge) < kLeastTipRadius_mm) {
            turn_over_center(fed);
            return;
        }
        path::Point& point = add_point(arc ? MotionType::circular : MotionType::linear,
                                       tip_over(edge.end, lean_), options_.heights.cut_mm);
        point.feed_mm_min = fed.feed_mm_min * std::abs(share);
        if (arc) point.arc = arc_of(edge);
        if (leans_) point.orientation = tool_axis();
    }

    // The radius of the tip's arc as a share of the edge's; below 0 it runs on the other side of the center.
    double tip_share(const Edge& edge) const {
        const double outwards = edge.bulge > 0 ? 1 : -1;
        return 1 + outwards * aside_mm(lean_.bevel_rad) / radius_mm(edge);
    }

    // The tip stands over the center of an arc, and the tool turns.
    void turn_over_center(const FedEdge& fed) {
        const int steps = static_cast<int>(std::ceil(std::abs(sweep_rad(fed.edge)) / kTurnStep_rad));
        const double turn_deg = std::abs(sweep_rad(fed.edge)) * kDegPerRad;
        for (int i = 1; i <= steps; ++i) {
            const Edge part =
                part_of(fed.edge, static_cast<double>(i - 1) / steps, static_cast<double>(i) / steps);
            lean_.tangent = end_tangent(part);
            path::Point& point =
                add_point(MotionType::linear, tip_over(part.end, lean_), options_.heights.cut_mm);
            point.feed_mm_min = fed.feed_mm_min;
            point.feed_deg_min = turn_deg / length_mm(fed.edge) * fed.feed_mm_min;
            point.orientation = tool_axis();
        }
    }

    // In a corner the tool turns about the corner on the material.
    void turn_to(geometry::Point corner, const Lean& lean) {
        constexpr double kSame = 1e-6;
        const bool same_bevel = std::abs(lean.bevel_rad - lean_.bevel_rad) <= kSame;
        if (same_bevel && distance(lean.tangent, lean_.tangent) <= kSame) return;
        const double turn = std::atan2(cross(lean_.tangent, lean.tangent), dot(lean_.tangent, lean.tangent));
        const double radius = std::abs(aside_mm(lean.bevel_rad));
        lean_ = lean;
        const bool arc = same_bevel && radius * std::abs(turn) > kFlat_mm;
        path::Point& point = add_point(arc ? MotionType::circular : MotionType::linear,
                                       tip_over(corner, lean), options_.heights.cut_mm);
        if (arc) {
            const double turn_deg = std::abs(turn) * kDegPerRad;
            point.arc = path::CenterArc{
                in_work(corner, options_.heights.cut_mm), {0, 0, turn > 0 ? 1.0 : -1.0}, turn_deg};
            point.feed_mm_min = radius * rad(options_.turn_feed_deg_min);
        }
        point.feed_deg_min = options_.turn_feed_deg_min;
        point.orientation = tool_axis();
    }

    std::variant<path::ViaPoint, path::CenterArc> arc_of(const Edge& edge) const {
        const double z = options_.heights.cut_mm;
        if (radius_mm(edge) > kGreatestRadius_mm) {
            const Edge half = part_of(edge, 0, 0.5);
            return path::ViaPoint{in_work(tip_over(half.end, {end_tangent(half), lean_.bevel_rad}), z)};
        }
        const geometry::Point center = geometry::center(edge);
        const double sweep_deg = sweep_rad(edge) * kDegPerRad;
        return path::CenterArc{in_work(center, z), {0, 0, sweep_deg > 0 ? 1.0 : -1.0}, std::abs(sweep_deg)};
    }

    const CutRules& rules_;
    std::span<const double> bevels_deg_;
    const ProgramOptions& options_;
    path::Path path_;
    Lean lean_;
    bool leans_ = false;
};

}  // namespace

path::Program cut_program(const std::vector<Cut>& cuts, std::span<const std::size_t> order,
                          const CutRules& rules, std::span<const double> bevels_deg,
                          const ProgramOptions& options) {
    path::Program program;
    program.name = options.name;
    program.paths.resize(1);
    program.paths.front().name = "all contours";
    program.paths.reserve(order.size() + 1);
    for (const std::size_t cut : order) {
        program.paths.front().targets.emplace_back(path::SubPath{program.paths.size(), 1});
        program.paths.push_back(CutPath(rules, bevels_deg, options).run(cuts[cut]));
        program.paths.back().name = fmt::format("contour {}", program.paths.size() - 1);
    }
    return program;
}

}  // namespace gsim::cutting
