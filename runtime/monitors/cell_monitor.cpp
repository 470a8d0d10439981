#include "runtime/monitors/cell_monitor.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "collision/pairs/candidate_pairs.h"
#include "motion/kinematics/pose.h"
#include "runtime/monitors/cell_findings.h"

namespace gsim::simulation {

using motion::PlanError;
using motion::PlanResult;
using rrs::Status;

namespace {

CheckedBodies checked_bodies(const cell::Cell& cell, std::size_t pairs) {
    CheckedBodies bodies{.pairs = pairs, .allowed_pairs = cell.ignored.size(), .replaced = cell.replaced};
    for (const cell::Item& item : cell.items) {
        if (item.role == cell::Role::machine) {
            ++bodies.machine_shapes;
        } else if (item.role == cell::Role::jet) {
            ++bodies.jets;
        } else {
            ++bodies.objects;
        }
    }
    return bodies;
}

}  // namespace

CellMonitor::CellMonitor(cell::Cell cell, const machine::Machine& machine, CellOptions use)
    : machine_(machine),
      options_(use),
      cell_(std::move(cell)),
      programmed_frames_(cell_.frames, motion::MachineFrames(machine::make_kinematics(machine_)->chain())),
      monitor_(cell_, machine_) {
    findings_.name = cell_.name;
    findings_.clearance_mm = cell_.clearance_mm;
}

/// Returns a frame that a program may move.
tl::expected<std::size_t, PlanError> CellMonitor::find_movable(std::string_view name) const {
    auto found = programmed_frames_.find(name);
    if (!found) return found;
    if (programmed_frames_.tree().is_machine_frame(*found)) {
        return motion::make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("The frame '{}' belongs to the machine and is defined in its file; a program can "
                        "move only 'tool' and 'base', by ModifyCellFrame.",
                        name));
    }
    if (const auto moving = find_carrier(*found); moving && cell_.moving_frames[*moving].conveyor) {
        return motion::make_plan_error(Status::RRS_INVALID_PARAMETER,
                                       fmt::format("The frame '{}' moves with its conveyor.", name));
    }
    return found;
}

/// Returns the index of this frame among the cell's carried ones.
std::optional<std::size_t> CellMonitor::find_carrier(std::size_t frame) const {
    const auto found = std::find_if(cell_.moving_frames.begin(), cell_.moving_frames.end(),
                                    [frame](const cell::MovingFrame& one) { return one.frame == frame; });
    if (found == cell_.moving_frames.end()) return std::nullopt;
    return static_cast<std::size_t>(found - cell_.moving_frames.begin());
}

tl::expected<rrs::CartPos, PlanError> CellMonitor::frame(std::string_view name, double time_s) const {
    if (name == motion::kToolFrame) return programmed_frames_.machine_frames().tool();
    return programmed_frames_.find(name).map([&](std::size_t found) {
        const auto moving = find_carrier(found);
        return moving ? cell_.moving_frames[*moving].trajectory.at(time_s)
                      : programmed_frames_.tree().pose_in_parent(found);
    });
}

