#include "runtime/monitors/cell_watch.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/nearest_name.h"
#include "collision/pairs/meeting_pairs.h"
#include "motion/kinematics/pose.h"
#include "runtime/monitors/cell_findings.h"

namespace gsim::simulation {

using motion::PlanError;
using motion::Planned;
using rrs::Status;

namespace {

LookedAt looked_at(const cell::Cell& cell, std::size_t pairs) {
    LookedAt looked{.pairs = pairs, .may_touch = cell.ignored.size(), .replaced = cell.replaced};
    for (const cell::Item& item : cell.items) {
        if (item.role == cell::Role::machine) {
            ++looked.of_machine;
        } else if (item.role == cell::Role::jet) {
            ++looked.jets;
        } else {
            ++looked.objects;
        }
    }
    return looked;
}

}  // namespace

CellWatch::CellWatch(cell::Cell cell, const machine::Machine& machine, CellUse use)
    : machine_(machine),
      use_(use),
      cell_(std::move(cell)),
      set_frames_(cell_.frames),
      machine_frames_(machine::make_kinematics(machine_)->chain()),
      watch_(cell_, machine_) {
    findings_.name = cell_.name;
    findings_.clearance_mm = cell_.clearance_mm;
}

tl::expected<std::size_t, PlanError> CellWatch::find(std::string_view name) const {
    if (const auto found = set_frames_.find(name)) return *found;
    const std::vector<std::string_view> names = set_frames_.names();
    const auto nearest = text::nearest_name(name, names);
    return motion::refused(Status::RRS_UNKNOWN_FRAME,
                           fmt::format("The cell has no frame '{}'; {}", name,
                                       nearest ? fmt::format("did you mean '{}'?", *nearest)
                                               : fmt::format("there are: {}.", text::joined(names, ", "))));
}

/// Returns a frame that a program may move.
tl::expected<std::size_t, PlanError> CellWatch::find_movable(std::string_view name) const {
    auto found = find(name);
    if (!found) return found;
    if (set_frames_.is_of_machine(*found)) {
        return motion::refused(
            Status::RRS_INVALID_PARAMETER,
            fmt::format(
                "The frame '{}' is the machine's, whose file says where it is; of its frames a program "
                "moves 'tool' and 'base' alone, by ModifyCellFrame.",
                name));
    }
    if (const auto moving = carrier_of(*found); moving && cell_.carried[*moving].conveyor) {
        return motion::refused(Status::RRS_INVALID_PARAMETER,
                               fmt::format("The frame '{}' goes with its conveyor.", name));
    }
    return found;
}

/// Returns the index of this frame among the cell's carried ones.
std::optional<std::size_t> CellWatch::carrier_of(std::size_t frame) const {
    const auto found = std::find_if(cell_.carried.begin(), cell_.carried.end(),
                                    [frame](const cell::CarriedFrame& one) { return one.frame == frame; });
    if (found == cell_.carried.end()) return std::nullopt;
    return static_cast<std::size_t>(found - cell_.carried.begin());
}

tl::expected<rrs::CartPos, PlanError> CellWatch::frame(std::string_view name, double time_s) const {
    if (name == motion::kToolFrame) return machine_frames_.tool();
    return find(name).map([&](std::size_t found) {
        const auto moving = carrier_of(found);
        return moving ? cell_.carried[*moving].carrier.at(time_s) : set_frames_.in_parent(found);
    });
}

Planned CellWatch::move_frame(std::string_view name, const rrs::CartPos& pose, double time_s) {
    const bool of_machine = motion::MachineFrames::has(name);
    const auto found = of_machine ? find(name) : find_movable(name);
    if (!found) return tl::unexpected(found.error());
    if (auto checked = kinematics::check_pose(pose); !checked)
        return motion::refused(Status::RRS_INVALID_PARAMETER, std::move(checked.error()));
    if (of_machine) machine_frames_.set(name, pose);
    if (name == motion::kToolFrame) return {};
    note(*found, {.from_s = time_s, .pose = pose});
    if (const auto moving = carrier_of(*found)) {
        cell_.carried[*moving].carrier.add({.from_s = time_s, .pose = pose});
        return {};
    }
    set_frames_.move(*found, pose);
    if (use_.watched) {
        frame_moves_.push_back({time_s, *found, pose});
    } else {
        cell_.frames.move(*found, pose);  // no segment will come that the move waits for
    }
    return {};
}

/// Turns moves of the frame that segments have not reached yet into jumps.
Planned CellWatch::carry_frame(std::string_view name) {
    const auto found = find_movable(name);
    if (!found) return tl::unexpected(found.error());
    if (carrier_of(*found)) return {};
    cell::FrameTree frames = cell_.frames;
    frames.carry(*found);
    if (const auto fault = cell::find_too_many(cell_.items, frames))
        return motion::refused(Status::RRS_INVALID_PARAMETER,
                               fmt::format("The frame '{}' cannot go by itself: {}.", name, *fault));
    cell_.carry(*found, false);
    set_frames_.carry(*found);
    for (const FrameMove& move : frame_moves_) {
        if (move.frame == *found)
            cell_.carried[*carrier_of(*found)].carrier.add({.from_s = move.time_s, .pose = move.pose});
    }
    frames_changed();
    return {};
}

void CellWatch::lead_frame(std::string_view name, const rrs::CartPos& pose, double from_s, double to_s) {
    const std::size_t frame = *set_frames_.find(name);
    cell::Carrier& carrier = cell_.carried[*carrier_of(frame)].carrier;
    for (const cell::Drift& drift : {cell::drift_between(carrier.at(from_s), pose, from_s, to_s),
                                     cell::Drift{.from_s = to_s, .pose = pose}}) {
        note(frame, drift);
        carrier.add(drift);
    }
}

bool CellWatch::has_conveyors() const {
    return std::any_of(cell_.carried.begin(), cell_.carried.end(),
                       [](const cell::CarriedFrame& carried) { return carried.conveyor; });
}

void CellWatch::set_conveyor(std::string_view name, const cell::Drift& drift) {
    const auto found = set_frames_.find(name);
    if (!found) return;
    const auto moving = carrier_of(*found);
    if (!moving || !cell_.carried[*moving].conveyor) return;
    note(*found, drift);
    cell_.carried[*moving].carrier.add(drift);
}

void CellWatch::know_until(double time_s) {
    known_until_s_ = time_s;
    for (; !waiting_.empty() && waiting_.front().segment.end_s() <= time_s; waiting_.pop_front())
        look_at(waiting_.front().segment, waiting_.front().info);
}

tl::expected<cell::TouchSearch, std::string> CellWatch::touch_search(const Eigen::Vector3d& tip_mm,
                                                                     double time_s) {
    move_frames(time_s);
    return cell::TouchSearch::make(cell_, machine_, tip_mm);
}

/// Targets lead the tool centre point in the work frame, so a frame that moves independently against one of
/// them cannot be meant.
tl::expected<motion::WorkFrames, PlanError> CellWatch::work_frames(std::string_view tool_name,
                                                                   std::string_view object_name) const {
    auto tool = tip_frame(tool_name);
    if (!tool) return tl::unexpected(std::move(tool.error()));
    auto object = object_frame(object_name);
    if (!object) return tl::unexpected(std::move(object.error()));
    return motion::WorkFrames{*tool, *object};
}

Planned CellWatch::moves_together(std::size_t frame, std::size_t origin) const {
    if (set_frames_.link(frame) == set_frames_.link(origin)) return {};
    return motion::refused(
        Status::RRS_INVALID_PARAMETER,
        fmt::format("The frame '{}' moves against the frame '{}', to which it would have to be attached.",
                    set_frames_.name(frame), set_frames_.name(origin)));
}

/// Returns a frame as seen from the tool centre point of the kinematics.
tl::expected<rrs::CartPos, PlanError> CellWatch::tip_frame(std::string_view name) const {
    if (name == motion::kToolFrame) return machine_frames_.tool_shift();
    const auto frame = find(name);
    if (!frame) return tl::unexpected(frame.error());
    const std::size_t tool = *set_frames_.find(motion::kToolFrame);
    return moves_together(*frame, tool).map([&] {
        return set_frames_.in_link(tool).inverse() * set_frames_.in_link(*frame);
    });
}

/// Returns a frame as seen from the work frame of the kinematics; the world moves relative to it if the
/// machine does.
tl::expected<rrs::CartPos, PlanError> CellWatch::object_frame(std::string_view name) const {
    const auto frame = find(name);
    if (!frame) return tl::unexpected(frame.error());
    const std::size_t work = *set_frames_.find("work");
    if (*frame == work) return machine_frames_.work_frames().object;
    return moves_together(*frame, work).map([&]() -> rrs::CartPos {
        const rrs::CartPos origin = set_frames_.in_link(work);
        if (set_frames_.link(work) != 0) return origin.inverse() * set_frames_.in_link(*frame);
        return origin.inverse() * base_shift().inverse() * set_frames_.in_link(*frame);
    });
}

/// Moves the frames to their poses for motion that begins at a time.
void CellWatch::move_frames(double until_s) {
    if (frame_moves_.empty() || frame_moves_.front().time_s > until_s) return;
    for (; !frame_moves_.empty() && frame_moves_.front().time_s <= until_s; frame_moves_.pop_front())
        cell_.frames.move(frame_moves_.front().frame, frame_moves_.front().pose);
    frames_changed();
}

void CellWatch::frames_changed() {
    watch_.frames_changed();
    ++frame_changes_;
}

void CellWatch::take(const motion::Segment& segment, const MoveInfo& info) {
    if (waiting_.empty() && segment.end_s() <= known_until_s_) {
        look_at(segment, info);
    } else {
        waiting_.push_back({segment, info});
    }
}

void CellWatch::look_at(const motion::Segment& segment, const MoveInfo& info) {
    const bool goes_on = block_ && block_->file == info.place.file && block_->line == info.place.line;
    if (!goes_on) end_block();
    block_ = info.place;
    move_frames(segment.start_s);
    for (cell::CarriedFrame& moving : cell_.carried) moving.carrier.forget_before(segment.start_s);
    watch_.take(segment, info.jet_on, info.feels_cell);
    places_.resize(watch_.contacts().size(), info.place);
    for (std::size_t i = joints_.size(); i < watch_.contacts().size(); ++i) {
        const double t_s = watch_.contacts()[i].t_s - segment.start_s;
        joints_.push_back(segment.position_at(std::clamp(t_s, 0.0, segment.duration_s)));
    }
    if (follower_) follower_(segment, info);
}

void CellWatch::end_block() {
    const auto& nearest = watch_.nearest();
    if (block_ && nearest) {
        const bool listed = list(
            findings_, BlockClearance{*block_, nearest->distance_mm, cell_.items[nearest->pair.first].name,
                                      cell_.items[nearest->pair.second].name, array_of(nearest->point_mm)});
        if (listed && keeps_history_) near_s_.push_back(nearest->t_s);
    }
    watch_.begin_block();
}

void CellWatch::end(double /*end_s*/) {
    know_until(std::numeric_limits<double>::infinity());
    end_block();
    findings_.looked_at = looked_at(cell_, watch_.pair_count());
    const std::vector<cell::Contact>& contacts = watch_.contacts();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        list(findings_, Collision{contacts[i].t_s, places_[i], cell_.items[contacts[i].pair.first].name,
                                  cell_.items[contacts[i].pair.second].name, array_of(contacts[i].point_mm),
                                  contacts[i].penetrating, joints_[i]});
    }
    sort_by_time(findings_);
}

}  // namespace gsim::simulation
