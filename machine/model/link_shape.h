#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include "geometry/mesh/mesh.h"
#include "machine/model/frame.h"

namespace gsim::machine {

/// A box with its frame in the middle.
struct BoxShape {
    double x_mm, y_mm, z_mm;
    bool operator==(const BoxShape&) const = default;
};

/// A cylinder along Z with its frame in the middle.
struct CylinderShape {
    double diameter_mm, height_mm;
    bool operator==(const CylinderShape&) const = default;
};

/// The same with half a sphere at each end, which the height does not include.
struct CapsuleShape {
    double diameter_mm, height_mm;
    bool operator==(const CapsuleShape&) const = default;
};

struct SphereShape {
    double diameter_mm;
    bool operator==(const SphereShape&) const = default;
};

/// A surface of triangles in a separate file; coordinates times `scale` are mm.
struct MeshShape {
    std::filesystem::path file;
    double scale = 1;
    double tolerance_mm = solid::kMeshTolerance_mm;  ///< For files that have curved surfaces.
    bool operator==(const MeshShape&) const = default;
};

/// Form of a body, as files describe it.
using ShapeForm = std::variant<BoxShape, CylinderShape, CapsuleShape, SphereShape, MeshShape>;

/// A body of the machine itself.
struct LinkShape {
    std::string name;
    std::string on;  ///< "base", the letter of an axis, "tool", "work", or "jet": on the tool while it cuts.
    ShapeForm form;
    Frame frame;               ///< From what it is on to the shape.
    double density_kg_m3 = 0;  ///< Density for its mass; 0: it has none, or it is given elsewhere.

    bool operator==(const LinkShape&) const = default;
};

}  // namespace gsim::machine
