// Masses of bodies of even density.
#include "collision/cell/body_mass.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace gsim::cell::body_mass_test {
namespace {

using dynamics::RigidBody;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

/// Triangles as the text of an OBJ file, each with vertices of its own, as in STL.
class Surface {
  public:
    void triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
        for (const Vector3d& v : {a, b, c})
            text_ += fmt::format("v {:.17g} {:.17g} {:.17g}\n", v.x(), v.y(), v.z());
        text_ += fmt::format("f {} {} {}\n", count_ + 1, count_ + 2, count_ + 3);
        count_ += 3;
    }
    /// Corners counter-clockwise, seen from outside.
    void quad(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
        triangle(a, b, c);
        triangle(a, c, d);
    }
    /// A box with one corner at `at` and edges along the columns of `edges`, which are right-handed.
    void box(const Vector3d& at, const Matrix3d& edges, bool has_lid = true) {
        const Vector3d x = edges.col(0);
        const Vector3d y = edges.col(1);
        const Vector3d z = edges.col(2);
        quad(at, at + y, at + x + y, at + x);
        quad(at, at + x, at + x + z, at + z);
        quad(at + x, at + x + y, at + x + y + z, at + x + z);
        quad(at + x + y, at + y, at + y + z, at + x + y + z);
        quad(at + y, at, at + z, at + y + z);
        if (has_lid) quad(at + z, at + x + z, at + x + y + z, at + y + z);
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
    int count_ = 0;
};

Result<RigidBody> of_mesh(const Surface& surface, double density) {
    const os::CallbackFiles given([&](const std::string&) { return surface.text(); });
    return compute_rigid_body(machine::MeshShape{.file = "part.obj"}, density, {.files = given});
}

TEST(BodyMass, MatchesClosedForms) {
    const RigidBody box = *compute_rigid_body(machine::BoxShape{100, 200, 300}, 1000);
    EXPECT_NEAR(box.mass_kg, 6, 1e-12);
    EXPECT_TRUE(box.inertia_kg_m2.diagonal().isApprox(Vector3d(0.13, 0.10, 0.05) / 2, 1e-12));
    const RigidBody ball = *compute_rigid_body(machine::SphereShape{200}, 1000);
    EXPECT_NEAR(ball.mass_kg, 4 / 3.0 * kPi, 1e-12);
    EXPECT_NEAR(ball.inertia_kg_m2(1, 1), 0.4 * ball.mass_kg * 0.01, 1e-12);
    const RigidBody rod = *compute_rigid_body(machine::CylinderShape{200, 600}, 1000);
    EXPECT_NEAR(rod.mass_kg, 6 * kPi, 1e-12);
    EXPECT_NEAR(rod.inertia_kg_m2(2, 2), rod.mass_kg * 0.005, 1e-12);
    EXPECT_NEAR(rod.inertia_kg_m2(0, 0), rod.mass_kg * (0.03 + 0.36) / 12, 1e-12);
}

// By discs along its axis.
TEST(BodyMass, CapsuleIsSumOfDiscs) {
    const RigidBody capsule = *compute_rigid_body(machine::CapsuleShape{200, 300}, 1000);
    constexpr int kDiscs = 200'000;
    constexpr double kHalf = 0.25;
    double mass = 0;
    double across = 0;
    double along = 0;
    for (int i = 0; i < kDiscs; ++i) {
        const double z = kHalf * (2 * (i + 0.5) / kDiscs - 1);
        const double out_of_range = std::max(0.0, std::abs(z) - 0.15);
        const double square = 0.01 - out_of_range * out_of_range;
        const double disc = 1000 * kPi * square * 2 * kHalf / kDiscs;
        mass += disc;
        along += disc * square / 2;
        across += disc * (square / 4 + z * z);
    }
    EXPECT_NEAR(capsule.mass_kg, mass, 1e-8 * mass);
    EXPECT_NEAR(capsule.inertia_kg_m2(0, 0), across, 1e-8 * across);
    EXPECT_NEAR(capsule.inertia_kg_m2(2, 2), along, 1e-8 * along);
}

TEST(BodyMass, ClosedMeshEqualsBox) {
    const Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    const Vector3d at(4000, -300, 80);  // far from its origin
    Surface surface;
    surface.box(at, turn * Vector3d(100, 200, 300).asDiagonal());
    const auto mesh = of_mesh(surface, 1000);
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_NEAR(mesh->mass_kg, 6, 1e-9);
    EXPECT_TRUE(mesh->centre_m.isApprox(1e-3 * (at + turn * Vector3d(50, 100, 150)), 1e-12));
    const Matrix3d expected_value =
        turn * Matrix3d((Vector3d(0.13, 0.10, 0.05) / 2).asDiagonal()) * turn.transpose();
    EXPECT_LT((mesh->inertia_kg_m2 - expected_value).norm(), 1e-10) << mesh->inertia_kg_m2;
}

TEST(BodyMass, AcceptsMeshTurnedInsideOut) {
    Surface surface;
    surface.box(Vector3d::Zero(), Matrix3d(Vector3d(100, 200, -300).asDiagonal()));
    const auto mesh = of_mesh(surface, 1000);
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_NEAR(mesh->mass_kg, 6, 1e-12);
    EXPECT_TRUE(mesh->centre_m.isApprox(Vector3d(0.05, 0.1, -0.15)));
}

TEST(BodyMass, RejectsOpenMesh) {
    Surface surface;
    surface.box(Vector3d::Zero(), Matrix3d(Vector3d(100, 200, 300).asDiagonal()), false);
    EXPECT_EQ(of_mesh(surface, 1000).error().message,
              "part.obj: the surface is not closed, so it encloses no mass: an edge at 0 0 300 has a "
              "triangle on one side only");
}

}  // namespace
}  // namespace gsim::cell::body_mass_test
