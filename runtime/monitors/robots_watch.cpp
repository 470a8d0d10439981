#include "runtime/monitors/robots_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/kinematics/chain_kinematics.h"

namespace gsim::simulation {

namespace {

// Some 1 kB each.
constexpr std::size_t kMostAhead = 16'384;

/// Returns a zone as a machine without joints.
std::shared_ptr<const cell::MachineBodies> bodies_of_zone(const cell::Shape& shape) {
    auto stands =
        std::make_shared<const kinematics::ChainKinematics>(kinematics::Chain(kinematics::Branch{}));
    const cell::Body body{&shape, 0, Eigen::Isometry3d::Identity()};
    return std::make_shared<const cell::MachineBodies>(
        cell::MachineBodies{std::move(stands), {{0, cell::Role::fixture, body, {}}}});
}

}  // namespace

RobotsWatch::RobotsWatch(const std::vector<PlacedRobot>& robots, const std::vector<PlacedZone>& zones,
                         os::CpuLimit* cpu)
    : robots_(robots.size()) {
    for (const PlacedRobot& robot : robots)
        tracks_.push_back({.name = robot.name, .base = robot.base, .simulator = &robot.simulator});
    for (const PlacedZone& zone : zones) {
        zones_.push_back({zone.shape, {{0, std::nullopt}}});
        tracks_.push_back({.name = zone.name, .base = zone.frame, .moved = true});
        tracks_.back().standing.bodies = bodies_of_zone(zones_.back().shape);
    }
    for (std::size_t a = 0; a < robots_; ++a) {
        if (!has_bodies(a)) continue;
        for (std::size_t b = a + 1; b < robots_; ++b) {
            if (has_bodies(b) && has_place_of_its_own(a, b)) add_pair(a, b, std::nullopt, cpu);
        }
        for (std::size_t zone = 0; zone < zones_.size(); ++zone) add_pair(a, robots_ + zone, zone, cpu);
    }
}

void RobotsWatch::add_pair(std::size_t a, std::size_t b, std::optional<std::size_t> zone, os::CpuLimit* cpu) {
    pairs_.push_back({{a, b}, zone, {tracks_[a].base, tracks_[b].base}});
    pairs_.back().watch.end_by(cpu);
    follow(tracks_[a]);
    follow(tracks_[b]);
}

bool RobotsWatch::has_bodies(std::size_t robot) const {
    const CellWatch* cell = tracks_[robot].simulator->cell();
    return cell != nullptr && cell->use().watched;
}

bool RobotsWatch::has_place_of_its_own(std::size_t a, std::size_t b) const {
    return tracks_[a].base.matrix() != tracks_[b].base.matrix();
}

void RobotsWatch::follow(Track& track) {
    if (track.simulator == nullptr || track.kinematics != nullptr) return;
    CellWatch& cell = *track.simulator->cell();
    track.kinematics = machine::make_kinematics(cell.machine());
    track.standing.bodies = bodies_of(track);
    cell.set_follower(
        [this, &track](const motion::Segment& segment, const MoveInfo& info) { take(track, segment, info); });
}

std::shared_ptr<const cell::MachineBodies> RobotsWatch::bodies_of(const Track& track) {
    return std::make_shared<const cell::MachineBodies>(
        cell::machine_bodies(track.simulator->cell()->cell(), track.kinematics));
}

// --- Input ---

void RobotsWatch::stand(Track& track, const rrs::JointPos& joints, double from_s) {
    motion::Segment& rest = track.standing.segment;
    rest.start = rest.end = joints;
    rest.start_s = from_s;
}

void RobotsWatch::take(Track& track, const motion::Segment& segment, const MoveInfo& info) {
    const std::uint64_t changes = track.simulator->cell()->frame_changes();
    if (std::exchange(track.frame_changes, changes) != changes) track.standing.bodies = bodies_of(track);
    track.moved = true;
    // Motion that the controller adds by itself, to settle, belongs to the block before.
    if (info.place.line > 0) track.standing.place = info.place;
    track.standing.jet_on = info.jet_on;
    stand(track, segment.end_position(), segment.end_s());
    track.pieces.push_back({segment, track.standing.place, info.jet_on, track.standing.bodies});
    if (track.pieces.size() % kMostAhead == 0 && far_ahead_) far_ahead_();
}

void RobotsWatch::give_zone(std::size_t zone, double time_s, std::optional<Holder> holder) {
    zones_[zone].turns.push_back({time_s, std::move(holder)});
}

void RobotsWatch::give_robot(std::size_t robot, double time_s, std::size_t process) {
    tracks_[robot].owners.push_back({time_s, process});
}

void RobotsWatch::know_until(double time_s) {
    for (Track& track : tracks_) {
        if (!track.moved) stand(track, track.simulator->joints(), 0);
        if (track.kinematics == nullptr) continue;
        const Simulator& simulator = *track.simulator;
        time_s = std::min({time_s, simulator.passed_on_s(), simulator.cell()->passed_on_s()});
    }
    for (Pair& pair : pairs_) go_on(pair, time_s);
    drop_passed();
}

void RobotsWatch::drop_passed() {
    for (std::size_t at = 0; at < tracks_.size(); ++at) {
        Track& track = tracks_[at];
        std::size_t needed = track.first + track.pieces.size();
        for (const Pair& pair : pairs_) {
            for (std::size_t i = 0; i < 2; ++i) {
                if (pair.tracks[i] == at) needed = std::min(needed, pair.next[i]);
            }
        }
        for (; track.first < needed; ++track.first) track.pieces.pop_front();
    }
}

// --- Checks ---

/// Returns a part by its number; after the last one the robot is at standstill.
const RobotsWatch::Piece& RobotsWatch::piece(const Track& track, std::size_t number) {
    const std::size_t index = number - track.first;
    return index < track.pieces.size() ? track.pieces[index] : track.standing;
}

/// Searches only parts that are kept.
const RobotsWatch::Piece& RobotsWatch::piece_at(const Track& track, double time_s) {
    const auto found =
        std::partition_point(track.pieces.begin(), track.pieces.end(),
                             [time_s](const Piece& piece) { return piece.segment.end_s() <= time_s; });
    return found == track.pieces.end() ? track.standing : *found;
}

/// Advances as far as the motion of both is known.
void RobotsWatch::go_on(Pair& pair, double known_s) {
    for (;;) {
        double until_s = end_of_turn_s(pair, known_s);
        std::array<const Piece*, 2> pieces{};
        for (std::size_t i = 0; i < 2; ++i) {
            const Track& track = tracks_[pair.tracks[i]];
            const auto has_passed = [&](const Piece& of) {
                return &of != &track.standing && of.segment.end_s() <= pair.time_s;
            };
            while (has_passed(piece(track, pair.next[i]))) ++pair.next[i];
            pieces[i] = &piece(track, pair.next[i]);
            const bool stands = pieces[i] == &track.standing;
            until_s = std::min(until_s, stands ? known_s : pieces[i]->segment.end_s());
        }
        if (!(until_s > pair.time_s)) return;
        const bool stand_for_ever = std::isinf(until_s);
        if (is_let_in(pair)) {
            pair.bodies = {};
        } else {
            look(pair, pieces, stand_for_ever ? pair.time_s : until_s);
        }
        if (stand_for_ever) return;
        pair.time_s = until_s;
    }
}

/// Returns until when the zone of a pair is as it is now, as far as that is known; infinite for two robots.
double RobotsWatch::end_of_turn_s(Pair& pair, double known_s) const {
    if (!pair.zone) return std::numeric_limits<double>::infinity();
    const std::vector<Turn>& turns = zones_[*pair.zone].turns;
    for (; pair.turn + 1 < turns.size() && turns[pair.turn + 1].from_s <= pair.time_s; ++pair.turn)
        pair.bodies = {};
    const double end_s =
        pair.turn + 1 < turns.size() ? std::min(known_s, turns[pair.turn + 1].from_s) : known_s;
    const Track& robot = tracks_[pair.tracks[0]];
    const auto next_owner = owner_behind(robot, pair.time_s);
    return next_owner == robot.owners.end() ? end_s : std::min(end_s, next_owner->from_s);
}

std::vector<RobotsWatch::Owner>::const_iterator RobotsWatch::owner_behind(const Track& track, double time_s) {
    return std::partition_point(track.owners.begin(), track.owners.end(),
                                [time_s](const Owner& owner) { return owner.from_s <= time_s; });
}

/// Returns the process that has a robot, or had it last.
std::optional<std::size_t> RobotsWatch::owner_at(const Track& track, double time_s) {
    const auto next = owner_behind(track, time_s);
    if (next == track.owners.begin()) return std::nullopt;
    return std::prev(next)->process;
}

/// Returns the first robot of a process.
std::optional<std::size_t> RobotsWatch::robot_of(const Holder& holder, double time_s) const {
    for (std::size_t robot = 0; robot < robots_; ++robot) {
        if (owner_at(tracks_[robot], time_s) == holder.process) return robot;
    }
    return std::nullopt;
}

/// Returns true if the robot of a pair may be in its zone.
bool RobotsWatch::is_let_in(const Pair& pair) const {
    if (!pair.zone) return false;
    const std::optional<Holder>& holder = zones_[*pair.zone].turns[pair.turn].holder;
    const auto owner = owner_at(tracks_[pair.tracks[0]], pair.time_s);
    return !holder || !owner || *owner == holder->process;
}

/// Bodies that were not checked before count as a new contact.
void RobotsWatch::look(Pair& pair, const std::array<const Piece*, 2>& pieces, double until_s) {
    if (std::array now{pieces[0]->bodies, pieces[1]->bodies}; now != pair.bodies) {
        pair.watch.set_bodies(now[0], now[1]);
        pair.bodies = std::move(now);
    }
    const auto going = [&](std::size_t i) {
        const motion::Segment& segment = pieces[i]->segment;
        return cell::NeighbourWatch::Going{segment, std::max(0.0, pair.time_s - segment.start_s),
                                           pieces[i]->jet_on};
    };
    pair.watch.take(pair.time_s, until_s - pair.time_s, going(0), going(1));
    note(pair, pieces);
}

}  // namespace gsim::simulation
