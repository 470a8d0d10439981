#pragma once

#include <memory>
#include <variant>

#include "geometry/distance/convex.h"
#include "geometry/distance/triangle_mesh.h"

namespace gsim::cell {

/// The body of an object or of a machine part, in its own frame. A mesh is a surface: an object inside of it
/// touches it only if it touches the surface.
class Shape {
  public:
    /// Creates a shape. Sizes are > 0, in mm. The frame is in the middle; the axis of a cylinder is Z.
    static Shape box(const Eigen::Vector3d& size_mm);
    static Shape cylinder(double diameter_mm, double height_mm);
    static Shape sphere(double diameter_mm);
    /// Creates a cylinder with half a sphere at each end, which its height does not include.
    static Shape capsule(double diameter_mm, double height_mm);
    static Shape mesh(std::shared_ptr<const TriangleMesh> mesh);

    /// Returns null for a mesh.
    const Convex* convex() const { return std::get_if<Convex>(&body_); }
    /// Returns null for a convex body.
    const TriangleMesh* triangles() const {
        const auto* mesh = std::get_if<std::shared_ptr<const TriangleMesh>>(&body_);
        return mesh != nullptr ? mesh->get() : nullptr;
    }
    /// Returns the middle of the box round the shape; half_mm() returns half the size of the box.
    const Eigen::Vector3d& middle_mm() const { return middle_mm_; }
    const Eigen::Vector3d& half_mm() const { return half_mm_; }
    /// Returns the radius of a ball about middle_mm() that contains the shape.
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

/// Returns the distance between a shape that moves from one pose to another and one at standstill, all in the
/// frame of the latter; lower_mm holds for the hull of both poses. A distance above `cutoff_mm` is returned
/// as `cutoff_mm`, with points that have no meaning.
Gap shape_distance(const Shape& moving, const Eigen::Isometry3d& from, const Eigen::Isometry3d& to,
                   const Shape& fixed, double cutoff_mm);

/// Returns the same for a shape at one pose.
Gap shape_distance(const Shape& first, const Eigen::Isometry3d& pose, const Shape& second, double cutoff_mm);

}  // namespace gsim::cell
