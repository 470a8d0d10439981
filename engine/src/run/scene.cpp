#include "engine/src/run/scene.h"

#include <array>
#include <cmath>
#include <optional>

#include "base/text/json.h"
#include "motion/kinematics/chain.h"
#include "motion/path/axis_space.h"
#include "runtime/monitors/workpiece_tcp.h"
#include "runtime/simulator/make_planner_setup.h"

namespace gsim::engine {

namespace {

using Eigen::Vector3d;
using Json = nlohmann::ordered_json;

/// The columns follow each other, because most drawing libraries expect that order.
Json matrix(const rrs::CartPos& pose) {
    Json json = Json::array();
    for (Eigen::Index i = 0; i < 16; ++i) json.push_back(pose.matrix().data()[i]);
    return json;
}

Json point(const Vector3d& point_mm) {
    return Json::array({point_mm.x(), point_mm.y(), point_mm.z()});
}

Json limit(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json axes(const machine::Machine& machine) {
    Json list = Json::array();
    for (const machine::Axis& axis : machine.axes) {
        list.push_back({{"letter", std::string(1, axis.letter)},
                        {"rotary", axis.kind == machine::AxisKind::rotary},
                        {"min", limit(axis.min)},
                        {"max", limit(axis.max)},
                        {"max_speed", limit(axis.max_speed)},
                        {"max_acceleration", limit(axis.max_acceleration)},
                        {"max_jerk", limit(axis.max_jerk)},
                        {"motor_peak", limit(axis.drive.peak)},
                        {"motor_fades", !axis.drive.curve_speeds.empty()},
                        {"home", axis.home},
                        {"zero", axis.zero},
                        {"carries", machine::name(axis.carries)}});
    }
    return list;
}

Json branch(const kinematics::Branch& branch) {
    Json links = Json::array();
    for (const kinematics::Link& link : branch.links) {
        links.push_back({{"joint", link.joint},
                         {"rotary", link.kind == rrs::JointKind::revolute},
                         {"before", matrix(link.before)},
                         {"after", matrix(link.after)}});
    }
    return {{"base", matrix(branch.base)}, {"links", std::move(links)}, {"end", matrix(branch.end)}};
}

/// Returns the map from X, Y and Z of the machine (mm) to the work frame, all other axes at 0; nothing
/// without three linear axes.
Json axis_space_json(const machine::Machine& machine) {
    const motion::PlannerSetup setup = simulation::make_planner_setup(machine);
    rrs::JointPos joints(setup.joint_count());
    for (int i = 0; i < setup.joint_count(); ++i)
        joints[i] = machine::joint_value(machine.axes[static_cast<std::size_t>(i)], 0);
    const auto tcp = [&] { return Vector3d(setup.kinematics->forward(joints).translation()); };
    rrs::CartPos space = rrs::CartPos::Identity();
    space.translation() = tcp();
    for (std::size_t i = 0; i < 3; ++i) {
        const int joint = setup.position_joints[i];
        if (joint < 0) return nullptr;
        joints[joint] += 1;
        space.linear().col(static_cast<Eigen::Index>(i)) = tcp() - space.translation();
        joints[joint] -= 1;
    }
    return matrix(space);
}

std::vector<float> to_triangles(const cell::TriangleMesh& mesh) {
    std::vector<float> coordinates;
    coordinates.reserve(mesh.triangle_count() * 9);
    for (const cell::TriangleMesh::Node& node : mesh.nodes()) {
        if (!node.is_leaf()) continue;
        for (const Vector3d& corner : node.triangle.points) {
            for (const double value : corner) coordinates.push_back(static_cast<float>(value));
        }
    }
    return coordinates;
}

Json convex(const cell::Convex& body) {
    using Core = cell::Convex::Core;
    Json json = {{"margin_mm", body.margin_mm}};
    switch (body.core) {
        case Core::box:
            json["kind"] = "box";
            json["half_mm"] = point(body.half_mm);
            break;
        case Core::cylinder:
            json["kind"] = "cylinder";
            json["radius_mm"] = body.half_mm.x();
            json["half_height_mm"] = body.half_mm.z();
            break;
        case Core::points:
            json["kind"] = "points";
            json["points_mm"] = Json::array();
            for (int i = 0; i < body.point_count; ++i)
                json["points_mm"].push_back(point(body.points[static_cast<std::size_t>(i)]));
            break;
    }
    return json;
}

const char* role_name(cell::Role role) {
    switch (role) {
        case cell::Role::machine: return "machine";
        case cell::Role::jet: return "jet";
        case cell::Role::workpiece: return "workpiece";
        case cell::Role::fixture: return "fixture";
    }
    return "";
}

Json bodies(const cell::Cell& cell, Scene& scene) {
    Json list = Json::array();
    for (const cell::Item& item : cell.items) {
        Json shape;
        if (const cell::TriangleMesh* mesh = item.shape.triangles()) {
            shape = {{"kind", "mesh"}, {"mesh", scene.meshes_mm.size()}};
            scene.meshes_mm.push_back(to_triangles(*mesh));
        } else {
            shape = convex(*item.shape.convex());
        }
        list.push_back(
            {{"name", item.name}, {"role", role_name(item.role)}, {"frame", item.frame}, {"shape", shape}});
    }
    return list;
}

/// Frames of the machine move with a link: number 0 is the world, number i is moved by axis i - 1. The others
/// are attached to another frame.
Json frames(const cell::FrameTree& tree) {
    Json list = Json::array();
    for (std::size_t i = 0; i < tree.names().size(); ++i) {
        Json frame = {{"name", tree.name(i)}};
        if (tree.is_machine_frame(i)) {
            frame["link"] = tree.link(i);
            frame["in_link"] = matrix(tree.pose_in_link(i));
        } else {
            frame["parent"] = tree.parent(i);
            frame["in_parent"] = matrix(tree.pose_in_parent(i));
        }
        list.push_back(std::move(frame));
    }
    return list;
}

Json drifts_json(std::span<const simulation::FrameMotion> history) {
    Json list = Json::array();
    for (const simulation::FrameMotion& entry : history) {
        list.push_back({{"frame", entry.frame},
                        {"from_s", entry.uniform_motion.from_s},
                        {"pose", matrix(entry.uniform_motion.pose)},
                        {"velocity_mm_s", point(entry.uniform_motion.velocity_mm_s)},
                        {"spin_rad_s", point(entry.uniform_motion.angular_velocity_rad_s)}});
    }
    return list;
}

Json zones(const simulation::ZoneMonitor& monitor) {
    Json list = Json::array();
    for (const simulation::ZoneRule& zone : monitor.rules()) {
        Json min = Json::array();
        Json max = Json::array();
        for (const std::optional<machine::ZoneLimits>& walls : zone.walls) {
            min.push_back(walls ? Json(walls->min_mm) : Json(nullptr));
            max.push_back(walls ? Json(walls->max_mm) : Json(nullptr));
        }
        list.push_back({{"name", zone.name},
                        {"inside", zone.stay_inside},
                        {"on", zone.on},
                        {"min_mm", min},
                        {"max_mm", max}});
    }
    return list;
}

}  // namespace

Scene make_scene(const simulation::Simulator& simulator, const rrs::CartPos& base) {
    const machine::Machine& machine = simulator.machine();
    const auto kinematics = machine::make_kinematics(machine);
    const kinematics::Chain& chain = kinematics->chain();
    Scene scene;
    Json json = {
        {"machine", machine.name},
        {"controller", machine.controller.model},
        {"base", matrix(base)},
        {"axes", axes(machine)},
        {"position_joints", simulation::make_planner_setup(machine).position_joints},
        {"tool_side", branch(chain.tool_side())},
        {"work_side", branch(chain.work_side())},
        {"axis_space", axis_space_json(machine)},
        {"max_feed_mm_s", limit(machine.path.max_feed_mm_s)},
        {"max_rapid_mm_s", limit(machine.path.max_rapid_mm_s)},
        {"max_acceleration_mm_s2", limit(machine.path.max_acceleration_mm_s2)},
        {"process", machine.process ? Json(std::string(name(machine.process->kind))) : Json(nullptr)},
        {"zones", zones(simulator.motion().zones())}};
    Json tcps = Json::array();
    for (const Vector3d& tcp_mm : simulator.program().tool().tcps_mm()) tcps.push_back(point(tcp_mm));
    json["tcps_mm"] = std::move(tcps);
    if (const simulation::CellMonitor* cell = simulator.cell().monitor()) {
        json["cell"] = cell->cell().name;
        json["clearance_mm"] = cell->cell().clearance_mm;
        json["frames"] = frames(cell->cell().frames);
        json["bodies"] = bodies(cell->cell(), scene);
        json["drifts"] = drifts_json(cell->history().entries());
        json["drifts_complete"] = cell->history().is_complete();
        Json near = Json::array();
        for (const std::optional<double>& t_s : cell->clearance_times_s())
            near.push_back(t_s ? Json(*t_s) : Json(nullptr));
        json["near_s"] = std::move(near);
    }
    scene.json = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return scene;
}

}  // namespace gsim::engine
