#include "cam/surface/jet_path.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/text/number.h"
#include "base/units.h"
#include "cam/surface/wall_alignment.h"

namespace gsim::surface {

namespace {

using EdgePath = std::vector<JetPoint>;

constexpr double kMinCornerAngle_rad = 1.5 * kRadPerDeg;  // a turn that is no corner
constexpr double kCornerStep_rad = 5 * kRadPerDeg;        // of the jet about a corner
constexpr double kMinMotion_mm = 1e-7;
constexpr double kMaxCornerDistanceKerfs = 20;  // max distance of the jet from a lower corner
constexpr double kEqualTolerance = 1e-9;

JetPoint make_jet_point(const solid::WallPoint& point, std::size_t edge, const JetShape& jet,
                        const JetOptions& options) {
    JetPoint at;
    at.edge_mm = to_vector(point.position_mm);
    at.normal = to_vector(point.normal);
    at.tangent = to_vector(point.tangent);
    at.depth_mm = point.depth_mm;
    at.edge = edge;
    const double lead_angle = options.lead_angle_deg * kRadPerDeg;
    if (options.along_walls) {
        at.lateral = to_vector(point.wall_normal);
        at.axis = -to_vector(point.along_wall);
        // A tilt within the wall's plane does not change the wall.
        if (lead_angle != 0)
            at.axis =
                std::cos(lead_angle) * at.axis + std::sin(lead_angle) * perpendicular(at.tangent, at.axis);
    } else {
        const double tilt = options.tilt_deg * kRadPerDeg;
        const Vector waste_direction = at.tangent.cross(at.normal).normalized();
        const Vector tilted_axis = std::cos(tilt) * at.normal + std::sin(tilt) * waste_direction;
        at.axis = std::cos(lead_angle) * tilted_axis + std::sin(lead_angle) * at.tangent;
        at.lateral = at.tangent.cross(at.axis);
    }
    at.axis.normalize();
    at.lateral = perpendicular(at.lateral, at.axis);
    at.low_mm = at.edge_mm - at.depth_mm * at.axis;
    at.lower_offset_direction = at.lateral;
    if (options.follows_both_edges()) {
        at.lower_offset_direction = to_vector(point.exit_normal);
        align_to_twisted_wall(at, jet);
    }
    return at;
}

// Returns the intersection of two segments of the plane, as shares of both.
std::optional<std::pair<double, double>> crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                                  const Eigen::Vector2d& c, const Eigen::Vector2d& d) {
    const Eigen::Vector2d direction = b - a;
    const Eigen::Vector2d other = d - c;
    const double turn = direction.x() * other.y() - direction.y() * other.x();
    if (std::abs(turn) < kEqualTolerance * direction.norm() * other.norm()) return std::nullopt;
    const Eigen::Vector2d offset = c - a;
    const double first = (offset.x() * other.y() - offset.y() * other.x()) / turn;
    const double second = (offset.x() * direction.y() - offset.y() * direction.x()) / turn;
    if (first < -kEqualTolerance || first > 1 + kEqualTolerance || second < -kEqualTolerance ||
        second > 1 + kEqualTolerance)
        return std::nullopt;
    return std::pair(first, second);
}

class JetPathBuilder {
  public:
    JetPathBuilder(const solid::WallContour& contour, const JetShape& jet, const JetOptions& options)
        : contour_(contour), jet_(jet), options_(options) {}

    Result<JetPath> run() {
        for (std::size_t i = 0; i < contour_.edges.size(); ++i) {
            if (auto result = add_edge(i); !result) return Unexpected(result.error());
        }
        if (edges_.size() == 1 && !contour_.is_open) split_single_edge();
        corners_.resize(edges_.size());
        const std::size_t joints = contour_.is_open ? edges_.size() - 1 : edges_.size();
        for (std::size_t i = 0; i < joints; ++i) {
            if (auto joined = join(i, (i + 1) % edges_.size()); !joined) return Unexpected(joined.error());
        }
        if (auto checked = check_curvature(); !checked) return Unexpected(checked.error());
        return full_path();
    }

  private:
    const std::string& name(std::size_t edge) const { return contour_.edges[edge].name; }

