#include "analysis/envelope/reach_field.h"

#include <algorithm>
#include <cmath>

namespace gsim::envelope {

using Eigen::AlignedBox3d;

namespace {

constexpr int kCoarseNodes = 40;
constexpr int kRounds = 12;
constexpr double kCubeHalfDiagonal = 0.8660254037844386;

DistanceGrid empty_grid(const AlignedBox3d& set_bounds, double step_mm, double margin_mm) {
    DistanceGrid grid;
    grid.set_bounds = set_bounds;
    grid.band_mm = margin_mm;
    grid.step_mm = step_mm;
    const Vector3d margin = Vector3d::Constant(margin_mm);
    grid.low_mm = set_bounds.min() - margin;
    grid.count = ((set_bounds.sizes() + 2 * margin) / step_mm).array().ceil().cast<int>() + 2;
    grid.distance_mm.resize(static_cast<std::size_t>(grid.count.x()) *
                            static_cast<std::size_t>(grid.count.y()) *
                            static_cast<std::size_t>(grid.count.z()));
    return grid;
}

template <typename Function>
void for_each_node(const DistanceGrid& grid, const Function& function) {
    for (int z = 0; z < grid.count.z(); ++z) {
        for (int y = 0; y < grid.count.y(); ++y) {
            for (int x = 0; x < grid.count.x(); ++x) function(grid.index(x, y, z), grid.node({x, y, z}));
        }
    }
}

}  // namespace

AlignedBox3d swept_box(const TcpJoint& joint, const AlignedBox3d& box) {
    AlignedBox3d all;
    const auto corner = [&](int i) { return box.corner(static_cast<AlignedBox3d::CornerType>(i)); };
    if (joint.is_slide()) {
        for (int i = 0; i < 8; ++i)
            all.extend(joint.transformed(corner(i), joint.low))
                .extend(joint.transformed(corner(i), joint.high));
        return all;
    }
    // Cylinder about the axis that holds the box.
    double radius = 0;
    for (int i = 0; i < 8; ++i) radius = std::max(radius, JointPointPath(joint, corner(i)).speed());
    const Vector3d disc = radius * (Vector3d::Ones() - joint.direction.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
    for (int i = 0; i < 8; ++i) {
        const double along = (corner(i) - joint.point_mm).dot(joint.direction);
        const Vector3d foot = joint.point_mm + along * joint.direction;
        all.extend(foot - disc).extend(foot + disc);
    }
    return all;
}

double DistanceGrid::at(const Vector3d& point) const {
    const Eigen::Array3d cell_coordinates = (point - low_mm).array() / step_mm;
    if ((cell_coordinates < 0).any() || (cell_coordinates >= (count - 1).cast<double>()).any())
        return set_bounds.exteriorDistance(point);
    const Eigen::Array3i cell = cell_coordinates.cast<int>();
    const Eigen::Array3d share = cell_coordinates - cell.cast<double>();
    const float* corner = distance_mm.data() + index(cell.x(), cell.y(), cell.z());
    const std::ptrdiff_t row = count.x();
    const std::ptrdiff_t layer = row * count.y();
    const auto interpolate_x = [&](std::ptrdiff_t offset) {
        const double from = corner[offset];
        return from + share.x() * (corner[offset + 1] - from);
    };
    const auto interpolate_y = [&](std::ptrdiff_t offset) {
        const double from = interpolate_x(offset);
        return from + share.y() * (interpolate_x(offset + row) - from);
    };
    const double from = interpolate_y(0);
    return from + share.z() * (interpolate_y(layer) - from);
}

double DistanceGrid::interpolation_error_mm() const {
    return error_mm + kCubeHalfDiagonal * step_mm;
}

ReachField::ReachField(const TcpChain& chain, int nodes) : chain_(chain), tail_(chain) {
    build(loose_boxes(), kCoarseNodes);
    build(tight_boxes(), nodes);
}

const TcpJoint* ReachField::level_joint(std::size_t level) const {
    const std::size_t joints_before_tail = chain_.joints.size() - tail_.joint_count();
    return joints_before_tail == 0 ? nullptr : &chain_.joints[joints_before_tail - 1 - level];
}

std::vector<AlignedBox3d> ReachField::loose_boxes() const {
    std::vector<AlignedBox3d> boxes;
    boxes.reserve(chain_.joints.size());
    AlignedBox3d box = tail_.bounds();
    for (std::size_t i = chain_.joints.size() - tail_.joint_count(); i > 0; --i) {
        box = swept_box(chain_.joints[i - 1], box);
        boxes.push_back(box);
    }
    if (boxes.empty()) boxes.push_back(box);
    return boxes;
}

// Uses two bounds: a point of the set is within half a step of a node in each direction, and that node within
// half a cube diagonal of it.
std::vector<AlignedBox3d> ReachField::tight_boxes() const {
    std::vector<AlignedBox3d> boxes;
    boxes.reserve(grids_.size());
    for (const DistanceGrid& grid : grids_) {
        AlignedBox3d box;
        for_each_node(grid, [&](std::size_t index, const Vector3d& node) {
            if (grid.distance_mm[index] <= grid.interpolation_error_mm()) box.extend(node);
        });
        const Vector3d half = Vector3d::Constant(grid.step_mm / 2);
        boxes.push_back(AlignedBox3d(box.min() - half, box.max() + half).intersection(grid.set_bounds));
    }
    return boxes;
}

void ReachField::build(const std::vector<AlignedBox3d>& boxes, int nodes) {
    std::vector<double> steps(boxes.size(), 0);
    std::vector<double> margins(boxes.size(), 0);
    // Repeats, because margins depend on steps, and steps on the contents of a grid, margins included.
    for (int round = 0; round < kRounds; ++round) {
        double error_mm = 0;
        for (std::size_t level = 0; level < boxes.size(); ++level) {
            steps[level] = std::max(boxes[level].sizes().maxCoeff() + 2 * margins[level], 1e-3) / nodes;
            error_mm += (kCubeHalfDiagonal + kTolerance) * steps[level];
        }
        // The level at which the last grid is cut must be known in all of them; the last one is cut farther
        // in than at its border.
        for (std::size_t level = 0; level < boxes.size(); ++level)
            margins[level] = error_mm * (level + 1 == boxes.size() ? 2 : 1) + 2 * steps[level];
    }
    grids_.clear();
    grids_.reserve(boxes.size());
    for (std::size_t level = 0; level < boxes.size(); ++level) {
        grids_.push_back(empty_grid(boxes[level], steps[level], margins[level]));
        fill(level);
    }
}

ClosestApproach ReachField::pass(std::size_t level, const Vector3d& point, double hint,
                                 const ApproachAccuracy& rule) const {
    const TcpJoint& joint = *level_joint(level);
    if (level == 0) {
        return find_closest_approach(joint, point, hint, rule,
                                     [this](const Vector3d& x) { return tail_.distance_mm(x); });
    }
    return find_closest_approach(joint, point, hint, rule,
                                 [&](const Vector3d& x) { return grids_[level - 1].at(x); });
}

void ReachField::fill(std::size_t level) {
    DistanceGrid& grid = grids_[level];
    if (level_joint(level) == nullptr) {
        for_each_node(grid, [&](std::size_t index, const Vector3d& node) {
            grid.distance_mm[index] = static_cast<float>(tail_.distance_mm(node));
        });
        return;
    }
    const ApproachAccuracy rule{tolerance_mm(level), tolerance_mm(level), grid.band_mm};
    double hint = 0;
    for_each_node(grid, [&](std::size_t index, const Vector3d& node) {
        const ClosestApproach nearest = pass(level, node, hint, rule);
        hint = nearest.value;
        grid.distance_mm[index] = static_cast<float>(nearest.distance_mm);
    });
    const double inner_error_mm = level == 0 ? 0 : grids_[level - 1].interpolation_error_mm();
    grid.error_mm = inner_error_mm + tolerance_mm(level);
}

std::vector<double> ReachField::nearest_values(const Vector3d& point) const {
    std::vector<double> values;
    values.reserve(chain_.joints.size());
    Vector3d back = point;
    for (std::size_t level = grids_.size(); level > 0 && level_joint(level - 1) != nullptr; --level) {
        const TcpJoint& joint = *level_joint(level - 1);
        const ApproachAccuracy rule{grids_[level - 1].step_mm, 0};
        const ClosestApproach nearest = pass(level - 1, back, joint.low, rule);
        values.push_back(nearest.value);
        back = JointPointPath(joint, back).at(nearest.value);
    }
    const std::vector<double> last = tail_.nearest_values(back);
    values.insert(values.end(), last.begin(), last.end());
    return values;
}

}  // namespace gsim::envelope
