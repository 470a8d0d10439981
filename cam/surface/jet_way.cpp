#include "cam/surface/jet_way.h"

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
#include "cam/surface/wall_touch.h"

namespace gsim::surface {

namespace {

using Fault = tl::unexpected<std::string>;
using EdgeWay = std::vector<JetPoint>;

constexpr double kSmooth_rad = 1.5 * kRadPerDeg;    // a turn that is no corner
constexpr double kCornerStep_rad = 5 * kRadPerDeg;  // of the jet about a corner
constexpr double kSame_mm = 1e-7;
constexpr double kFarKerfs = 20;  // max distance of the jet from a lower corner
constexpr double kSame = 1e-9;

JetPoint jet_point(const solid::WallPoint& point, std::size_t edge, const JetShape& jet,
                   const JetChoice& choice) {
    JetPoint at;
    at.edge_mm = vector_of(point.position_mm);
    at.normal = vector_of(point.normal);
    at.tangent = vector_of(point.tangent);
    at.depth_mm = point.depth_mm;
    at.edge = edge;
    const double tilt = choice.tilt_deg * kRadPerDeg;
    if (choice.along_walls) {
        at.aside = vector_of(point.wall_normal);
        at.axis = -vector_of(point.along_wall);
        // A tilt within the wall's plane does not change the wall.
        if (tilt != 0) at.axis = std::cos(tilt) * at.axis + std::sin(tilt) * across(at.tangent, at.axis);
    } else {
        const double lean = choice.lean_deg * kRadPerDeg;
        const Vector waste = at.tangent.cross(at.normal).normalized();
        const Vector leaned = std::cos(lean) * at.normal + std::sin(lean) * waste;
        at.axis = std::cos(tilt) * leaned + std::sin(tilt) * at.tangent;
        at.aside = at.tangent.cross(at.axis);
    }
    at.axis.normalize();
    at.aside = across(at.aside, at.axis);
    at.low_mm = at.edge_mm - at.depth_mm * at.axis;
    at.low_aside = at.aside;
    if (choice.touches_both()) {
        at.low_aside = vector_of(point.far_normal);
        touch_twisted(at, jet);
    }
    return at;
}

// Returns the intersection of two segments of the plane, as shares of both.
std::optional<std::pair<double, double>> crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                                  const Eigen::Vector2d& c, const Eigen::Vector2d& d) {
    const Eigen::Vector2d along = b - a;
    const Eigen::Vector2d other = d - c;
    const double turn = along.x() * other.y() - along.y() * other.x();
    if (std::abs(turn) < kSame * along.norm() * other.norm()) return std::nullopt;
    const Eigen::Vector2d off = c - a;
    const double first = (off.x() * other.y() - off.y() * other.x()) / turn;
    const double second = (off.x() * along.y() - off.y() * along.x()) / turn;
    if (first < -kSame || first > 1 + kSame || second < -kSame || second > 1 + kSame) return std::nullopt;
    return std::pair(first, second);
}

class WayMaker {
  public:
    WayMaker(const solid::WallContour& contour, const JetShape& jet, const JetChoice& choice)
        : contour_(contour), jet_(jet), choice_(choice) {}

    tl::expected<JetWay, std::string> run() {
        for (std::size_t i = 0; i < contour_.edges.size(); ++i) {
            if (auto added = add_edge(i); !added) return Fault(added.error());
        }
        if (edges_.size() == 1 && !contour_.is_open) split_single();
        corners_.resize(edges_.size());
        const std::size_t joints = contour_.is_open ? edges_.size() - 1 : edges_.size();
        for (std::size_t i = 0; i < joints; ++i) {
            if (auto joined = join(i, (i + 1) % edges_.size()); !joined) return Fault(joined.error());
        }
        if (auto good = check_bends(); !good) return Fault(good.error());
        return whole();
    }

  private:
    const std::string& name(std::size_t edge) const { return contour_.edges[edge].name; }

