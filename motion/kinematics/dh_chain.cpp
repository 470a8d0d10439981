#include "motion/kinematics/dh_chain.h"

#include <algorithm>
#include <cmath>

#include "motion/kinematics/screws.h"

namespace gsim::kinematics {

namespace {

using Eigen::Vector3d;

constexpr double kLineTolerance_mm = 1e-9;  // distance below which parallel axes count as one line

Branch make_branch(const rrs::CartPos& base, const std::vector<DhLink>& rows, const rrs::CartPos& tool) {
    Branch branch{.base = base, .end = tool};
    branch.links.reserve(rows.size());
    for (const DhLink& row : rows)
        branch.links.push_back(make_link(static_cast<int>(branch.links.size()), row));
    return branch;
}

bool is_table(const Chain& chain) {
    const auto& links = chain.tool_side().links;
    return chain.work_side().links.empty() && chain.work_side().base.matrix().isIdentity(0) &&
           chain.work_side().end.matrix().isIdentity(0) &&
           std::all_of(links.begin(), links.end(), [](const Link& link) { return link.row.has_value(); });
}

DhTable original_dh_table(const Chain& chain) {
    DhTable table{.base = chain.tool_side().base, .tool = chain.tool_side().end};
    for (const Link& link : chain.tool_side().links) {
        table.rows.push_back(link.row.value_or(DhLink{}));
        table.joints.push_back(link.joint);
    }
    return table;
}

rrs::CartPos make_frame(const Vector3d& origin, const Vector3d& x, const Vector3d& z) {
    rrs::CartPos frame = rrs::CartPos::Identity();
    frame.translation() = origin;
    frame.linear().col(0) = x;
    frame.linear().col(1) = z.cross(x);
    frame.linear().col(2) = z;
    return frame;
}

// Connection from a joint's Z to that of the next one: along the common normal of both axes.
struct Step {
    double d_mm = 0;
    double a_mm = 0;
    Vector3d x = Vector3d::UnitX();
};

Step common_normal_step(const rrs::CartPos& frame, const Screw& next) {
    const Vector3d z = frame.linear().col(2);
    const Vector3d normal = z.cross(next.direction);
    // A slide has only a direction; its axis passes through the current point of the chain.
    const Vector3d offset =
        next.kind == rrs::JointKind::revolute ? Vector3d(next.point - frame.translation()) : Vector3d::Zero();
    if (normal.norm() >= kParallel) {
        return {.d_mm = offset.cross(next.direction).dot(normal) / normal.squaredNorm(),
                .a_mm = offset.dot(normal.normalized()),
                .x = normal.normalized()};
    }
    const Vector3d perpendicular = offset - z * z.dot(offset);
    if (perpendicular.norm() < kLineTolerance_mm) return {.x = frame.linear().col(0)};
    return {.d_mm = 0, .a_mm = perpendicular.norm(), .x = perpendicular.normalized()};
}

}  // namespace

DhChain::DhChain(const rrs::CartPos& base, const std::vector<DhLink>& rows, const rrs::CartPos& tool)
    : Chain(make_branch(base, rows, tool)) {}

DhTable dh_table(const Chain& chain) {
    if (is_table(chain)) return original_dh_table(chain);
    const ScrewChain screws = screw_chain(chain);
    const rrs::CartPos to_work = screws.work_at_zero.inverse();
    if (screws.screws.empty()) return {.base = to_work * screws.tool_at_zero};
    const Screw& first = screws.screws.front();
    rrs::CartPos frame = make_frame(first.point, first.direction.unitOrthogonal(), first.direction);
    DhTable table{.base = to_work * frame};
    for (std::size_t i = 0; i < screws.screws.size(); ++i) {
        const Screw& screw = screws.screws[i];
        DhLink row{.kind = screw.kind};
        if (i + 1 < screws.screws.size()) {
            const Screw& next = screws.screws[i + 1];
            const Step step = common_normal_step(frame, next);
            const Vector3d z = frame.linear().col(2);
            const Vector3d x = frame.linear().col(0);
            row.theta_rad = std::atan2(x.cross(step.x).dot(z), x.dot(step.x));
            row.d_mm = step.d_mm;
            row.a_mm = step.a_mm;
            row.alpha_rad = std::atan2(z.cross(next.direction).dot(step.x), z.dot(next.direction));
            frame =
                make_frame(frame.translation() + step.d_mm * z + step.a_mm * step.x, step.x, next.direction);
        }
        table.rows.push_back(row);
        table.joints.push_back(screw.joint);
    }
    table.tool = frame.inverse() * screws.tool_at_zero;
    return table;
}

}  // namespace gsim::kinematics
