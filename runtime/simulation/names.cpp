#include <Eigen/Geometry>

#include "runtime/simulation/move.h"
#include "runtime/simulation/report.h"

namespace gsim::simulation {

std::string_view name(MoveKind kind) {
    switch (kind) {
        case MoveKind::rapid: return "rapid";
        case MoveKind::linear: return "linear";
        case MoveKind::arc_cw: return "arc_cw";
        case MoveKind::arc_ccw: return "arc_ccw";
        case MoveKind::probe: return "probe";
        case MoveKind::thread: return "thread";
        case MoveKind::spline: return "spline";
        case MoveKind::dwell: break;
    }
    return "dwell";
}

std::string_view name(Plane plane) {
    switch (plane) {
        case Plane::xy: return "xy";
        case Plane::zx: return "zx";
        case Plane::yz: break;
    }
    return "yz";
}

std::string_view name(RunStatus status) {
    switch (status) {
        case RunStatus::completed: return "completed";
        case RunStatus::stopped: return "stopped";
        case RunStatus::alarm: break;
    }
    return "alarm";
}

void set_plane_and_sense(MoveInfo& info, const Eigen::Vector3d& start, const Eigen::Vector3d& via,
                         const Eigen::Vector3d& end) {
    const Eigen::Vector3d normal = (via - start).cross(end - via);
    Eigen::Index largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    info.plane = largest == 2 ? Plane::xy : largest == 1 ? Plane::zx : Plane::yz;
    info.kind = normal[largest] < 0 ? MoveKind::arc_cw : MoveKind::arc_ccw;
}

}  // namespace gsim::simulation
