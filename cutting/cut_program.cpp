#include "cutting/cut_program.h"

#include <numbers>

#include <fmt/format.h>

#include "cutting/feeds.h"

namespace gsim::cutting {

using geometry::Edge;
using path::MotionType;

namespace {

constexpr double kGreatestRadius_mm = 1e5;  // beyond it arcs are said by a point on them, not by their centre
constexpr double kFlat_mm = 1e-4;           // arcs that are no higher over their chord are lines
constexpr double kUpright_deg = 1e-9;

// The points of one cut.
class CutPath {
  public:
    CutPath(const CutRules& rules, const ProgramOptions& options) : rules_(rules), options_(options) {}

    path::Path run(const Cut& cut) {
        const std::vector<FedEdge> edges = with_feeds(cut.loop, rules_);
        const geometry::Point pierce = cut.pierce();
        const Edge first = cut.lead_in ? *cut.lead_in : cut.loop.edge(0);
        lean_along(start_tangent(first));
        path::Point& above = add_point(MotionType::rapid, pierce, options_.heights.safe_mm);
        above.orientation = tool_axis_;  // machines with rotary axes want to know it
        path::Point& down = add_point(MotionType::rapid, pierce, options_.heights.cut_mm);
        down.actions = {"waterjet_on", "abrasive_on"};
        if (rules_.pierce_s > 0) {
            path::Point& wait = add_point(MotionType::linear, pierce, options_.heights.cut_mm);
            wait.feed_mm_min = rules_.speed_mm_min;
            wait.dwell_s = rules_.pierce_s;
        }
        if (cut.lead_in) cut_edge(*cut.lead_in, feed_on_mm_min(*cut.lead_in, rules_));
        for (const FedEdge& edge : edges) cut_edge(edge.edge, edge.feed_mm_min);
        if (cut.lead_out) cut_edge(*cut.lead_out, feed_on_mm_min(*cut.lead_out, rules_));
        last_point().actions = {"abrasive_off", "waterjet_off"};
        add_point(MotionType::rapid, cut.end(), options_.heights.safe_mm);
        return std::move(path_);
    }

  private:
    bool leans() const { return std::abs(options_.bevel_deg) > kUpright_deg; }
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

    // The nozzle leans to the right of the way, over the waste.
    void lean_along(geometry::Point tangent) {
        const double angle = options_.bevel_deg * std::numbers::pi / 180;
        const geometry::Point aside = std::sin(angle) * right_of(tangent);
        tangent_ = tangent;
        tool_axis_ = {{aside.x, aside.y, std::cos(angle)}};
    }

    void cut_edge(const Edge& edge, double feed_mm_min) {
        if (leans()) turn_to(start_tangent(edge));
        const bool arc = is_arc(edge) && std::abs(edge.bulge) * distance(edge.start, edge.end) / 2 > kFlat_mm;
        path::Point& point =
            add_point(arc ? MotionType::circular : MotionType::linear, edge.end, options_.heights.cut_mm);
        point.feed_mm_min = feed_mm_min;
        if (arc) point.arc = arc_of(edge);
        if (!leans()) return;
        lean_along(end_tangent(edge));
        point.orientation = tool_axis_;
    }

    // In a corner the tool turns where it stands.
    void turn_to(geometry::Point tangent) {
        constexpr double kSame = 1e-6;
        if (distance(tangent, tangent_) <= kSame) return;
        const path::Point& here = last_point();
        path::Point turn;
        turn.position_mm = here.position_mm;
        turn.feed_deg_min = options_.turn_feed_deg_min;
        lean_along(tangent);
        turn.orientation = tool_axis_;
        path_.targets.emplace_back(std::move(turn));
    }

    std::variant<path::ViaPoint, path::CenterArc> arc_of(const Edge& edge) const {
        const double z = options_.heights.cut_mm;
        if (radius_mm(edge) > kGreatestRadius_mm) {
            const geometry::Point via = point_at(edge, 0.5);
            return path::ViaPoint{in_work(via, z)};
        }
        const geometry::Point center = geometry::center(edge);
        const double sweep_deg = sweep_rad(edge) * 180 / std::numbers::pi;
        return path::CenterArc{in_work(center, z), {0, 0, sweep_deg > 0 ? 1.0 : -1.0}, std::abs(sweep_deg)};
    }

    const CutRules& rules_;
    const ProgramOptions& options_;
    path::Path path_;
    geometry::Point tangent_;
    path::ToolAxis tool_axis_;
};

}  // namespace

path::Program cut_program(const std::vector<Cut>& cuts, std::span<const std::size_t> order,
                          const CutRules& rules, const ProgramOptions& options) {
    path::Program program;
    program.name = options.name;
    program.paths.resize(1);
    program.paths.front().name = "all contours";
    program.paths.reserve(order.size() + 1);
    for (const std::size_t cut : order) {
        program.paths.front().targets.emplace_back(path::SubPath{program.paths.size(), 1});
        program.paths.push_back(CutPath(rules, options).run(cuts[cut]));
        program.paths.back().name = fmt::format("contour {}", program.paths.size() - 1);
    }
    return program;
}

}  // namespace gsim::cutting
