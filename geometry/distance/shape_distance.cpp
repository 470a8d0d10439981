// Distances between shapes, searched through the trees of their meshes, nearest first.

#include <algorithm>
#include <vector>

#include "geometry/distance/shape.h"

namespace gsim::cell {

using Eigen::Isometry3d;

namespace {

constexpr double kBoxTolerance = 0.3;  // to pass over a box of a tree a rough distance will do

/// A part of a shape: a box of a mesh's tree, one of its triangles, or the complete convex body.
class ShapePart {
  public:
    explicit ShapePart(const Shape& shape)
        : body_(shape.convex()), mesh_(shape.triangles()), node_(mesh_ ? mesh_->nodes().data() : nullptr) {}

    bool is_splittable() const { return node_ != nullptr && !node_->is_leaf(); }
    ShapePart child(int child_index) const {
        ShapePart part = *this;
        part.node_ = mesh_->nodes().data() + node_->first_child + child_index;
        return part;
    }
    const Convex& body() const {
        if (node_ == nullptr) return *body_;
        return node_->is_leaf() ? node_->triangle : node_->box;
    }
    Isometry3d placed(const Isometry3d& pose) const { return is_splittable() ? pose * node_->pose : pose; }
    double size_mm() const { return node_ != nullptr ? node_->box.half_mm.maxCoeff() : 0; }

  private:
    const Convex* body_;
    const TriangleMesh* mesh_;
    const TriangleMesh::Node* node_;
};

class Search {
  public:
    Search(const Isometry3d& from, const Isometry3d& to, double cutoff_mm)
        : from_(from), to_(to), moves_(&from != &to), best_{cutoff_mm, cutoff_mm, {}, {}} {}

    Gap run(const ShapePart& moving, const ShapePart& fixed) {
        visit(moving, fixed);
        while (!pending_pairs_.empty()) {
            const PendingPair next = pending_pairs_.back();
            pending_pairs_.pop_back();
            if (next.lower_mm < best_.upper_mm) split(next.moving, next.fixed);
        }
        return best_;
    }

  private:
    struct PendingPair {
        ShapePart moving;
        ShapePart fixed;
        double lower_mm;
    };

    Gap measure(const ShapePart& moving, const ShapePart& fixed) const {
        const bool is_rough = moving.is_splittable() || fixed.is_splittable();
        const ShapeDistanceRequest request{best_.upper_mm, is_rough ? kBoxTolerance : 0};
        const Isometry3d at = fixed.placed(Isometry3d::Identity());
        const Isometry3d from = moving.placed(from_);
        if (!moves_) return shape_distance({moving.body(), from, from}, fixed.body(), at, request);
        const Isometry3d to = moving.placed(to_);
        return shape_distance({moving.body(), from, to}, fixed.body(), at, request);
    }

    void visit(const ShapePart& moving, const ShapePart& fixed) {
        const Gap gap = measure(moving, fixed);
        if (gap.lower_mm >= best_.upper_mm) return;
        if (moving.is_splittable() || fixed.is_splittable()) {
            pending_pairs_.push_back({moving, fixed, gap.lower_mm});
            return;
        }
        best_.lower_mm = std::min(best_.lower_mm, gap.lower_mm);
        if (gap.upper_mm >= best_.upper_mm) return;
        best_.upper_mm = gap.upper_mm;
        best_.on_first = gap.on_first;
        best_.on_second = gap.on_second;
    }

    // Splits the larger of both parts; the nearer one of its halves comes on top.
    void split(const ShapePart& moving, const ShapePart& fixed) {
        const bool split_moving =
            moving.is_splittable() && (!fixed.is_splittable() || moving.size_mm() > fixed.size_mm());
        const std::size_t before = pending_pairs_.size();
        for (const int child_index : {0, 1}) {
            if (split_moving) {
                visit(moving.child(child_index), fixed);
            } else {
                visit(moving, fixed.child(child_index));
            }
        }
        if (pending_pairs_.size() == before + 2 &&
            pending_pairs_[before].lower_mm < pending_pairs_[before + 1].lower_mm)
            std::swap(pending_pairs_[before], pending_pairs_[before + 1]);
    }

    const Isometry3d& from_;
    const Isometry3d& to_;
    bool moves_;
    Gap best_;
    std::vector<PendingPair> pending_pairs_;
};

}  // namespace

Gap shape_distance(const Shape& moving, const Isometry3d& from, const Isometry3d& to, const Shape& fixed,
                   double cutoff_mm) {
    return Search(from, to, cutoff_mm).run(ShapePart(moving), ShapePart(fixed));
}

Gap shape_distance(const Shape& first, const Isometry3d& pose, const Shape& second, double cutoff_mm) {
    return shape_distance(first, pose, pose, second, cutoff_mm);
}

}  // namespace gsim::cell