PlanResult CellMonitor::move_frame(std::string_view name, const rrs::CartPos& pose, double time_s) {
    const bool machine_shapes = motion::MachineFrames::has(name);
    const auto found = machine_shapes ? programmed_frames_.find(name) : find_movable(name);
    if (!found) return tl::unexpected(found.error());
    if (auto checked = kinematics::check_pose(pose); !checked)
        return motion::make_plan_error(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    if (machine_shapes) programmed_frames_.machine_frames().set(name, pose);
    if (name == motion::kToolFrame) return {};
    history_.add(*found, {.from_s = time_s, .pose = pose});
    if (const auto moving = find_carrier(*found)) {
        cell_.moving_frames[*moving].trajectory.add({.from_s = time_s, .pose = pose});
        return {};
    }
    programmed_frames_.tree().move(*found, pose);
    if (options_.monitored) {
        frame_moves_.push_back({time_s, *found, pose});
    } else {
        cell_.frames.move(*found, pose);  // no segment will come that the move waits for
    }
    return {};
}

/// Turns moves of the frame that segments have not reached yet into jumps.
PlanResult CellMonitor::enable_frame_motion(std::string_view name) {
    const auto found = find_movable(name);
    if (!found) return tl::unexpected(found.error());
    if (find_carrier(*found)) return {};
    cell::FrameTree frames = cell_.frames;
    frames.make_movable(*found);
    if (const auto error = cell::find_pair_count_error(cell_.items, frames))
        return motion::make_plan_error(
            Status::RRS_INVALID_PARAMETER,
            fmt::format("The frame '{}' cannot move independently: {}.", name, error->message));
    cell_.make_movable(*found, false);
    programmed_frames_.tree().make_movable(*found);
    for (const FrameMove& move : frame_moves_) {
        if (move.frame == *found)
            cell_.moving_frames[*find_carrier(*found)].trajectory.add(
                {.from_s = move.time_s, .pose = move.pose});
    }
    on_frames_changed();
    return {};
}

void CellMonitor::interpolate_frame(std::string_view name, const rrs::CartPos& pose, double from_s,
                                    double to_s) {
    const std::size_t frame = *programmed_frames_.tree().find(name);
    cell::FrameTrajectory& trajectory = cell_.moving_frames[*find_carrier(frame)].trajectory;
    for (const cell::UniformMotion& uniform_motion :
         {cell::uniform_motion_between(trajectory.at(from_s), pose, from_s, to_s),
          cell::UniformMotion{.from_s = to_s, .pose = pose}}) {
        history_.add(frame, uniform_motion);
        trajectory.add(uniform_motion);
    }
}

bool CellMonitor::has_conveyors() const {
    return std::any_of(cell_.moving_frames.begin(), cell_.moving_frames.end(),
                       [](const cell::MovingFrame& moving_frames) { return moving_frames.conveyor; });
}

void CellMonitor::set_conveyor(std::string_view name, const cell::UniformMotion& uniform_motion) {
    const auto found = programmed_frames_.tree().find(name);
    if (!found) return;
    const auto moving = find_carrier(*found);
    if (!moving || !cell_.moving_frames[*moving].conveyor) return;
    history_.add(*found, uniform_motion);
    cell_.moving_frames[*moving].trajectory.add(uniform_motion);
}

void CellMonitor::set_known_until(double time_s) {
    known_until_s_ = time_s;
    for (; !pending_segments_.empty() && pending_segments_.front().segment.end_s() <= time_s;
         pending_segments_.pop_front())
        check_segment(pending_segments_.front().segment, pending_segments_.front().info);
}

Result<cell::TouchSearch> CellMonitor::touch_search(const Eigen::Vector3d& tcp_mm, double time_s) {
    move_frames(time_s);
    return cell::TouchSearch::make(cell_, machine_, tcp_mm);
}

/// Moves the frames to their poses for motion that begins at a time.
void CellMonitor::move_frames(double until_s) {
    if (frame_moves_.empty() || frame_moves_.front().time_s > until_s) return;
    for (; !frame_moves_.empty() && frame_moves_.front().time_s <= until_s; frame_moves_.pop_front())
        cell_.frames.move(frame_moves_.front().frame, frame_moves_.front().pose);
    on_frames_changed();
}

void CellMonitor::on_frames_changed() {
    monitor_.on_frames_changed();
    ++frame_changes_;
}

void CellMonitor::on_segment(const motion::Segment& segment, const MoveInfo& info) {
    if (pending_segments_.empty() && segment.end_s() <= known_until_s_) {
        check_segment(segment, info);
    } else {
        pending_segments_.push_back({segment, info});
    }
}

void CellMonitor::check_segment(const motion::Segment& segment, const MoveInfo& info) {
    const bool continues = block_ && block_->file == info.location.file && block_->line == info.location.line;
    if (!continues) end_block();
    block_ = info.location;
    move_frames(segment.start_s);
    for (cell::MovingFrame& moving : cell_.moving_frames) moving.trajectory.discard_before(segment.start_s);
    monitor_.on_segment(segment, info.process_on, info.senses_cell);
    contact_locations_.resize(monitor_.contacts().size(), info.location);
    for (std::size_t i = joints_.size(); i < monitor_.contacts().size(); ++i) {
        const double t_s = monitor_.contacts()[i].t_s - segment.start_s;
        joints_.push_back(segment.position_at(std::clamp(t_s, 0.0, segment.duration_s)));
    }
    if (segment_listener_) segment_listener_(segment, info);
}

void CellMonitor::end_block() {
    const auto& nearest = monitor_.nearest();
    if (block_ && nearest) {
        const bool listed = list(
            findings_, BlockClearance{*block_, nearest->distance_mm, cell_.items[nearest->pair.first].name,
                                      cell_.items[nearest->pair.second].name, to_array(nearest->point_mm)});
        if (listed && history_.is_recording()) clearance_times_s_.push_back(nearest->t_s);
    }
    monitor_.begin_block();
}

void CellMonitor::end(double /*end_s*/) {
    set_known_until(std::numeric_limits<double>::infinity());
    end_block();
    findings_.checked_bodies = checked_bodies(cell_, monitor_.pair_count());
    const std::vector<cell::Contact>& contacts = monitor_.contacts();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        list(findings_,
             Collision{contacts[i].t_s, contact_locations_[i], cell_.items[contacts[i].pair.first].name,
                       cell_.items[contacts[i].pair.second].name, to_array(contacts[i].point_mm),
                       contacts[i].penetrating, joints_[i]});
    }
    sort_by_time(findings_);
}

}  // namespace gsim::simulation
