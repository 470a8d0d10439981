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

constexpr double kMaxArcRadius_mm = 1e5;   // beyond it arcs are said by a point on them, not by their centre
constexpr double kMinArcHeight_mm = 1e-4;  // arcs that are no higher over their chord are lines
constexpr double kVerticalTolerance_rad = 1e-11;
constexpr double kMinTcpRadius_mm = 0.01;                  // min radius of the TCP path about a center
constexpr double kMaxTurnStep_rad = std::numbers::pi / 4;  // of a leaning tool in one block
constexpr double kAngleTolerance = 1e-6;
constexpr double kPierceStrokeKerfs = 2;
constexpr double kMaxPierceStrokes = 20;  // to and fro; longer pierces go slower

double to_radians(double deg) {
    return deg * kRadPerDeg;
}

bool is_curved(const Edge& edge) {
    return is_arc(edge) && std::abs(edge.bulge) * distance(edge.start, edge.end) / 2 > kMinArcHeight_mm;
}

geometry::Point turned(geometry::Point a, double turn_rad) {
    return std::cos(turn_rad) * a + std::sin(turn_rad) * left_normal(a);
}

int turn_step_count(double turn_rad) {
    return std::max(1, static_cast<int>(std::ceil(std::abs(turn_rad) / kMaxTurnStep_rad - kAngleTolerance)));
}

// Tilt of the jet: to the right of its path, over the waste.
struct Tilt {
    geometry::Point tangent;
    double bevel_rad = 0;
};

// The points of one cut.
class CutPathBuilder {
  public:
    CutPathBuilder(const CutRules& rules, std::span<const double> bevels_deg, const ProgramOptions& options)
        : rules_(rules), bevels_deg_(bevels_deg), options_(options) {}

    path::Path run(const Cut& cut) {
        const std::vector<FeedSegment> edges = assign_feeds(cut.loop, rules_);
        is_tilted_ = std::any_of(edges.begin(), edges.end(), [&](const FeedSegment& edge) {
            return std::abs(tilt_rad(edge)) > kVerticalTolerance_rad;
        });
        const Edge first = cut.lead_in ? *cut.lead_in : cut.loop.edge(0);
        const double first_tilt_rad = tilt_rad(edges.front());
        tilt_ = {start_tangent(first), first_tilt_rad};
        const geometry::Point pierce = tcp_over(cut.pierce(), tilt_);
        path::Point& above = add_point(MotionType::rapid, pierce, options_.heights.safe_mm);
        above.orientation = tool_axis();  // machines with rotary axes want to know it
        path::Point& approach_point = add_point(MotionType::rapid, pierce, options_.heights.cut_mm);
        approach_point.actions = {"waterjet_on", "abrasive_on"};
        add_pierce(cut);
        if (cut.lead_in) cut_edge(lead_edge(*cut.lead_in), first_tilt_rad);
        for (const FeedSegment& edge : edges) cut_edge(edge, tilt_rad(edge));
        if (cut.lead_out) cut_edge(lead_edge(*cut.lead_out), tilt_rad(edges.back()));
        last_point().actions = {"abrasive_off", "waterjet_off"};
        add_point(MotionType::rapid, tcp_over(cut.end(), tilt_), options_.heights.safe_mm);
        return std::move(path_);
    }

    double reorientation_s() const { return reorientation_s_; }
    bool has_dynamic_pierce() const { return has_dynamic_pierce_; }

  private:
    /// Returns the tilt for the bevel and the taper compensation of the kerf.
    double tilt_rad(const FeedSegment& edge) const {
        const double edge_bevel_deg = edge.source < bevels_deg_.size() ? bevels_deg_[edge.source] : 0;
        const double bevel_deg = std::abs(edge_bevel_deg) > 0 ? edge_bevel_deg : options_.bevel_deg;
        const auto& taper_compensation = rules_.taper_compensation_deg;
        return to_radians(bevel_deg + (taper_compensation ? taper_compensation(edge.feed_mm_min) : 0));
    }

    FeedSegment lead_edge(const Edge& lead) const { return {lead, edge_feed_mm_min(lead, rules_)}; }

    void add_pierce(const Cut& cut) {
        if (rules_.dynamic_pierce_s && cut.lead_in &&
            add_dynamic_pierce(*cut.lead_in, *rules_.dynamic_pierce_s))
            return;
        if (rules_.pierce_s <= 0) return;
        path::Point& wait =
            add_point(MotionType::linear, tcp_over(cut.pierce(), tilt_), options_.heights.cut_mm);
        wait.feed_mm_min = rules_.speed_mm_min;
        wait.dwell_s = rules_.pierce_s;
    }

