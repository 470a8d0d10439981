#include "cam/surface/jet_way.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/text/number.h"
#include "base/units.h"

namespace gsim::surface {

namespace {

using Fault = tl::unexpected<std::string>;
using EdgeWay = std::vector<JetPoint>;

constexpr double kSmooth_rad = 1.5 * kRadPerDeg;    // a turn that is no corner
constexpr double kCornerStep_rad = 5 * kRadPerDeg;  // of the jet about a corner
constexpr double kSame_mm = 1e-7;
constexpr double kSame = 1e-9;

double angle_between(const Vector& a, const Vector& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Vector across(const Vector& direction, const Vector& axis) {
    return (direction - direction.dot(axis) * axis).normalized();
}

JetPoint jet_point(const solid::WallPoint& point, std::size_t edge, const JetChoice& choice) {
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
        // A tilt within the wall's plane leaves the wall as it is.
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
    return at;
}

// Where two segments of the plane cross, as shares of both.
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
        if (edges_.size() == 1) split_single();
        corners_.resize(edges_.size());
        for (std::size_t i = 0; i < edges_.size(); ++i) {
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
            way.push_back(jet_point(point, number, choice_));
            const JetPoint& at = way.back();
            const double lean_deg = angle_between(at.axis, at.normal) * kDegPerRad;
            if (lean_deg <= choice_.max_lean_deg) continue;
            return Fault(
                fmt::format("{} cannot be cut: at {} the jet would lean {:.1f} deg from the face's "
                            "normal, more than {:g} deg (--max-lean)",
                            name(number), shown(at.edge_mm), lean_deg, choice_.max_lean_deg));
        }
        edges_.push_back(std::move(way));
        return {};
    }

    // A contour of one edge becomes one of two, so that it has corners between different edges.
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
        const double turn = angle_between(end.tangent, start.tangent);
        if (turn <= kSmooth_rad) return {};
        if (end.tangent.cross(start.tangent).dot(end.normal) > 0) {
            turn_about(end, start, corners_[number]);
            return {};
        }
        if (trim(before, after)) return {};
        return Fault(
            fmt::format("the corner at {} between {} and {} cannot be cut: it is narrower than the "
                        "kerf of {:g} mm",
                        shown(end.edge_mm), name(end.edge), name(start.edge), jet_.kerf_mm));
    }

    static void turn_about(const JetPoint& end, const JetPoint& start, EdgeWay& corner) {
        const double turn =
            std::max(angle_between(end.aside, start.aside), angle_between(end.axis, start.axis));
        const int steps = static_cast<int>(std::ceil(turn / kCornerStep_rad));
        const auto half_way = Eigen::Quaterniond::FromTwoVectors(end.aside, start.aside);
        for (int i = 1; i < steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            JetPoint at = between(end, start, share);
            const Eigen::Quaterniond part = Eigen::Quaterniond::Identity().slerp(share, half_way);
            at.aside = across(part * end.aside, at.axis);
            corner.push_back(at);
        }
    }

    // Cuts both off where their ways cross, seen along the jet.
    bool trim(EdgeWay& before, EdgeWay& after) const {
        const Vector along = (before.back().axis + after.front().axis).normalized();
        const Vector x = across(before.back().tangent, along);
        const Vector y = along.cross(x);
        const auto flat = [&](const JetPoint& at) {
            const Vector middle = middle_of(at, jet_);
            return Eigen::Vector2d(middle.dot(x), middle.dot(y));
        };
        for (std::size_t i = before.size() - 1; i > 0; --i) {
            const Eigen::Vector2d from = flat(before[i - 1]);
            const Eigen::Vector2d to = flat(before[i]);
            for (std::size_t k = 0; k + 1 < after.size(); ++k) {
                const auto found = crossing(from, to, flat(after[k]), flat(after[k + 1]));
                if (!found) continue;
                const JetPoint last = between(before[i - 1], before[i], found->first);
                const JetPoint first = between(after[k], after[k + 1], found->second);
                before.resize(i);
                before.push_back(last);
                after.erase(after.begin(), after.begin() + static_cast<std::ptrdiff_t>(k) + 1);
                after.insert(after.begin(), first);
                return true;
            }
        }
        return false;
    }

    // Beside a bend that is narrower than the jet its way turns back.
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
        way.name = fmt::format("{} of {}", contour_.is_hole ? "a hole" : "the outline", contour_.face);
        for (const solid::WallEdge& edge : contour_.edges) way.edges.push_back(edge.name);
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            for (const JetPoint& at : edges_[i]) add(at, way.points);
            for (const JetPoint& at : corners_[i]) add(at, way.points);
        }
        way.points.push_back(way.points.front());
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
    std::vector<EdgeWay> corners_;  // behind each edge
};

}  // namespace

JetPoint between(const JetPoint& a, const JetPoint& b, double share) {
    JetPoint at = a;
    at.edge_mm = a.edge_mm + share * (b.edge_mm - a.edge_mm);
    at.normal = (a.normal + share * (b.normal - a.normal)).normalized();
    at.tangent = (a.tangent + share * (b.tangent - a.tangent)).normalized();
    at.axis = (a.axis + share * (b.axis - a.axis)).normalized();
    at.aside = across(a.aside + share * (b.aside - a.aside), at.axis);
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
