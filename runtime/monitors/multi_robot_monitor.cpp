#include "runtime/monitors/multi_robot_monitor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/kinematics/chain_kinematics.h"

namespace gsim::simulation {

namespace {

// Some 1 kB each.
constexpr std::size_t kMaxBufferedSegments = 16'384;

/// Returns a zone as a machine without joints.
std::shared_ptr<const cell::MachineBodies> zone_bodies(const cell::Shape& shape) {
    auto is_stationary =
        std::make_shared<const kinematics::ChainKinematics>(kinematics::Chain(kinematics::Branch{}));
    const cell::Body body{&shape, 0, Eigen::Isometry3d::Identity()};
    return std::make_shared<const cell::MachineBodies>(
        cell::MachineBodies{std::move(is_stationary), {{0, cell::Role::fixture, body, {}}}});
}

}  // namespace

MultiRobotMonitor::MultiRobotMonitor(const std::vector<PlacedRobot>& robots,
                                     const std::vector<PlacedZone>& zones, os::CpuLimit* cpu)
    : robots_(robots.size()) {
    for (const PlacedRobot& robot : robots)
        tracks_.push_back(
            {.name = robot.name, .base = robot.base, .motion = &robot.motion, .cell = robot.cell});
    for (const PlacedZone& zone : zones) {
        zones_.push_back({zone.shape, {{0, std::nullopt}}});
        tracks_.push_back({.name = zone.name, .base = zone.frame, .moved = true});
        tracks_.back().standstill.bodies = zone_bodies(zones_.back().shape);
    }
    for (std::size_t a = 0; a < robots_; ++a) {
        if (!has_bodies(a)) continue;
        for (std::size_t b = a + 1; b < robots_; ++b) {
            if (has_bodies(b) && has_separate_base(a, b)) add_pair(a, b, std::nullopt, cpu);
        }
        for (std::size_t zone = 0; zone < zones_.size(); ++zone) add_pair(a, robots_ + zone, zone, cpu);
    }
}

void MultiRobotMonitor::add_pair(std::size_t a, std::size_t b, std::optional<std::size_t> zone,
                                 os::CpuLimit* cpu) {
    pairs_.push_back({{a, b}, zone, {tracks_[a].base, tracks_[b].base}});
    pairs_.back().monitor.set_time_limit(cpu);
    attach_track(tracks_[a]);
    attach_track(tracks_[b]);
}

bool MultiRobotMonitor::has_bodies(std::size_t robot) const {
    const CellMonitor* cell = tracks_[robot].cell;
    return cell != nullptr && cell->use().monitored;
}

bool MultiRobotMonitor::has_separate_base(std::size_t a, std::size_t b) const {
    return tracks_[a].base.matrix() != tracks_[b].base.matrix();
}

void MultiRobotMonitor::attach_track(Track& track) {
    if (track.motion == nullptr || track.kinematics != nullptr) return;
    CellMonitor& cell = *track.cell;
    track.kinematics = machine::make_kinematics(cell.machine());
    track.standstill.bodies = make_bodies(track);
    cell.set_segment_listener([this, &track](const motion::Segment& segment, const MoveInfo& info) {
        on_segment(track, segment, info);
    });
}

std::shared_ptr<const cell::MachineBodies> MultiRobotMonitor::make_bodies(const Track& track) {
    return std::make_shared<const cell::MachineBodies>(
        cell::machine_bodies(track.cell->cell(), track.kinematics));
}

// --- Input ---

void MultiRobotMonitor::set_standstill(Track& track, const rrs::JointPos& joints, double from_s) {
    motion::Segment& standstill_segment = track.standstill.segment;
    standstill_segment.start = standstill_segment.end = joints;
    standstill_segment.start_s = from_s;
}

void MultiRobotMonitor::on_segment(Track& track, const motion::Segment& segment, const MoveInfo& info) {
    const std::uint64_t changes = track.cell->frame_changes();
    if (std::exchange(track.frame_changes, changes) != changes) track.standstill.bodies = make_bodies(track);
    track.moved = true;
    // Motion that the controller adds by itself, to settle, belongs to the block before.
    if (info.location.line > 0) track.standstill.location = info.location;
    track.standstill.process_on = info.process_on;
    set_standstill(track, segment.end_position(), segment.end_s());
    track.sub_segments.push_back(
        {segment, track.standstill.location, info.process_on, track.standstill.bodies});
    if (track.sub_segments.size() % kMaxBufferedSegments == 0 && on_buffer_full_) on_buffer_full_();
}

void MultiRobotMonitor::assign_zone(std::size_t zone, double time_s, std::optional<ZoneHolder> holder) {
    zones_[zone].turns.push_back({time_s, std::move(holder)});
}

void MultiRobotMonitor::assign_robot(std::size_t robot, double time_s, std::size_t process) {
    tracks_[robot].owners.push_back({time_s, process});
}

void MultiRobotMonitor::set_known_until(double time_s) {
    for (Track& track : tracks_) {
        if (!track.moved) set_standstill(track, track.motion->source().position(), 0);
        if (track.kinematics == nullptr) continue;
        time_s =
            std::min({time_s, track.motion->source().delivered_until_s(), track.cell->delivered_until_s()});
    }
    for (Pair& pair : pairs_) advance(pair, time_s);
    discard_passed();
}

void MultiRobotMonitor::discard_passed() {
    for (std::size_t at = 0; at < tracks_.size(); ++at) {
        Track& track = tracks_[at];
        std::size_t needed = track.first + track.sub_segments.size();
        for (const Pair& pair : pairs_) {
            for (std::size_t i = 0; i < 2; ++i) {
                if (pair.tracks[i] == at) needed = std::min(needed, pair.next[i]);
            }
        }
        for (; track.first < needed; ++track.first) track.sub_segments.pop_front();
    }
}

// --- Checks ---

/// Returns a part by its number; past the last one the robot is at standstill.
const MultiRobotMonitor::TrackSegment& MultiRobotMonitor::sub_segment(const Track& track,
                                                                      std::size_t number) {
    const std::size_t index = number - track.first;
    return index < track.sub_segments.size() ? track.sub_segments[index] : track.standstill;
}

/// Searches only parts that are kept.
const MultiRobotMonitor::TrackSegment& MultiRobotMonitor::segment_at(const Track& track, double time_s) {
    const auto found = std::partition_point(
        track.sub_segments.begin(), track.sub_segments.end(),
        [time_s](const TrackSegment& sub_segment) { return sub_segment.segment.end_s() <= time_s; });
    return found == track.sub_segments.end() ? track.standstill : *found;
}

/// Advances as far as the motion of both is known.
void MultiRobotMonitor::advance(Pair& pair, double known_s) {
    for (;;) {
        double until_s = occupancy_end_s(pair, known_s);
        std::array<const TrackSegment*, 2> sub_segments{};
        for (std::size_t i = 0; i < 2; ++i) {
            const Track& track = tracks_[pair.tracks[i]];
            const auto has_passed = [&](const TrackSegment& of) {
                return &of != &track.standstill && of.segment.end_s() <= pair.time_s;
            };
            while (has_passed(sub_segment(track, pair.next[i]))) ++pair.next[i];
            sub_segments[i] = &sub_segment(track, pair.next[i]);
            const bool is_stationary = sub_segments[i] == &track.standstill;
            until_s = std::min(until_s, is_stationary ? known_s : sub_segments[i]->segment.end_s());
        }
        if (!(until_s > pair.time_s)) return;
        const bool both_stationary = std::isinf(until_s);
        if (may_enter_zone(pair)) {
            pair.bodies = {};
        } else {
            check_pair(pair, sub_segments, both_stationary ? pair.time_s : until_s);
        }
        if (both_stationary) return;
        pair.time_s = until_s;
    }
}

/// Returns until when the zone of a pair is as it is now, as far as that is known; infinite for two robots.
double MultiRobotMonitor::occupancy_end_s(Pair& pair, double known_s) const {
    if (!pair.zone) return std::numeric_limits<double>::infinity();
    const std::vector<ZoneOccupancy>& turns = zones_[*pair.zone].turns;
    for (; pair.turn + 1 < turns.size() && turns[pair.turn + 1].from_s <= pair.time_s; ++pair.turn)
        pair.bodies = {};
    const double end_s =
        pair.turn + 1 < turns.size() ? std::min(known_s, turns[pair.turn + 1].from_s) : known_s;
    const Track& robot = tracks_[pair.tracks[0]];
    const auto next_owner = find_next_owner(robot, pair.time_s);
    return next_owner == robot.owners.end() ? end_s : std::min(end_s, next_owner->from_s);
}

std::vector<MultiRobotMonitor::Owner>::const_iterator MultiRobotMonitor::find_next_owner(const Track& track,
                                                                                         double time_s) {
    return std::partition_point(track.owners.begin(), track.owners.end(),
                                [time_s](const Owner& owner) { return owner.from_s <= time_s; });
}

/// Returns the process that has a robot, or had it last.
std::optional<std::size_t> MultiRobotMonitor::owner_at(const Track& track, double time_s) {
    const auto next = find_next_owner(track, time_s);
    if (next == track.owners.begin()) return std::nullopt;
    return std::prev(next)->process;
}

/// Returns the first robot of a process.
std::optional<std::size_t> MultiRobotMonitor::find_robot(const ZoneHolder& holder, double time_s) const {
    for (std::size_t robot = 0; robot < robots_; ++robot) {
        if (owner_at(tracks_[robot], time_s) == holder.process) return robot;
    }
    return std::nullopt;
}

/// Returns true if the robot of a pair may be in its zone.
bool MultiRobotMonitor::may_enter_zone(const Pair& pair) const {
    if (!pair.zone) return false;
    const std::optional<ZoneHolder>& holder = zones_[*pair.zone].turns[pair.turn].holder;
    const auto owner = owner_at(tracks_[pair.tracks[0]], pair.time_s);
    return !holder || !owner || *owner == holder->process;
}

/// Bodies that were not checked before count as a new contact.
void MultiRobotMonitor::check_pair(Pair& pair, const std::array<const TrackSegment*, 2>& sub_segments,
                                   double until_s) {
    if (std::array now{sub_segments[0]->bodies, sub_segments[1]->bodies}; now != pair.bodies) {
        pair.monitor.set_bodies(now[0], now[1]);
        pair.bodies = std::move(now);
    }
    const auto motion_of = [&](std::size_t i) {
        const motion::Segment& segment = sub_segments[i]->segment;
        return cell::NeighbourMonitor::ActiveSegment{segment, std::max(0.0, pair.time_s - segment.start_s),
                                                     sub_segments[i]->process_on};
    };
    pair.monitor.on_segment(pair.time_s, until_s - pair.time_s, motion_of(0), motion_of(1));
    note(pair, sub_segments);
}

}  // namespace gsim::simulation
