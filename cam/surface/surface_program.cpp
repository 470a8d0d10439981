#include "cam/surface/surface_program.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"

namespace gsim::surface {

using path::MotionType;

namespace {

constexpr double kMinTravel_mm = 1e-6;
constexpr double kVerticalCosine = 1 - 1e-8;
// Limit for the TCP's feed as a share of the feed along the edge; past these limits the edge no longer
// counts.
constexpr double kMinShare = 0.05;
constexpr double kMaxFeedRatio = 5;

class CutWriter {
  public:
    CutWriter(const cutting::CutRules& rules, const SurfaceProgramOptions& options,
              cutting::CutSummary& summary)
        : rules_(rules), options_(options), summary_(summary) {}

    path::Path run(const SurfaceCut& cut) {
        const JetPoint& first = cut.jet_path.points.front();
        approach(cut.pierce(options_.jet), first.axis);
        if (cut.leads && cut.leads->in)
            lead(cut.leads->in->via_mm, tcp_position(first, options_.jet), cut, first);
        for (std::size_t i = 0; i < cut.parts.size(); ++i) {
            if (i > 0) cross_bridge(cut.parts[i - 1].back(), cut.parts[i].front());
            for (const JetMove& each : fit_moves(cut.parts[i], options_.jet, options_.tolerance)) add(each);
        }
        if (cut.leads && cut.leads->out)
            lead(cut.leads->out->via_mm, cut.leads->out->outer_mm, cut, cut.jet_path.points.back());
        last_point().actions = {"abrasive_off", "waterjet_off"};
        leave(cut.end(options_.jet), cut.jet_path.points.back().axis);
        return std::move(path_);
    }

  private:
    path::Point& last_point() { return std::get<path::Point>(path_.targets.back()); }

    path::Point& add_point(MotionType motion, const Vector& tcp) {
        path::Point point;
        point.motion = motion;
        point.position_mm = to_work_frame(tcp);
        path_.targets.emplace_back(std::move(point));
        return last_point();
    }

    path::Vector to_work_frame(const Vector& position) const {
        const Vector at = options_.origin_mm + position;
        return {at.x(), at.y(), at.z()};
    }

    static path::ToolAxis tool_axis(const Vector& axis) { return {{axis.x(), axis.y(), axis.z()}}; }

    double safe_z() const { return options_.part_top_mm + options_.safe_height_mm; }

    // Returns the position away from the part along the axis; `above` also the position straight up from
    // there.
    Vector away(const Vector& tcp, const Vector& axis) const { return tcp + options_.safe_height_mm * axis; }
    Vector above(const Vector& tcp, const Vector& axis) const {
        Vector up = axis.z() > kVerticalCosine ? tcp : away(tcp, axis);
        up.z() = std::max(up.z(), safe_z());
        return up;
    }

    void approach(const Vector& pierce, const Vector& axis) {
        add_point(MotionType::rapid, above(pierce, axis)).orientation = tool_axis(axis);
        if (axis.z() <= kVerticalCosine) add_point(MotionType::rapid, away(pierce, axis));
        start_jet(pierce);
    }

    void start_jet(const Vector& pierce) {
        add_point(MotionType::rapid, pierce).actions = {"waterjet_on", "abrasive_on"};
        ++summary_.pierces;
        if (rules_.pierce_s <= 0) return;
        path::Point& wait = add_point(MotionType::linear, pierce);
        wait.feed_mm_min = rules_.speed_mm_min;
        wait.dwell_s = rules_.pierce_s;
    }

    // Moves from one side of a bridge to the other, off the part.
    void cross_bridge(const JetPoint& from, const JetPoint& to) {
        last_point().actions = {"abrasive_off", "waterjet_off"};
        add_point(MotionType::rapid, away(tcp_position(from, options_.jet), from.axis));
        path::Point& over = add_point(MotionType::rapid, away(tcp_position(to, options_.jet), to.axis));
        over.orientation = tool_axis(to.axis);
        start_jet(tcp_position(to, options_.jet));
    }

    void leave(const Vector& tcp, const Vector& axis) {
        if (axis.z() <= kVerticalCosine) add_point(MotionType::rapid, away(tcp, axis));
        add_point(MotionType::rapid, above(tcp, axis));
    }

    double arc_feed_mm_min(double radius_mm) const {
        return rules_.feed_on_arc_mm_min ? rules_.feed_on_arc_mm_min(radius_mm) : rules_.speed_mm_min;
    }