    /// Moves back and forth at the beginning of the lead, at about its cutting feed, for exactly that time.
    /// Returns false if the lead is too short.
    bool add_dynamic_pierce(const Edge& lead, double time_s) {
        const double distance_mm = std::min(kPierceStrokeKerfs * rules_.kerf_mm, length_mm(lead) / 2);
        if (distance_mm < rules_.kerf_mm / 2 || time_s <= 0) return false;
        const double cycle_count = time_s * rules_.speed_mm_min / 60 / (2 * distance_mm);
        const int turns = static_cast<int>(std::clamp(std::round(cycle_count), 1.0, kMaxPierceStrokes));
        const Edge stroke = sub_edge(lead, 0, distance_mm / length_mm(lead));
        for (int i = 0; i < turns; ++i) {
            for (const Edge& edge : {stroke, reversed(stroke)}) {
                path::Point& point = add_point(is_curved(edge) ? MotionType::circular : MotionType::linear,
                                               tcp_over(edge.end, tilt_), options_.heights.cut_mm);
                point.feed_mm_min = 60 * 2 * turns * distance_mm / time_s;
                if (is_curved(edge)) point.arc = arc_about(tcp_over(geometry::center(edge), tilt_), edge);
                if (is_tilted_) point.orientation = tool_axis();
            }
        }
        has_dynamic_pierce_ = true;
        return true;
    }

    path::Point& last_point() { return std::get<path::Point>(path_.targets.back()); }

    path::Point& add_point(MotionType motion, geometry::Point at, double height_mm) {
        path::Point point;
        point.motion = motion;
        point.position_mm = to_work_frame(at, height_mm);
        path_.targets.emplace_back(std::move(point));
        return last_point();
    }

    path::Vector to_work_frame(geometry::Point point, double height_mm) const {
        const path::Vector& origin = options_.origin_mm;
        return {origin[0] + point.x, origin[1] + point.y, origin[2] + height_mm};
    }

    // Returns the distance from an upright TCP to the tilted one, to the right.
    double tcp_offset_mm(double bevel_rad) const {
        if (std::abs(bevel_rad) <= kVerticalTolerance_rad) return 0;
        return options_.heights.cut_mm * std::tan(bevel_rad) +
               rules_.kerf_mm / 2 * (1 / std::cos(bevel_rad) - 1);
    }

    geometry::Point tcp_over(geometry::Point point, const Tilt& tilt) const {
        return point + tcp_offset_mm(tilt.bevel_rad) * right_normal(tilt.tangent);
    }

    path::ToolAxis tool_axis() const {
        const geometry::Point lateral = std::sin(tilt_.bevel_rad) * right_normal(tilt_.tangent);
        return {{lateral.x, lateral.y, std::cos(tilt_.bevel_rad)}};
    }

    // If the jet is tilted, the tool turns along an arc in steps, so that the rotation from each orientation
    // to the next is unambiguous.
    void cut_edge(const FeedSegment& segment, double tilt_rad) {
        const Edge& edge = segment.edge;
        if (is_tilted_) reorient_to(edge.start, {start_tangent(edge), tilt_rad});
        const bool arc = is_curved(edge);
        const int steps =
            arc && std::abs(tilt_rad) > kVerticalTolerance_rad ? turn_step_count(sweep_rad(edge)) : 1;
        for (int i = 0; i < steps; ++i) {
            const Edge part = steps == 1 ? edge
                                         : sub_edge(edge, static_cast<double>(i) / steps,
                                                    static_cast<double>(i + 1) / steps);
            tilt_ = {end_tangent(part), tilt_rad};
            cut_part(part, segment.feed_mm_min, arc);
        }
    }

    void cut_part(const Edge& part, double feed_mm_min, bool arc) {
        const double share = arc ? tcp_radius_ratio(part) : 1;
        // If the TCP is over the center of an arc, the tool only turns.
        const bool turns = arc && std::abs(share) * radius_mm(part) < kMinTcpRadius_mm;
        path::Point& point = add_point(arc && !turns ? MotionType::circular : MotionType::linear,
                                       tcp_over(part.end, tilt_), options_.heights.cut_mm);
        point.feed_mm_min = feed_mm_min * (turns ? 1 : std::abs(share));
        if (turns) {
            point.feed_deg_min = std::abs(sweep_rad(part)) * kDegPerRad / length_mm(part) * feed_mm_min;
        } else if (arc) {
            point.arc = arc_geometry(part);
        }
        if (is_tilted_) point.orientation = tool_axis();
    }

