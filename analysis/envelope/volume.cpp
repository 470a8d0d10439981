#include "analysis/envelope/volume.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/envelope/nearest_reach.h"

namespace gsim::envelope {

namespace {

constexpr double kParallelTolerance = 1e-12;

// Merges parallel slides into one. Returns an empty list if anything but three slides is left.
std::vector<TcpJoint> merge_parallel_slides(const TcpChain& chain) {
    std::vector<TcpJoint> slides;
    for (const TcpJoint& joint : chain.joints) {
        if (!joint.is_slide()) return {};
        const auto same = std::find_if(slides.begin(), slides.end(), [&](const TcpJoint& other) {
            return joint.direction.cross(other.direction).norm() < kParallelTolerance;
        });
        if (same == slides.end()) {
            slides.push_back(joint);
            continue;
        }
        const bool reversed = joint.direction.dot(same->direction) < 0;
        same->low += reversed ? -joint.high : joint.low;
        same->high += reversed ? -joint.low : joint.high;
    }
    if (slides.size() != 3) return {};
    const double sense = slides[0].direction.dot(slides[1].direction.cross(slides[2].direction));
    if (std::abs(sense) < kParallelTolerance) return {};
    if (sense < 0) std::swap(slides[0], slides[1]);
    return slides;
}

Surface block(const TcpChain& chain, const std::vector<TcpJoint>& slides) {
    Surface surface;
    surface.points_mm.reserve(8);
    for (int i = 0; i < 8; ++i) {
        Vector3d corner = chain.start_mm;
        for (int k = 0; k < 3; ++k) {
            const TcpJoint& slide = slides[static_cast<std::size_t>(k)];
            corner = slide.transformed(corner, (i >> k & 1) != 0 ? slide.high : slide.low);
        }
        surface.points_mm.push_back(corner);
    }
    surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                         {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return surface;
}

}  // namespace

Volume reached_volume(const TcpChain& chain, int nodes) {
    if (const auto slides = merge_parallel_slides(chain); !slides.empty())
        return {block(chain, slides), 0, 0};
    const ReachField field(chain, nodes);
    Volume volume{extract_isosurface(field.grid(), field.iso_level_mm()), field.grid().step_mm,
                  2 * field.iso_level_mm()};
    // This surface encloses every reached position; its corners move to the nearest ones that are reached.
    for (Vector3d& point : volume.surface.points_mm) {
        const Vector3d reached = nearest_reachable_point(chain, field.nearest_values(point), point);
        volume.error_mm = std::max(volume.error_mm, (reached - point).norm());
        point = reached;
    }
    return volume;
}

Result<TcpChain> envelope_chain(const machine::Machine& machine) {
    const machine::JointBox box = machine::joint_box(machine);
    TcpChain chain = tcp_chain(machine, box);
    if (chain.joints.empty()) return Unexpected("the machine has no envelope: no axis moves the TCP");
    for (const TcpJoint& joint : chain.joints) {
        if (std::find(box.cut.begin(), box.cut.end(), joint.joint) == box.cut.end()) continue;
        return Unexpected(fmt::format("the machine has no envelope: axis {} has an unlimited range",
                                      machine.axes[static_cast<std::size_t>(joint.joint)].letter));
    }
    return chain;
}

}  // namespace gsim::envelope
