#include "analysis/envelope/region.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>

#include "analysis/envelope/closed_form_reach.h"
#include "analysis/envelope/closest_approach.h"
#include "analysis/envelope/nearest_reach.h"

namespace gsim::envelope {

namespace {

using Eigen::Vector2d;

constexpr int kNodes = 300;
constexpr double kTolerance = 0.25;  // of the step
constexpr double kSquareHalfDiagonal = std::numbers::sqrt2 / 2;
constexpr double kJoinTolerance_mm = 1e-6;

/// Distances from the reach of the TCP, at the nodes of squares in its plane, and the line about those nodes
/// that are near it.
class PlaneField {
  public:
    PlaneField(const TcpChain& chain, const PlaneView& view) : chain_(chain), view_(view), tail_(chain) {
        const Eigen::AlignedBox3d box = swept_box(chain.joints.front(), tail_.bounds());
        Eigen::AlignedBox2d flat;
        for (int i = 0; i < 8; ++i)
            flat.extend(to_plane(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i))));
        step_mm_ = std::max(flat.sizes().maxCoeff(), 1e-3) / kNodes;
        low_ = flat.min() - Vector2d::Constant(3 * step_mm_);
        columns_ = static_cast<std::int64_t>(std::ceil(flat.sizes().x() / step_mm_)) + 7;
        rows_ = static_cast<std::int64_t>(std::ceil(flat.sizes().y() / step_mm_)) + 7;
        fill();
    }

    double iso_level_mm() const { return (kTolerance + kSquareHalfDiagonal) * step_mm_; }

    Region extract_border() {
        for (std::int64_t node = 0; node < columns_ * (rows_ - 1); ++node) {
            if (node % columns_ == columns_ - 1) continue;
            add_triangle({node, node + 1, node + columns_ + 1});
            add_triangle({node, node + columns_ + 1, node + columns_});
        }
        Region region{{}, 2 * iso_level_mm()};
        while (!next_.empty()) region.loops_mm.push_back(extract_loop(region.error_mm));
        return region;
    }

  private:
    using Edge = std::uint64_t;

    Vector2d to_plane(const Vector3d& point) const {
        const Vector3d from = point - chain_.start_mm;
        return {from.dot(view_.right), from.dot(view_.up)};
    }
    Vector3d to_space(const Vector2d& point) const {
        return chain_.start_mm + point.x() * view_.right + point.y() * view_.up;
    }
    Vector2d node(std::int64_t index) const {
        const std::int64_t column = index % columns_;
        const std::int64_t row = index / columns_;
        return low_ + step_mm_ * Vector2d(static_cast<double>(column), static_cast<double>(row));
    }
    bool is_inside(std::int64_t index) const {
        return distance_mm_[static_cast<std::size_t>(index)] <= iso_level_mm();
    }

    ClosestApproach pass(const Vector3d& point, double hint, const ApproachAccuracy& rule) const {
        return find_closest_approach(chain_.joints.front(), point, hint, rule,
                                     [this](const Vector3d& x) { return tail_.distance_mm(x); });
    }

    void fill() {
        distance_mm_.reserve(static_cast<std::size_t>(columns_ * rows_));
        const ApproachAccuracy rule{kTolerance * step_mm_, kTolerance * step_mm_, 2 * step_mm_};
        double hint = 0;
        for (std::int64_t index = 0; index < columns_ * rows_; ++index) {
            const ClosestApproach nearest = pass(to_space(node(index)), hint, rule);
            hint = nearest.value;
            distance_mm_.push_back(nearest.distance_mm);
        }
    }

    static Edge edge(std::int64_t a, std::int64_t b) {
        return (static_cast<Edge>(std::min(a, b)) << 32U) | static_cast<Edge>(std::max(a, b));
    }

    // Expects counterclockwise corners; the inside lies to the left of the line.
    void add_triangle(const std::array<std::int64_t, 3>& corners) {
        const int count =
            int{is_inside(corners[0])} + int{is_inside(corners[1])} + int{is_inside(corners[2])};
        if (count == 0 || count == 3) return;
        for (std::size_t i = 0; i < 3; ++i) {
            if (is_inside(corners[i]) != (count == 1)) continue;
            const Edge to_next = edge(corners[i], corners[(i + 1) % 3]);
            const Edge to_last = edge(corners[i], corners[(i + 2) % 3]);
            if (count == 1) {
                next_[to_next] = to_last;
            } else {
                next_[to_last] = to_next;
            }
        }
    }

    Vector3d cut(Edge edge) const {
        const auto a = static_cast<std::int64_t>(edge >> 32U);
        const auto b = static_cast<std::int64_t>(edge & 0xffffffffU);
        const double from = distance_mm_[static_cast<std::size_t>(a)];
        const double share = (iso_level_mm() - from) / (distance_mm_[static_cast<std::size_t>(b)] - from);
        return to_space(node(a) + share * (node(b) - node(a)));
    }

    std::vector<Vector3d> extract_loop(double& error_mm) {
        std::vector<Vector3d> loop;
        const Edge first = next_.begin()->first;
        for (auto current = next_.find(first); current != next_.end();
             current = next_.find(extract_edge(current))) {
            const Vector3d outside = cut(current->first);
            const ClosestApproach nearest = pass(outside, chain_.joints.front().low, {step_mm_, 0});
            std::vector<double> values{nearest.value};
            const std::vector<double> last =
                tail_.nearest_values(JointPointPath(chain_.joints.front(), outside).at(nearest.value));
            values.insert(values.end(), last.begin(), last.end());
            const Vector3d reached = nearest_reachable_point(chain_, values, outside);
            error_mm = std::max(error_mm, (reached - outside).norm());
            if (loop.empty() || (reached - loop.back()).norm() > kJoinTolerance_mm) loop.push_back(reached);
        }
        return loop;
    }

    // Removes a part from the line; returns the edge that it leads to.
    Edge extract_edge(std::unordered_map<Edge, Edge>::iterator part) {
        const Edge next_edge = part->second;
        next_.erase(part);
        return next_edge;
    }

    const TcpChain& chain_;
    const PlaneView& view_;
    ClosedFormReach tail_;
    double step_mm_;
    Vector2d low_;
    std::int64_t columns_;
    std::int64_t rows_;
    std::vector<double> distance_mm_;
    std::unordered_map<Edge, Edge> next_;  ///< Parts of the line, from one cut edge to the next.
};

}  // namespace

PlaneView plane_view(const Vector3d& normal) {
    const Vector3d reference_axis = std::abs(normal.z()) < 0.9 ? Vector3d::UnitZ() : Vector3d::UnitY();
    const Vector3d up = (reference_axis - reference_axis.dot(normal) * normal).normalized();
    Vector3d right = up.cross(normal);
    Eigen::Index largest = 0;
    right.cwiseAbs().maxCoeff(&largest);
    if (right[largest] < 0) right = -right;
    return {right, up};
}

Region reached_region(const TcpChain& chain, const Vector3d& normal) {
    const PlaneView view = plane_view(normal);
    return PlaneField(chain, view).extract_border();
}

}  // namespace gsim::envelope