    // Returns the radius of the TCP's arc as a share of the edge's radius; below 0 it runs on the other side
    // of the center.
    double tcp_radius_ratio(const Edge& edge) const {
        const double outward_sign = edge.bulge > 0 ? 1 : -1;
        return 1 + outward_sign * tcp_offset_mm(tilt_.bevel_rad) / radius_mm(edge);
    }

    // Turns the tool in a corner, about the corner on the material.
    void reorient_to(geometry::Point corner, const Tilt& to) {
        constexpr double kEqualTolerance = 1e-6;
        const bool same_bevel = std::abs(to.bevel_rad - tilt_.bevel_rad) <= kEqualTolerance;
        if (same_bevel && distance(to.tangent, tilt_.tangent) <= kEqualTolerance) return;
        const Tilt from = tilt_;
        const double turn_rad = std::atan2(cross(from.tangent, to.tangent), dot(from.tangent, to.tangent));
        const int steps = turn_step_count(turn_rad);
        for (int i = 1; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            tilt_ = i == steps ? to
                               : Tilt{turned(from.tangent, share * turn_rad),
                                      from.bevel_rad + share * (to.bevel_rad - from.bevel_rad)};
            rotate_about_corner(corner, turn_rad / steps, same_bevel);
        }
        const double turn_deg =
            std::max(std::abs(turn_rad), std::abs(to.bevel_rad - from.bevel_rad)) * kDegPerRad;
        reorientation_s_ += 60 * turn_deg / options_.turn_feed_deg_min;
    }

    void rotate_about_corner(geometry::Point corner, double turn_rad, bool same_bevel) {
        const double radius = std::abs(tcp_offset_mm(tilt_.bevel_rad));
        const bool arc = same_bevel && radius * std::abs(turn_rad) > kMinArcHeight_mm;
        path::Point& point = add_point(arc ? MotionType::circular : MotionType::linear,
                                       tcp_over(corner, tilt_), options_.heights.cut_mm);
        if (arc) {
            point.arc = path::CenterArc{to_work_frame(corner, options_.heights.cut_mm),
                                        {0, 0, turn_rad > 0 ? 1.0 : -1.0},
                                        std::abs(turn_rad) * kDegPerRad};
            point.feed_mm_min = radius * to_radians(options_.turn_feed_deg_min);
        }
        point.feed_deg_min = options_.turn_feed_deg_min;
        point.orientation = tool_axis();
    }

    std::variant<path::ViaPoint, path::CenterArc> arc_geometry(const Edge& edge) const {
        const double z = options_.heights.cut_mm;
        if (radius_mm(edge) > kMaxArcRadius_mm) {
            const Edge half = sub_edge(edge, 0, 0.5);
            return path::ViaPoint{to_work_frame(tcp_over(half.end, {end_tangent(half), tilt_.bevel_rad}), z)};
        }
        return arc_about(geometry::center(edge), edge);
    }

    path::CenterArc arc_about(geometry::Point center, const Edge& edge) const {
        const double sweep_deg = sweep_rad(edge) * kDegPerRad;
        return {to_work_frame(center, options_.heights.cut_mm),
                {0, 0, sweep_deg > 0 ? 1.0 : -1.0},
                std::abs(sweep_deg)};
    }

    const CutRules& rules_;
    std::span<const double> bevels_deg_;
    const ProgramOptions& options_;
    path::Path path_;
    Tilt tilt_;
    bool is_tilted_ = false;
    double reorientation_s_ = 0;
    bool has_dynamic_pierce_ = false;
};

}  // namespace

CutProgram cut_program(const std::vector<Cut>& cuts, std::span<const std::size_t> order,
                       const CutRules& rules, std::span<const double> bevels_deg,
                       const ProgramOptions& options) {
    CutProgram program_parts;
    path::Program& program = program_parts.program;
    program.name = options.name;
    program.paths.resize(1);
    program.paths.front().name = "all contours";
    program.paths.reserve(order.size() + 1);
    for (const std::size_t cut : order) {
        program.paths.front().targets.emplace_back(path::SubPath{program.paths.size(), 1});
        CutPathBuilder path(rules, bevels_deg, options);
        program.paths.push_back(path.run(cuts[cut]));
        program.paths.back().name = fmt::format("contour {}", program.paths.size() - 1);
        program_parts.reorientation_s += path.reorientation_s();
        if (path.has_dynamic_pierce()) ++program_parts.dynamic_pierces;
    }
    return program_parts;
}

}  // namespace gsim::cutting
