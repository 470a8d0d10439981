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
constexpr double kLeastTipRadius_mm = 0.01;             // min radius of the TCP path about a center
constexpr double kTurnStep_rad = std::numbers::pi / 4;  // of a leaning tool in one block
constexpr double kSameAngle = 1e-6;
constexpr double kPierceWayKerfs = 2;
constexpr double kMostPierceTurns = 20;  // to and fro; longer pierces go slower

double rad(double deg) {
    return deg * kRadPerDeg;
}

bool bends(const Edge& edge) {
    return is_arc(edge) && std::abs(edge.bulge) * distance(edge.start, edge.end) / 2 > kFlat_mm;
}

geometry::Point turned(geometry::Point a, double turn_rad) {
    return std::cos(turn_rad) * a + std::sin(turn_rad) * left_of(a);
}

int turn_steps(double turn_rad) {
    return std::max(1, static_cast<int>(std::ceil(std::abs(turn_rad) / kTurnStep_rad - kSameAngle)));
}

// Tilt of the jet: to the right of its path, over the waste.
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
        leans_ = std::any_of(edges.begin(), edges.end(),
                             [&](const FedEdge& edge) { return std::abs(lean_rad(edge)) > kUpright_rad; });
        const Edge first = cut.lead_in ? *cut.lead_in : cut.loop.edge(0);
        const double first_lean_rad = lean_rad(edges.front());
        lean_ = {start_tangent(first), first_lean_rad};
        const geometry::Point pierce = tip_over(cut.pierce(), lean_);
        path::Point& above = add_point(MotionType::rapid, pierce, options_.heights.safe_mm);
        above.orientation = tool_axis();  // machines with rotary axes want to know it
        path::Point& down = add_point(MotionType::rapid, pierce, options_.heights.cut_mm);
        down.actions = {"waterjet_on", "abrasive_on"};
        pierce_material(cut);
        if (cut.lead_in) cut_edge(lead_edge(*cut.lead_in), first_lean_rad);
        for (const FedEdge& edge : edges) cut_edge(edge, lean_rad(edge));
        if (cut.lead_out) cut_edge(lead_edge(*cut.lead_out), lean_rad(edges.back()));
        last_point().actions = {"abrasive_off", "waterjet_off"};
        add_point(MotionType::rapid, tip_over(cut.end(), lean_), options_.heights.safe_mm);
        return std::move(path_);
    }

    double turning_s() const { return turning_s_; }
    bool pierced_moving() const { return pierced_moving_; }

  private:
    /// Returns the tilt for the bevel and the taper compensation of the kerf.
    double lean_rad(const FedEdge& edge) const {
        const double own = edge.source < bevels_deg_.size() ? bevels_deg_[edge.source] : 0;
        const double bevel_deg = std::abs(own) > 0 ? own : options_.bevel_deg;
        const auto& against_taper = rules_.straightening_lean_deg;
        return rad(bevel_deg + (against_taper ? against_taper(edge.feed_mm_min) : 0));
    }

    FedEdge lead_edge(const Edge& lead) const { return {lead, feed_on_mm_min(lead, rules_)}; }

    void pierce_material(const Cut& cut) {
        if (rules_.moving_pierce_s && cut.lead_in && pierce_moving(*cut.lead_in, *rules_.moving_pierce_s))
            return;
        if (rules_.pierce_s <= 0) return;
        path::Point& wait =
            add_point(MotionType::linear, tip_over(cut.pierce(), lean_), options_.heights.cut_mm);
        wait.feed_mm_min = rules_.speed_mm_min;
        wait.dwell_s = rules_.pierce_s;
    }

    /// Moves back and forth at the beginning of the lead, at about its cutting feed, for exactly that time.
    /// Returns false if the lead is too short.
    bool pierce_moving(const Edge& lead, double time_s) {
        const double way_mm = std::min(kPierceWayKerfs * rules_.kerf_mm, length_mm(lead) / 2);
        if (way_mm < rules_.kerf_mm / 2 || time_s <= 0) return false;
        const double there_and_back = time_s * rules_.speed_mm_min / 60 / (2 * way_mm);
        const int turns = static_cast<int>(std::clamp(std::round(there_and_back), 1.0, kMostPierceTurns));
        const Edge there = part_of(lead, 0, way_mm / length_mm(lead));
        for (int i = 0; i < turns; ++i) {
            for (const Edge& edge : {there, reversed(there)}) {
                path::Point& point = add_point(bends(edge) ? MotionType::circular : MotionType::linear,
                                               tip_over(edge.end, lean_), options_.heights.cut_mm);
                point.feed_mm_min = 60 * 2 * turns * way_mm / time_s;
                if (bends(edge)) point.arc = arc_about(tip_over(geometry::center(edge), lean_), edge);
                if (leans_) point.orientation = tool_axis();
            }
        }
        pierced_moving_ = true;
        return true;
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

    // Returns the distance from an upright TCP to the tilted one, to the right.
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

    // If the jet is tilted, the tool turns along an arc in steps, so that the rotation from each orientation
    // to the next is unambiguous.
    void cut_edge(const FedEdge& fed, double lean_rad) {
        const Edge& edge = fed.edge;
        if (leans_) turn_to(edge.start, {start_tangent(edge), lean_rad});
        const bool arc = bends(edge);
        const int steps = arc && std::abs(lean_rad) > kUpright_rad ? turn_steps(sweep_rad(edge)) : 1;
        for (int i = 0; i < steps; ++i) {
            const Edge part = steps == 1 ? edge
                                         : part_of(edge, static_cast<double>(i) / steps,
                                                   static_cast<double>(i + 1) / steps);
            lean_ = {end_tangent(part), lean_rad};
            cut_part(part, fed.feed_mm_min, arc);
        }
    }

    void cut_part(const Edge& part, double feed_mm_min, bool arc) {
        const double share = arc ? tip_share(part) : 1;
        // If the TCP is over the center of an arc, the tool only turns.
        const bool turns = arc && std::abs(share) * radius_mm(part) < kLeastTipRadius_mm;
        path::Point& point = add_point(arc && !turns ? MotionType::circular : MotionType::linear,
                                       tip_over(part.end, lean_), options_.heights.cut_mm);
        point.feed_mm_min = feed_mm_min * (turns ? 1 : std::abs(share));
        if (turns) {
            point.feed_deg_min = std::abs(sweep_rad(part)) * kDegPerRad / length_mm(part) * feed_mm_min;
        } else if (arc) {
            point.arc = arc_of(part);
        }
        if (leans_) point.orientation = tool_axis();
    }

    // Returns the radius of the TCP's arc as a share of the edge's radius; below 0 it runs on the other side
    // of the center.
    double tip_share(const Edge& edge) const {
        const double outwards = edge.bulge > 0 ? 1 : -1;
        return 1 + outwards * aside_mm(lean_.bevel_rad) / radius_mm(edge);
    }

    // Turns the tool in a corner, about the corner on the material.
    void turn_to(geometry::Point corner, const Lean& to) {
        constexpr double kSame = 1e-6;
        const bool same_bevel = std::abs(to.bevel_rad - lean_.bevel_rad) <= kSame;
        if (same_bevel && distance(to.tangent, lean_.tangent) <= kSame) return;
        const Lean from = lean_;
        const double turn_rad = std::atan2(cross(from.tangent, to.tangent), dot(from.tangent, to.tangent));
        const int steps = turn_steps(turn_rad);
        for (int i = 1; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            lean_ = i == steps ? to
                               : Lean{turned(from.tangent, share * turn_rad),
                                      from.bevel_rad + share * (to.bevel_rad - from.bevel_rad)};
            turn_about(corner, turn_rad / steps, same_bevel);
        }
        const double turn_deg =
            std::max(std::abs(turn_rad), std::abs(to.bevel_rad - from.bevel_rad)) * kDegPerRad;
        turning_s_ += 60 * turn_deg / options_.turn_feed_deg_min;
    }

    void turn_about(geometry::Point corner, double turn_rad, bool same_bevel) {
        const double radius = std::abs(aside_mm(lean_.bevel_rad));
        const bool arc = same_bevel && radius * std::abs(turn_rad) > kFlat_mm;
        path::Point& point = add_point(arc ? MotionType::circular : MotionType::linear,
                                       tip_over(corner, lean_), options_.heights.cut_mm);
        if (arc) {
            point.arc = path::CenterArc{in_work(corner, options_.heights.cut_mm),
                                        {0, 0, turn_rad > 0 ? 1.0 : -1.0},
                                        std::abs(turn_rad) * kDegPerRad};
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
        return arc_about(geometry::center(edge), edge);
    }

    path::CenterArc arc_about(geometry::Point center, const Edge& edge) const {
        const double sweep_deg = sweep_rad(edge) * kDegPerRad;
        return {in_work(center, options_.heights.cut_mm),
                {0, 0, sweep_deg > 0 ? 1.0 : -1.0},
                std::abs(sweep_deg)};
    }

    const CutRules& rules_;
    std::span<const double> bevels_deg_;
    const ProgramOptions& options_;
    path::Path path_;
    Lean lean_;
    bool leans_ = false;
    double turning_s_ = 0;
    bool pierced_moving_ = false;
};

}  // namespace

CutProgram cut_program(const std::vector<Cut>& cuts, std::span<const std::size_t> order,
                       const CutRules& rules, std::span<const double> bevels_deg,
                       const ProgramOptions& options) {
    CutProgram made;
    path::Program& program = made.program;
    program.name = options.name;
    program.paths.resize(1);
    program.paths.front().name = "all contours";
    program.paths.reserve(order.size() + 1);
    for (const std::size_t cut : order) {
        program.paths.front().targets.emplace_back(path::SubPath{program.paths.size(), 1});
        CutPath path(rules, bevels_deg, options);
        program.paths.push_back(path.run(cuts[cut]));
        program.paths.back().name = fmt::format("contour {}", program.paths.size() - 1);
        made.turning_s += path.turning_s();
        if (path.pierced_moving()) ++made.moving_pierces;
    }
    return made;
}

}  // namespace gsim::cutting
