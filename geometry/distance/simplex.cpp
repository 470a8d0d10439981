#include "geometry/distance/simplex.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gsim::cell {

using Eigen::Vector3d;

bool Simplex::contains(const Vector3d& point) const {
    return std::any_of(corners_.begin(), corners_.begin() + count_,
                       [&](const DifferencePoint& corner) { return corner.at == point; });
}

void Simplex::keep(const Corners& kept, int count, const Vector3d& weights) {
    const std::array<DifferencePoint, 4> before = corners_;
    for (int i = 0; i < count; ++i) {
        const auto index = static_cast<std::size_t>(i);
        corners_[index] = before[static_cast<std::size_t>(kept[index])];
        weights_[index] = weights[i];
    }
    count_ = count;
}

void Simplex::reduce_segment(int a, int b) {
    const Vector3d displacement = at(b) - at(a);
    const double square = displacement.squaredNorm();
    const double share = square > 0 ? -at(a).dot(displacement) / square : 0;
    if (!(share > 0)) return keep({a, 0, 0}, 1, {1, 0, 0});
    if (share >= 1) return keep({b, 0, 0}, 1, {1, 0, 0});
    keep({a, b, 0}, 2, {1 - share, share, 0});
}

// Reduces by the regions of corners, edges and face; a triangle without area by its nearest edge.
void Simplex::reduce_triangle(int a, int b, int c) {
    const Vector3d ab = at(b) - at(a);
    const Vector3d ac = at(c) - at(a);
    const double a_ab = -ab.dot(at(a));
    const double a_ac = -ac.dot(at(a));
    const double b_ab = -ab.dot(at(b));
    const double b_ac = -ac.dot(at(b));
    const double c_ab = -ab.dot(at(c));
    const double c_ac = -ac.dot(at(c));
    if (a_ab <= 0 && a_ac <= 0) return keep({a, 0, 0}, 1, {1, 0, 0});
    if (b_ab >= 0 && b_ac <= b_ab) return keep({b, 0, 0}, 1, {1, 0, 0});
    if (c_ac >= 0 && c_ab <= c_ac) return keep({c, 0, 0}, 1, {1, 0, 0});
    const double weight_c = a_ab * b_ac - b_ab * a_ac;
    const double weight_b = c_ab * a_ac - a_ab * c_ac;
    const double weight_a = b_ab * c_ac - c_ab * b_ac;
    if (weight_c <= 0 && a_ab >= 0 && b_ab <= 0) return reduce_segment(a, b);
    if (weight_b <= 0 && a_ac >= 0 && c_ac <= 0) return reduce_segment(a, c);
    if (weight_a <= 0) return reduce_segment(b, c);
    const double sum = weight_a + weight_b + weight_c;
    keep({a, b, c}, 3, Vector3d(weight_a, weight_b, weight_c) / sum);
}

// The origin is inside, or nearest to one of the faces that it is in front of. Rounding hides the front of a
// flat tetrahedron, so none of its faces is skipped. An origin inside of it is as good as on a face.
void Simplex::reduce_tetrahedron() {
    constexpr std::array<std::array<int, 4>, 4> kFaces{
        {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}}};
    constexpr double kFlatTolerance = 1e-9;
    const double size = std::max({(at(1) - at(0)).norm(), (at(2) - at(0)).norm(), (at(3) - at(0)).norm()});
    Simplex best;
    double min_squared_distance = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c, opposite] : kFaces) {
        const Vector3d normal = (at(b) - at(a)).cross(at(c) - at(a));
        const double area = normal.norm();
        const double height = normal.dot(at(opposite) - at(a));
        const bool flat =
            area <= kFlatTolerance * size * size || std::abs(height) <= kFlatTolerance * area * size;
        if (!flat && normal.dot(at(a)) * height < 0) continue;  // it is behind this face
        Simplex face = *this;
        face.reduce_triangle(a, b, c);
        const double square = face.nearest().at.squaredNorm();
        if (square >= min_squared_distance) continue;
        best = face;
        min_squared_distance = square;
    }
    if (best.count_ > 0) *this = best;
}

Vector3d Simplex::reduce() {
    switch (count_) {
        case 1: weights_[0] = 1; break;
        case 2: reduce_segment(0, 1); break;
        case 3: reduce_triangle(0, 1, 2); break;
        default: reduce_tetrahedron(); break;
    }
    return count_ == 4 ? Vector3d::Zero() : nearest().at;
}

DifferencePoint Simplex::nearest() const {
    DifferencePoint sum;
    for (int i = 0; i < count_; ++i) {
        const auto index = static_cast<std::size_t>(i);
        sum.at += weights_[index] * corners_[index].at;
        sum.on_first += weights_[index] * corners_[index].on_first;
        sum.on_second += weights_[index] * corners_[index].on_second;
    }
    return sum;
}

}  // namespace gsim::cell