    Result<void> add_edge(std::size_t number) {
        EdgePath jet_path;
        for (const solid::WallPoint& point : contour_.edges[number].points) {
            jet_path.push_back(make_jet_point(point, number, jet_, options_));
            const JetPoint& at = jet_path.back();
            const double tilt_deg = angle_between_rad(at.axis, at.normal) * kDegPerRad;
            if (tilt_deg <= options_.max_tilt_deg) continue;
            return Unexpected(
                fmt::format("{} cannot be cut: at {} the jet would be tilted {:.4g} deg from the face "
                            "normal, more than {:g} deg (--max-tilt)",
                            name(number), display_text(at.edge_mm), tilt_deg, options_.max_tilt_deg));
        }
        edges_.push_back(std::move(jet_path));
        return {};
    }

    // Splits a contour of one edge into two edges, so that it has corners between different edges.
    void split_single_edge() {
        EdgePath& only = edges_.front();
        const auto half = static_cast<std::ptrdiff_t>(only.size() / 2);
        EdgePath second(only.begin() + half, only.end());
        only.resize(static_cast<std::size_t>(half) + 1);
        edges_.push_back(std::move(second));
    }

    Result<void> join(std::size_t number, std::size_t next) {
        EdgePath& before = edges_[number];
        EdgePath& after = edges_[next];
        const JetPoint end = before.back();
        const JetPoint start = after.front();
        const Corner above = classify_corner(end.tangent, start.tangent, end.normal);
        const Corner below =
            options_.follows_both_edges()
                ? classify_corner(end.lower_offset_direction, start.lower_offset_direction, end.axis)
                : Corner::none;
        if (above == Corner::concave && !trim(before, after)) {
            return Unexpected(
                fmt::format("the corner at {} between {} and {} cannot be cut: it is narrower than the "
                            "kerf of {:g} mm",
                            display_text(end.edge_mm), name(end.edge), name(start.edge), jet_.kerf_mm));
        }
        std::optional<Vector> lower_pivot;
        if (below == Corner::concave && gouges_lower_edge(before, after))
            lower_pivot = pivot_lower_end(before, after, end, start);
        const Vector lower_step =
            lower_jet_center(before.back(), jet_) - lower_jet_center(after.front(), jet_);
        if (above == Corner::convex || (below == Corner::convex && lower_step.norm() > kAllowedGouge_mm))
            rotate_about_corner(before.back(), after.front(), lower_pivot, corners_[number]);
        return {};
    }

    // Returns true if the jet at the end of one edge cuts into the lower edge of the other.
    bool gouges_lower_edge(const EdgePath& before, const EdgePath& after) const {
        const double min_mm = jet_.kerf_mm / 2 - kAllowedGouge_mm;
        return lower_distance_mm(before.back(), after) < min_mm ||
               lower_distance_mm(after.front(), before) < min_mm;
    }

    // Returns the distance from the jet's center to a lower edge, across the jet.
    double lower_distance_mm(const JetPoint& at, const EdgePath& edge) const {
        const Vector middle = jet_center(at, jet_);
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; i < edge.size(); ++i) {
            const auto flat = [&](const Vector& position) -> Vector {
                const Vector offset = position - middle;
                return offset - offset.dot(at.axis) * at.axis;
            };
            const Vector from = flat(edge[i - 1].low_mm);
            const Vector direction = flat(edge[i].low_mm) - from;
            const double share = direction.norm() < kMinMotion_mm
                                     ? 0
                                     : std::clamp(-from.dot(direction) / direction.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (from + share * direction).norm());
        }
        return nearest;
    }

    // Returns the position where the lower end of the jet stays, because both edges then come too near to it.
    std::optional<Vector> pivot_lower_end(EdgePath& before, EdgePath& after, const JetPoint& end,
                                          const JetPoint& start) {
        auto position = trim_lower_ends(before, after, end.low_mm);
        if (!position) return std::nullopt;
        const double turn_rad = angle_between_rad(end.lower_offset_direction, start.lower_offset_direction);
        const double deviation_mm = (*position - end.low_mm).cross(end.axis).norm();
        lower_corners_.push_back(
            {end.low_mm, turn_rad * kDegPerRad, std::max(0.0, deviation_mm - jet_.kerf_mm / 2), end.edge});
        return position;
    }