    tl::expected<void, std::string> add_edge(std::size_t number) {
        EdgeWay way;
        for (const solid::WallPoint& point : contour_.edges[number].points) {
            way.push_back(jet_point(point, number, jet_, choice_));
            const JetPoint& at = way.back();
            const double lean_deg = angle_between_rad(at.axis, at.normal) * kDegPerRad;
            if (lean_deg <= choice_.max_lean_deg) continue;
            return Fault(
                fmt::format("{} cannot be cut: at {} the jet would lean {:.4g} deg from the face's "
                            "normal, more than {:g} deg (--max-lean)",
                            name(number), shown(at.edge_mm), lean_deg, choice_.max_lean_deg));
        }
        edges_.push_back(std::move(way));
        return {};
    }

    // Splits a contour of one edge into two edges, so that it has corners between different edges.
    void split_single() {
        EdgeWay& only = edges_.front();
        const auto half = static_cast<std::ptrdiff_t>(only.size() / 2);
        EdgeWay second(only.begin() + half, only.end());
        only.resize(static_cast<std::size_t>(half) + 1);
        edges_.push_back(std::move(second));
    }

    tl::expected<void, std::string> join(std::size_t number, std::size_t next) {
        EdgeWay& before = edges_[number];
        EdgeWay& after = edges_[next];
        const JetPoint end = before.back();
        const JetPoint start = after.front();
        const Corner above = corner_of(end.tangent, start.tangent, end.normal);
        const Corner below =
            choice_.touches_both() ? corner_of(end.low_aside, start.low_aside, end.axis) : Corner::none;
        if (above == Corner::closes && !trim(before, after)) {
            return Fault(
                fmt::format("the corner at {} between {} and {} cannot be cut: it is narrower than the "
                            "kerf of {:g} mm",
                            shown(end.edge_mm), name(end.edge), name(start.edge), jet_.kerf_mm));
        }
        std::optional<Vector> low_stays;
        if (below == Corner::closes && takes_below(before, after))
            low_stays = stay_below(before, after, end, start);
        const Vector low_step = low_middle_of(before.back(), jet_) - low_middle_of(after.front(), jet_);
        if (above == Corner::opens || (below == Corner::opens && low_step.norm() > kMayTake_mm))
            turn_about(before.back(), after.front(), low_stays, corners_[number]);
        return {};
    }

    // Returns true if the jet at the end of one edge cuts into the lower edge of the other.
    bool takes_below(const EdgeWay& before, const EdgeWay& after) const {
        const double least_mm = jet_.kerf_mm / 2 - kMayTake_mm;
        return low_distance_mm(before.back(), after) < least_mm ||
               low_distance_mm(after.front(), before) < least_mm;
    }

    // Returns the distance from the jet's center to a lower edge, across the jet.
    double low_distance_mm(const JetPoint& at, const EdgeWay& edge) const {
        const Vector middle = middle_of(at, jet_);
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; i < edge.size(); ++i) {
            const auto flat = [&](const Vector& place) -> Vector {
                const Vector off = place - middle;
                return off - off.dot(at.axis) * at.axis;
            };
            const Vector from = flat(edge[i - 1].low_mm);
            const Vector along = flat(edge[i].low_mm) - from;
            const double share =
                along.norm() < kSame_mm ? 0 : std::clamp(-from.dot(along) / along.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (from + share * along).norm());
        }
        return nearest;
    }

    // Returns the position at which the lower end of the jet stays, because both edges come too near to it
    // after that.
    std::optional<Vector> stay_below(EdgeWay& before, EdgeWay& after, const JetPoint& end,
                                     const JetPoint& start) {
        auto place = trim_below(before, after, end.low_mm);
        if (!place) return std::nullopt;
        const double turn_rad = angle_between_rad(end.low_aside, start.low_aside);
        const double off_mm = (*place - end.low_mm).cross(end.axis).norm();
        low_corners_.push_back(
            {end.low_mm, turn_rad * kDegPerRad, std::max(0.0, off_mm - jet_.kerf_mm / 2), end.edge});
        return place;
    }

