#pragma once

#include <string>
#include <vector>

namespace gsim::engine {

/// The objects in a run's world, for programs that draw them (docs/studio.md has the keys).
struct Scene {
    /// As JSON: the machine's axes and its chain of joints, bodies and their frames, zones, and, after a run,
    /// the independent motion of frames.
    std::string json;
    /// Surfaces that bodies reference by index: nine coordinates (mm, in the body's frame) for a triangle.
    std::vector<std::vector<float>> meshes_mm;
};

}  // namespace gsim::engine