    // A tilted jet has more material to cut through.
    double depth_feed_ratio(double depth_mm) const {
        if (!rules_.speed_at_depth_mm_min || depth_mm <= 0) return 1;
        return rules_.speed_at_depth_mm_min(depth_mm) / rules_.speed_mm_min;
    }

    double feed_mm_min(const JetMove& move) const {
        double feed = move.via_mm ? arc_feed_mm_min(move.radius_mm) : rules_.speed_mm_min;
        if (move.corner_rad != 0 && rules_.feed_in_corner_mm_min)
            feed = std::min(feed, rules_.feed_in_corner_mm_min(move.corner_rad));
        return feed * depth_feed_ratio(move.depth_mm);
    }

    void lead(const std::optional<Vector>& via, const Vector& end, const SurfaceCut& cut,
              const JetPoint& at) {
        const double length_mm = cut.leads->length_mm;
        const double straight_feed_mm_min = rules_.speed_mm_min * depth_feed_ratio(at.depth_mm);
        path::Point& point = add_point(via ? MotionType::circular : MotionType::linear, end);
        if (via) point.arc = path::ViaPoint{to_work_frame(*via)};
        point.feed_mm_min = via ? arc_feed_mm_min(length_mm * 4 / kTurn_rad) * depth_feed_ratio(at.depth_mm)
                                : straight_feed_mm_min;
        count(length_mm, *point.feed_mm_min, straight_feed_mm_min);
    }

    void add(const JetMove& move) {
        path::Point& point = add_point(move.via_mm ? MotionType::circular : MotionType::linear, move.end_mm);
        if (move.via_mm) point.arc = path::ViaPoint{to_work_frame(*move.via_mm)};
        if (move.axis_changes) point.orientation = tool_axis(move.axis);
        if (move.tcp_mm < kMinTravel_mm) {
            point.feed_deg_min = options_.turn_feed_deg_min;
            return;
        }
        const double share = move.edge_mm > kMinTravel_mm ? move.tcp_mm / move.edge_mm : 1;
        const double tcp_ratio = std::clamp(share, kMinShare, kMaxFeedRatio);
        point.feed_mm_min = feed_mm_min(move) * tcp_ratio;
        count(move.tcp_mm, *point.feed_mm_min,
              rules_.speed_mm_min * depth_feed_ratio(move.depth_mm) * tcp_ratio);
    }

    // `straight_feed_mm_min`: the feed on a straight line.
    void count(double mm, double feed_mm_min, double straight_feed_mm_min) {
        summary_.cut_mm += mm;
        summary_.cut_s += kSecondsPerMinute * mm / feed_mm_min;
        summary_.slowdown_s += kSecondsPerMinute * mm * (1 / feed_mm_min - 1 / straight_feed_mm_min);
    }

    const cutting::CutRules& rules_;
    const SurfaceProgramOptions& options_;
    cutting::CutSummary& summary_;
    path::Path path_;
};

path::Point start_point(const Vector& position) {
    path::Point point;
    point.motion = MotionType::rapid;
    point.position_mm = {position.x(), position.y(), position.z()};
    point.orientation = path::ToolAxis{{0, 0, 1}};
    return point;
}

}  // namespace

path::Program surface_program(std::span<const SurfaceCut> cuts, const cutting::CutRules& rules,
                              const SurfaceProgramOptions& options, cutting::CutSummary& summary) {
    path::Program program;
    program.name = options.name;
    program.paths.resize(1);
    program.paths.front().name = "all contours";
    if (options.start_mm) program.paths.front().targets.emplace_back(start_point(*options.start_mm));
    std::optional<Vector> last;
    for (const SurfaceCut& cut : cuts) {
        program.paths.front().targets.emplace_back(path::SubPath{program.paths.size(), 1});
        program.paths.push_back(CutWriter(rules, options, summary).run(cut));
        program.paths.back().name = fmt::format("contour {}", program.paths.size() - 1);
        ++summary.outlines;
        if (!cut.has_both_leads()) ++summary.without_leads;
        if (last) summary.travel_mm += (cut.pierce(options.jet) - *last).norm();
        last = cut.end(options.jet);
    }
    if (options.start_mm) program.paths.front().targets.emplace_back(start_point(*options.start_mm));
    return program;
}

}  // namespace gsim::surface
