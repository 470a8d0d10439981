#include "collision/cell/body_mass.h"

#include <map>
#include <numbers>
#include <optional>
#include <variant>

#include <fmt/format.h>

namespace gsim::cell {

using dynamics::RigidBody;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

using RigidBodyResult = Result<RigidBody>;

constexpr double kMetresPerMm = 1e-3;
constexpr double kPi = std::numbers::pi;

RigidBody centered(double mass_kg, double xx, double yy, double zz) {
    return {.mass_kg = mass_kg, .inertia_kg_m2 = Vector3d(xx, yy, zz).asDiagonal()};
}

RigidBody round(double mass_kg, double width, double along) {
    return centered(mass_kg, width, width, along);
}

RigidBodyResult make(const machine::BoxShape& box, double density, const MeshFiles& /*files*/) {
    const double x = box.x_mm * kMetresPerMm;
    const double y = box.y_mm * kMetresPerMm;
    const double z = box.z_mm * kMetresPerMm;
    const double mass_kg = density * x * y * z;
    const double share = mass_kg / 12;
    return centered(mass_kg, share * (y * y + z * z), share * (z * z + x * x), share * (x * x + y * y));
}

RigidBodyResult make(const machine::CylinderShape& cylinder, double density, const MeshFiles& /*files*/) {
    const double r = cylinder.diameter_mm * kMetresPerMm / 2;
    const double h = cylinder.height_mm * kMetresPerMm;
    const double mass_kg = density * kPi * r * r * h;
    return round(mass_kg, mass_kg * (3 * r * r + h * h) / 12, mass_kg * r * r / 2);
}

RigidBodyResult make(const machine::SphereShape& sphere, double density, const MeshFiles& /*files*/) {
    const double r = sphere.diameter_mm * kMetresPerMm / 2;
    const double mass_kg = density * 4 / 3 * kPi * r * r * r;
    return round(mass_kg, 0.4 * mass_kg * r * r, 0.4 * mass_kg * r * r);
}

// The centres of half spheres are 3/8 of the radius from the flat side. They turn about the middle of that
// side like a full sphere of their mass.
RigidBodyResult make(const machine::CapsuleShape& capsule, double density, const MeshFiles& files) {
    const double r = capsule.diameter_mm * kMetresPerMm / 2;
    const double h = capsule.height_mm * kMetresPerMm;
    const RigidBody rod =
        *make(machine::CylinderShape{capsule.diameter_mm, capsule.height_mm}, density, files);
    const RigidBody ball = *make(machine::SphereShape{capsule.diameter_mm}, density, files);
    const double shift = h * h / 4 + 2 * (3.0 / 8 * r) * (h / 2);
    return round(rod.mass_kg + ball.mass_kg,
                 rod.inertia_kg_m2(0, 0) + ball.inertia_kg_m2(0, 0) + ball.mass_kg * shift,
                 rod.inertia_kg_m2(2, 2) + ball.inertia_kg_m2(2, 2));
}

/// The corners of a triangle in the order of its file.
using Corners = std::array<Vector3d, 3>;

template <typename Visitor>
void for_each_triangle(const TriangleMesh& mesh, const Visitor& on_triangle) {
    for (const TriangleMesh::Node& node : mesh.nodes()) {
        if (node.is_leaf())
            on_triangle(Corners{node.triangle.points[0], node.triangle.points[1], node.triangle.points[2]});
    }
}

/// Returns a position where the surface is open: the start of an edge that no triangle has in the other
/// direction.
std::optional<Vector3d> find_open_edge(const TriangleMesh& mesh) {
    using Point = std::array<double, 3>;
    const auto point = [](const Vector3d& v) { return Point{v.x(), v.y(), v.z()}; };
    std::map<std::pair<Point, Point>, int> edges;  // how many run up, less those that run down
    for_each_triangle(mesh, [&](const Corners& corners) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Point from = point(corners[i]);
            const Point to = point(corners[(i + 1) % 3]);
            if (from < to) ++edges[{from, to}];
            if (to < from) --edges[{to, from}];
        }
    });
    for (const auto& [edge, count] : edges) {
        if (count != 0) return Vector3d(edge.first[0], edge.first[1], edge.first[2]);
    }
    return std::nullopt;
}

/// Sums over the tetrahedra from a middle to each triangle: det / 6 is the volume of one, det / 24 times the
/// sum of its corners its first moment, and the second one det / 120 (s s^T + a a^T + b b^T + c c^T).
RigidBody integrate_rigid_body(const TriangleMesh& mesh, double density) {
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& vertex : mesh.vertices_mm()) middle += vertex;
    middle /= static_cast<double>(mesh.vertices_mm().size());
    double volume = 0;
    Vector3d first = Vector3d::Zero();
    Matrix3d second = Matrix3d::Zero();
    for_each_triangle(mesh, [&](const Corners& corners) {
        const Vector3d a = kMetresPerMm * (corners[0] - middle);
        const Vector3d b = kMetresPerMm * (corners[1] - middle);
        const Vector3d c = kMetresPerMm * (corners[2] - middle);
        const double det = a.dot(b.cross(c));
        const Vector3d sum = a + b + c;
        volume += det / 6;
        first += det / 24 * sum;
        second +=
            det / 120 * (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    });
    if (volume < 0) {  // the complete mesh is inside out
        volume = -volume;
        first = -first;
        second = -second;
    }
    if (!(volume > 0)) return {};
    const Vector3d centre = first / volume;
    const Matrix3d second_moments = density * (second - volume * centre * centre.transpose());
    return {.mass_kg = density * volume,
            .centre_m = kMetresPerMm * middle + centre,
            .inertia_kg_m2 = second_moments.trace() * Matrix3d::Identity() - second_moments};
}

RigidBodyResult make(const machine::MeshShape& shape, double density, const MeshFiles& files) {
    const auto mesh = load_mesh(shape.file, shape.scale, shape.tolerance_mm, files);
    if (!mesh) return tl::unexpected(mesh.error());
    if (const auto open = find_open_edge(**mesh)) {
        return Unexpected(
            fmt::format("{}: the surface is not closed, so it encloses no mass: an edge at {:.6g} {:.6g} "
                        "{:.6g} has a triangle on one side only",
                        shape.file.string(), open->x(), open->y(), open->z()));
    }
    return integrate_rigid_body(**mesh, density);
}

}  // namespace

Result<RigidBody> compute_rigid_body(const machine::ShapeForm& form, double density_kg_m3,
                                     const MeshFiles& files) {
    return std::visit([&](const auto& of) { return make(of, density_kg_m3, files); }, form);
}

}  // namespace gsim::cell