    void rotate_about_corner(const JetPoint& end, const JetPoint& start,
                             const std::optional<Vector>& lower_pivot, EdgePath& corner) const {
        const double turn =
            std::max({angle_between_rad(end.lateral, start.lateral), angle_between_rad(end.axis, start.axis),
                      angle_between_rad(end.lower_offset_direction, start.lower_offset_direction)});
        const int steps = static_cast<int>(std::ceil(turn / kCornerStep_rad));
        const auto above = Eigen::Quaterniond::FromTwoVectors(end.lateral, start.lateral);
        const auto below =
            Eigen::Quaterniond::FromTwoVectors(end.lower_offset_direction, start.lower_offset_direction);
        EdgePath straight;  // from axis to axis
        double max_mm = 0;
        for (int i = 1; i < steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            const auto part = [share](const Eigen::Quaterniond& full_path) {
                return Eigen::Quaterniond::Identity().slerp(share, full_path);
            };
            JetPoint at = between(end, start, share);
            at.lower_offset_direction = part(below) * end.lower_offset_direction;
            const Vector lateral = part(above) * end.lateral;
            at.lateral = perpendicular(lateral, at.axis);
            straight.push_back(at);
            at.lateral = lateral;
            if (lower_pivot)
                aim_lower_end(at, *lower_pivot, jet_);
            else
                align_to_both_edges(at, jet_);
            corner.push_back(at);
            max_mm = std::max(max_mm,
                              (lower_jet_center(at, jet_) - lower_jet_center(straight.back(), jet_)).norm());
        }
        if (max_mm <= kAllowedGouge_mm) corner = std::move(straight);
    }

    struct PathIntersection {
        std::size_t before = 0, after = 0;         // they cross past these points
        double before_share = 0, after_share = 0;  // of the path to the next one
    };

    // Returns the intersection of two paths, seen along the jet, as near to the end of the first as possible.
    template <typename MiddleOf>
    static std::optional<PathIntersection> find_intersection(const EdgePath& before, const EdgePath& after,
                                                             MiddleOf center_of_point) {
        const Vector direction = (before.back().axis + after.front().axis).normalized();
        const Vector x = perpendicular(before.back().tangent, direction);
        const Vector y = direction.cross(x);
        const auto flat = [&](const JetPoint& at) {
            const Vector middle = center_of_point(at);
            return Eigen::Vector2d(middle.dot(x), middle.dot(y));
        };
        for (std::size_t i = before.size() - 1; i > 0; --i) {
            const Eigen::Vector2d from = flat(before[i - 1]);
            const Eigen::Vector2d to = flat(before[i]);
            for (std::size_t k = 0; k + 1 < after.size(); ++k) {
                const auto found = crossing(from, to, flat(after[k]), flat(after[k + 1]));
                if (found) return PathIntersection{i - 1, k, found->first, found->second};
            }
        }
        return std::nullopt;
    }

    // Trims both paths at their intersection.
    bool trim(EdgePath& before, EdgePath& after) const {
        const auto found =
            find_intersection(before, after, [this](const JetPoint& at) { return jet_center(at, jet_); });
        if (!found) return false;
        const JetPoint last = between(before[found->before], before[found->before + 1], found->before_share);
        const JetPoint first = between(after[found->after], after[found->after + 1], found->after_share);
        before.resize(found->before + 1);
        before.push_back(last);
        after.erase(after.begin(), after.begin() + static_cast<std::ptrdiff_t>(found->after) + 1);
        after.insert(after.begin(), first);
        return true;
    }

    // At the intersection of the paths of the lower ends, near their corner, the lower end of the jet stays
    // while its upper end moves on.
    std::optional<Vector> trim_lower_ends(EdgePath& before, EdgePath& after, const Vector& corner_mm) const {
        const auto found = find_intersection(
            before, after, [this](const JetPoint& at) { return lower_jet_center(at, jet_); });
        if (!found) return std::nullopt;
        const JetPoint last = between(before[found->before], before[found->before + 1], found->before_share);
        const JetPoint first = between(after[found->after], after[found->after + 1], found->after_share);
        const Vector position = (lower_jet_center(last, jet_) + lower_jet_center(first, jet_)) / 2;
        if ((position - corner_mm).norm() > kMaxCornerDistanceKerfs * jet_.kerf_mm) return std::nullopt;
        const std::size_t is_fixed = found->before + 1;
        before.insert(before.begin() + static_cast<std::ptrdiff_t>(is_fixed), last);
        for (std::size_t i = is_fixed; i < before.size(); ++i) aim_lower_end(before[i], position, jet_);
        const std::size_t resume_index = found->after + 1;
        after.insert(after.begin() + static_cast<std::ptrdiff_t>(resume_index), first);
        for (std::size_t i = 0; i <= resume_index; ++i) aim_lower_end(after[i], position, jet_);
        return position;
    }