    void turn_about(const JetPoint& end, const JetPoint& start, const std::optional<Vector>& low_stays,
                    EdgeWay& corner) const {
        const double turn =
            std::max({angle_between_rad(end.aside, start.aside), angle_between_rad(end.axis, start.axis),
                      angle_between_rad(end.low_aside, start.low_aside)});
        const int steps = static_cast<int>(std::ceil(turn / kCornerStep_rad));
        const auto above = Eigen::Quaterniond::FromTwoVectors(end.aside, start.aside);
        const auto below = Eigen::Quaterniond::FromTwoVectors(end.low_aside, start.low_aside);
        EdgeWay straight;  // from axis to axis
        double most_mm = 0;
        for (int i = 1; i < steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            const auto part = [share](const Eigen::Quaterniond& whole) {
                return Eigen::Quaterniond::Identity().slerp(share, whole);
            };
            JetPoint at = between(end, start, share);
            at.low_aside = part(below) * end.low_aside;
            const Vector aside = part(above) * end.aside;
            at.aside = across(aside, at.axis);
            straight.push_back(at);
            at.aside = aside;
            if (low_stays)
                aim_low(at, *low_stays, jet_);
            else
                touch_both(at, jet_);
            corner.push_back(at);
            most_mm =
                std::max(most_mm, (low_middle_of(at, jet_) - low_middle_of(straight.back(), jet_)).norm());
        }
        if (most_mm <= kMayTake_mm) corner = std::move(straight);
    }

    struct Meeting {
        std::size_t before = 0, after = 0;         // they cross after these points
        double before_share = 0, after_share = 0;  // of the path to the next one
    };

    // Returns the intersection of two paths, seen along the jet, as near to the end of the first as possible.
    template <typename MiddleOf>
    static std::optional<Meeting> meeting(const EdgeWay& before, const EdgeWay& after,
                                          MiddleOf middle_of_point) {
        const Vector along = (before.back().axis + after.front().axis).normalized();
        const Vector x = across(before.back().tangent, along);
        const Vector y = along.cross(x);
        const auto flat = [&](const JetPoint& at) {
            const Vector middle = middle_of_point(at);
            return Eigen::Vector2d(middle.dot(x), middle.dot(y));
        };
        for (std::size_t i = before.size() - 1; i > 0; --i) {
            const Eigen::Vector2d from = flat(before[i - 1]);
            const Eigen::Vector2d to = flat(before[i]);
            for (std::size_t k = 0; k + 1 < after.size(); ++k) {
                const auto found = crossing(from, to, flat(after[k]), flat(after[k + 1]));
                if (found) return Meeting{i - 1, k, found->first, found->second};
            }
        }
        return std::nullopt;
    }

