#pragma once

#include <string>
#include <vector>

namespace gsim::engine {

/// What stands in a run's world, for whoever draws it (docs/studio.md has the keys).
struct Scene {
    /// As JSON: the machine's axes and its chain of joints, bodies and the frames they stand in, zones, and,
    /// behind a run, how frames went by themselves.
    std::string json;
    /// Surfaces that bodies name by their index: nine coordinates (mm, in the body's frame) for a triangle.
    std::vector<std::vector<float>> meshes_mm;
};

}  // namespace gsim::engine