    // The jet's path reverses at a curvature radius that is smaller than half of the kerf.
    Result<void> check_curvature() const {
        for (const EdgePath& jet_path : edges_) {
            for (std::size_t i = 1; i < jet_path.size(); ++i) {
                const Vector edge_step = jet_path[i].edge_mm - jet_path[i - 1].edge_mm;
                const Vector step = jet_center(jet_path[i], jet_) - jet_center(jet_path[i - 1], jet_);
                if (edge_step.norm() < kMinMotion_mm || step.dot(edge_step) > 0) continue;
                return Unexpected(
                    fmt::format("{} cannot be cut: at {} its radius is smaller than half the kerf, {:g} mm",
                                name(jet_path[i].edge), display_text(jet_path[i].edge_mm), jet_.kerf_mm / 2));
            }
        }
        return {};
    }

    JetPath full_path() const {
        JetPath jet_path;
        jet_path.is_hole = contour_.is_hole;
        jet_path.is_open = contour_.is_open;
        const std::string_view closed = contour_.is_hole ? "a hole" : "the outline";
        jet_path.name =
            fmt::format("{} of {}", contour_.is_open ? "a chain of edges" : closed, contour_.face);
        for (const solid::WallEdge& edge : contour_.edges) jet_path.edges.push_back(edge.name);
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            for (const JetPoint& at : edges_[i]) add(at, jet_path.points);
            for (const JetPoint& at : corners_[i]) add(at, jet_path.points);
        }
        if (!contour_.is_open) jet_path.points.push_back(jet_path.points.front());
        jet_path.lower_corners = lower_corners_;
        return jet_path;
    }

    static void add(const JetPoint& at, EdgePath& points) {
        if (!points.empty()) {
            const JetPoint& last = points.back();
            const bool same = (at.edge_mm - last.edge_mm).norm() < kMinMotion_mm &&
                              (at.axis - last.axis).norm() < kEqualTolerance &&
                              (at.lateral - last.lateral).norm() < 1e-6;
            if (same) points.pop_back();
        }
        points.push_back(at);
    }

    const solid::WallContour& contour_;
    const JetShape& jet_;
    const JetOptions& options_;
    std::vector<EdgePath> edges_;
    std::vector<EdgePath> corners_;  // at the end of each edge
    std::vector<LowerCorner> lower_corners_;
};

}  // namespace

double angle_between_rad(const Vector& a, const Vector& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Corner classify_corner(const Vector& end, const Vector& start, const Vector& about) {
    if (angle_between_rad(end, start) <= kMinCornerAngle_rad) return Corner::none;
    return end.cross(start).dot(about) > 0 ? Corner::convex : Corner::concave;
}

JetPoint between(const JetPoint& a, const JetPoint& b, double share) {
    JetPoint at = a;
    at.edge_mm = a.edge_mm + share * (b.edge_mm - a.edge_mm);
    at.normal = (a.normal + share * (b.normal - a.normal)).normalized();
    at.tangent = (a.tangent + share * (b.tangent - a.tangent)).normalized();
    at.axis = (a.axis + share * (b.axis - a.axis)).normalized();
    at.lateral = perpendicular(a.lateral + share * (b.lateral - a.lateral), at.axis);
    at.low_mm = a.low_mm + share * (b.low_mm - a.low_mm);
    at.lower_offset_direction = perpendicular(
        a.lower_offset_direction + share * (b.lower_offset_direction - a.lower_offset_direction), at.axis);
    at.is_fixed = false;
    at.depth_mm = a.depth_mm + share * (b.depth_mm - a.depth_mm);
    return at;
}

Result<JetPath> jet_path(const solid::WallContour& contour, const JetShape& jet, const JetOptions& options) {
    return JetPathBuilder(contour, jet, options).run();
}

std::string display_text(const Vector& position) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", text::unsigned_zero(position.x()),
                       text::unsigned_zero(position.y()), text::unsigned_zero(position.z()));
}

}  // namespace gsim::surface