    // Trims both paths at their intersection.
    bool trim(EdgeWay& before, EdgeWay& after) const {
        const auto found = meeting(before, after, [this](const JetPoint& at) { return middle_of(at, jet_); });
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
    std::optional<Vector> trim_below(EdgeWay& before, EdgeWay& after, const Vector& corner_mm) const {
        const auto found =
            meeting(before, after, [this](const JetPoint& at) { return low_middle_of(at, jet_); });
        if (!found) return std::nullopt;
        const JetPoint last = between(before[found->before], before[found->before + 1], found->before_share);
        const JetPoint first = between(after[found->after], after[found->after + 1], found->after_share);
        const Vector place = (low_middle_of(last, jet_) + low_middle_of(first, jet_)) / 2;
        if ((place - corner_mm).norm() > kFarKerfs * jet_.kerf_mm) return std::nullopt;
        const std::size_t stays = found->before + 1;
        before.insert(before.begin() + static_cast<std::ptrdiff_t>(stays), last);
        for (std::size_t i = stays; i < before.size(); ++i) aim_low(before[i], place, jet_);
        const std::size_t leaves = found->after + 1;
        after.insert(after.begin() + static_cast<std::ptrdiff_t>(leaves), first);
        for (std::size_t i = 0; i <= leaves; ++i) aim_low(after[i], place, jet_);
        return place;
    }

    // The jet's path reverses at a curvature radius that is smaller than half of the kerf.
    tl::expected<void, std::string> check_bends() const {
        for (const EdgeWay& way : edges_) {
            for (std::size_t i = 1; i < way.size(); ++i) {
                const Vector on_edge = way[i].edge_mm - way[i - 1].edge_mm;
                const Vector beside = middle_of(way[i], jet_) - middle_of(way[i - 1], jet_);
                if (on_edge.norm() < kSame_mm || beside.dot(on_edge) > 0) continue;
                return Fault(
                    fmt::format("{} cannot be cut: at {} its radius is smaller than half of the "
                                "kerf, {:g} mm",
                                name(way[i].edge), shown(way[i].edge_mm), jet_.kerf_mm / 2));
            }
        }
        return {};
    }

    JetWay whole() const {
        JetWay way;
        way.is_hole = contour_.is_hole;
        way.is_open = contour_.is_open;
        const std::string_view closed = contour_.is_hole ? "a hole" : "the outline";
        way.name = fmt::format("{} of {}", contour_.is_open ? "a chain of edges" : closed, contour_.face);
        for (const solid::WallEdge& edge : contour_.edges) way.edges.push_back(edge.name);
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            for (const JetPoint& at : edges_[i]) add(at, way.points);
            for (const JetPoint& at : corners_[i]) add(at, way.points);
        }
        if (!contour_.is_open) way.points.push_back(way.points.front());
        way.low_corners = low_corners_;
        return way;
    }

    static void add(const JetPoint& at, EdgeWay& points) {
        if (!points.empty()) {
            const JetPoint& last = points.back();
            const bool same = (at.edge_mm - last.edge_mm).norm() < kSame_mm &&
                              (at.axis - last.axis).norm() < kSame && (at.aside - last.aside).norm() < 1e-6;
            if (same) points.pop_back();
        }
        points.push_back(at);
    }

    const solid::WallContour& contour_;
    const JetShape& jet_;
    const JetChoice& choice_;
    std::vector<EdgeWay> edges_;
    std::vector<EdgeWay> corners_;  // after each edge
    std::vector<LowCorner> low_corners_;
};

}  // namespace

double angle_between_rad(const Vector& a, const Vector& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Corner corner_of(const Vector& end, const Vector& start, const Vector& about) {
    if (angle_between_rad(end, start) <= kSmooth_rad) return Corner::none;
    return end.cross(start).dot(about) > 0 ? Corner::opens : Corner::closes;
}

JetPoint between(const JetPoint& a, const JetPoint& b, double share) {
    JetPoint at = a;
    at.edge_mm = a.edge_mm + share * (b.edge_mm - a.edge_mm);
    at.normal = (a.normal + share * (b.normal - a.normal)).normalized();
    at.tangent = (a.tangent + share * (b.tangent - a.tangent)).normalized();
    at.axis = (a.axis + share * (b.axis - a.axis)).normalized();
    at.aside = across(a.aside + share * (b.aside - a.aside), at.axis);
    at.low_mm = a.low_mm + share * (b.low_mm - a.low_mm);
    at.low_aside = across(a.low_aside + share * (b.low_aside - a.low_aside), at.axis);
    at.stays = false;
    at.depth_mm = a.depth_mm + share * (b.depth_mm - a.depth_mm);
    return at;
}

tl::expected<JetWay, std::string> jet_way(const solid::WallContour& contour, const JetShape& jet,
                                          const JetChoice& choice) {
    return WayMaker(contour, jet, choice).run();
}

std::string shown(const Vector& place) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", text::unsigned_zero(place.x()),
                       text::unsigned_zero(place.y()), text::unsigned_zero(place.z()));
}

}  // namespace gsim::surface
