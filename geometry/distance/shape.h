#pragma once

#include <memory>
#include <variant>

#include "geometry/distance/convex.h"
#include "geometry/distance/triangle_mesh.h"

namespace gsim::cell {

/// The body of an object or of a part of the machine, in a frame of its own. A mesh is a surface: something
/// inside of it touches it only where it touches the surface.
class Shape {
  public:
    /// Sizes are > 0, in mm. The frame is in the middle; the axis of a cylinder is Z.
    static Shape box(const Eigen::Vector3d& size_mm);
    static Shape cylinder(double diameter_mm, double height_mm);
    static Shape sphere(double diameter_mm);
    /// A cylinder with half a sphere at each end, which its height does not count.
    static Shape capsule(double diameter_mm, double height_mm);
    static Shape mesh(std::shared_ptr<const TriangleMesh> mesh);

    /// Null for a mesh.
    const Convex* convex() const { return std::get_if<Convex>(&body_); }
    /// Null for a convex body.
    const TriangleMesh* triangles() const {
        const auto* mesh = std::get_if<std::shared_ptr<const TriangleMesh>>(&body_);
        return mesh != nullptr ? mesh->get() : nullptr;
    }
    /// The middle of the box round the shape, and half the size of the box.
    const Eigen::Vector3d& middle_mm() const { return middle_mm_; }
    const Eigen::Vector3d& half_mm() const { return half_mm_; }
    /// Of a ball about middle_mm() that holds the shape.
    double radius_mm() const { return radius_mm_; }

  private:
    using Body = std::variant<Convex, std::shared_ptr<const TriangleMesh>>;
    Shape(Body body, const Eigen::Vector3d& middle_mm, const Eigen::Vector3d& half_mm, double radius_mm)
        : body_(std::move(body)), middle_mm_(middle_mm), half_mm_(half_mm), radius_mm_(radius_mm) {}

    Body body_;
    Eigen::Vector3d middle_mm_;
    Eigen::Vector3d half_mm_;
    double radius_mm_;
};

/// The distance between a shape that goes from one place to another and one at rest, all in the frame of the
/// latter; lower_mm holds for the hull of both places. What is farther than `enough_mm` is told as that, with
/// points that mean nothing.
Gap gap_between(const Shape& moving, const Eigen::Isometry3d& from, const Eigen::Isometry3d& to,
                const Shape& fixed, double enough_mm);

/// The same of a shape at one place.
Gap gap_between(const Shape& first, const Eigen::Isometry3d& pose, const Shape& second, double enough_mm);

}  // namespace gsim::cell
