#include "geometry/distance/shape.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gsim::cell {

using Eigen::Vector3d;

Shape Shape::box(const Vector3d& size_mm) {
    Convex body;
    body.core = Convex::Core::box;
    body.half_mm = size_mm / 2;
    return {body, Vector3d::Zero(), body.half_mm, body.half_mm.norm()};
}

Shape Shape::cylinder(double diameter_mm, double height_mm) {
    Convex body;
    body.core = Convex::Core::cylinder;
    body.half_mm = Vector3d(diameter_mm, diameter_mm, height_mm) / 2;
    return {body, Vector3d::Zero(), body.half_mm, std::hypot(diameter_mm, height_mm) / 2};
}

Shape Shape::sphere(double diameter_mm) {
    Convex body;
    body.margin_mm = diameter_mm / 2;
    return {body, Vector3d::Zero(), Vector3d::Constant(body.margin_mm), body.margin_mm};
}

Shape Shape::capsule(double diameter_mm, double height_mm) {
    Convex body;
    body.point_count = 2;
    body.points[0].z() = height_mm / 2;
    body.points[1].z() = -height_mm / 2;
    body.margin_mm = diameter_mm / 2;
    const double end_mm = (height_mm + diameter_mm) / 2;
    return {body, Vector3d::Zero(), Vector3d(body.margin_mm, body.margin_mm, end_mm), end_mm};
}

Shape Shape::mesh(std::shared_ptr<const TriangleMesh> mesh) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& vertex : mesh->vertices_mm()) box.extend(vertex);
    const Vector3d middle = box.center();
    double radius = 0;
    for (const Vector3d& vertex : mesh->vertices_mm()) radius = std::max(radius, (vertex - middle).norm());
    return {std::move(mesh), middle, box.sizes() / 2, radius};
}

}  // namespace gsim::cell
