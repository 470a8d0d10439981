#include "runtime/simulation/robots_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace gsim::simulation {

namespace {

// Some 1 kB each.
constexpr std::size_t kMostAhead = 16'384;
constexpr std::size_t kMostListed = 100'000;

std::array<double, 3> array_of(const Eigen::Vector3d& point) {
    return {point.x(), point.y(), point.z()};
}

}  // namespace

RobotsWatch::RobotsWatch(std::vector<PlacedRobot> robots, os::CpuLimit* cpu) {
    for (PlacedRobot& robot : robots) tracks_.push_back({std::move(robot)});
    for (std::size_t a = 0; a < tracks_.size(); ++a) {
        for (std::size_t b = a + 1; b < tracks_.size(); ++b) {
            if (!has_bodies(a) || !has_bodies(b) || !has_place_of_its_own(a, b)) continue;
            pairs_.push_back({{a, b}, {tracks_[a].robot.base, tracks_[b].robot.base}});
            pairs_.back().watch.end_by(cpu);
        }
    }
    for (const Pair& pair : pairs_) {
        for (const std::size_t robot : pair.robots) follow(tracks_[robot]);
    }
}

void RobotsWatch::follow(Track& track) {
    if (track.kinematics != nullptr) return;
    CellWatch& cell = *track.robot.simulator.cell();
    track.kinematics = machine::make_kinematics(cell.machine());
    track.standing.bodies = bodies_of(track);
    cell.set_follower(
        [this, &track](const motion::Segment& segment, const MoveInfo& info) { take(track, segment, info); });
}

bool RobotsWatch::has_bodies(std::size_t robot) const {
    const CellWatch* cell = tracks_[robot].robot.simulator.cell();
    return cell != nullptr && cell->use().watched;
}

bool RobotsWatch::has_place_of_its_own(std::size_t a, std::size_t b) const {
    return tracks_[a].robot.base.matrix() != tracks_[b].robot.base.matrix();
}

std::vector<std::string> RobotsWatch::warnings() const {
    std::vector<std::string> list;
    for (std::size_t a = 0; a < tracks_.size(); ++a) {
        for (std::size_t b = a + 1; b < tracks_.size(); ++b) {
            if (!has_bodies(a) || !has_bodies(b) || has_place_of_its_own(a, b)) continue;
            list.push_back(
                fmt::format("robots '{}' and '{}' stand in the same place (base): not looked at against each "
                            "other; give each a base",
                            tracks_[a].robot.name, tracks_[b].robot.name));
        }
    }
    return list;
}

std::shared_ptr<const cell::MachineBodies> RobotsWatch::bodies_of(const Track& track) {
    return std::make_shared<const cell::MachineBodies>(
        cell::machine_bodies(track.robot.simulator.cell()->cell(), track.kinematics));
}

void RobotsWatch::stand(Track& track, const rrs::JointPos& joints, double from_s) {
    motion::Segment& rest = track.standing.segment;
    rest.start = rest.end = joints;
    rest.start_s = from_s;
}

void RobotsWatch::take(Track& track, const motion::Segment& segment, const MoveInfo& info) {
    const CellWatch& cell = *track.robot.simulator.cell();
    if (std::exchange(track.frame_changes, cell.frame_changes()) != cell.frame_changes())
        track.standing.bodies = bodies_of(track);
    track.moved = true;
    track.standing.place = info.place;
    track.standing.jet_on = info.jet_on;
    stand(track, segment.end_position(), segment.end_s());
    track.pieces.push_back({segment, info.place, info.jet_on, track.standing.bodies});
    if (track.pieces.size() % kMostAhead == 0 && far_ahead_) far_ahead_();
}

bool RobotsWatch::is_far_ahead() const {
    return std::any_of(tracks_.begin(), tracks_.end(),
                       [](const Track& track) { return track.pieces.size() >= kMostAhead; });
}

void RobotsWatch::know_until(double time_s) {
    for (Track& track : tracks_) {
        if (!track.moved) stand(track, track.robot.simulator.joints(), 0);
    }
    for (Pair& pair : pairs_) go_on(pair, time_s);
    drop_passed();
}

/// By its number; behind the last one the robot stands.
const RobotsWatch::Piece& RobotsWatch::piece(const Track& track, std::size_t number) const {
    const std::size_t index = number - track.first;
    return index < track.pieces.size() ? track.pieces[index] : track.standing;
}

/// As far as the motion of both is known.
void RobotsWatch::go_on(Pair& pair, double known_s) {
    for (;;) {
        double until_s = std::numeric_limits<double>::infinity();
        std::array<const Piece*, 2> pieces{};
        for (std::size_t i = 0; i < 2; ++i) {
            const Track& track = tracks_[pair.robots[i]];
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
        look(pair, pieces, stand_for_ever ? pair.time_s : until_s);
        if (stand_for_ever) return;
        pair.time_s = until_s;
    }
}

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
    const std::vector<cell::Contact>& contacts = pair.watch.contacts();
    for (std::size_t n = pair.met.size(); n < contacts.size(); ++n) {
        Met met;
        for (std::size_t i = 0; i < 2; ++i) {
            const motion::Segment& segment = pieces[i]->segment;
            met.places[i] = pieces[i]->place;
            met.joints[i] =
                segment.position_at(std::clamp(contacts[n].t_s - segment.start_s, 0.0, segment.duration_s));
        }
        pair.met.push_back(std::move(met));
    }
}

void RobotsWatch::drop_passed() {
    for (std::size_t robot = 0; robot < tracks_.size(); ++robot) {
        Track& track = tracks_[robot];
        std::size_t needed = track.first + track.pieces.size();
        for (const Pair& pair : pairs_) {
            for (std::size_t i = 0; i < 2; ++i) {
                if (pair.robots[i] == robot) needed = std::min(needed, pair.next[i]);
            }
        }
        for (; track.first < needed; ++track.first) track.pieces.pop_front();
    }
}

void RobotsWatch::add_findings(std::vector<RobotReport>& reports) const {
    for (const Pair& pair : pairs_) add_contacts(pair, reports);
    for (RobotReport& robot : reports) {
        if (!robot.report.cell) continue;
        std::stable_sort(robot.report.cell->collisions.begin(), robot.report.cell->collisions.end(),
                         [](const Collision& a, const Collision& b) { return a.t_s < b.t_s; });
    }
}

void RobotsWatch::add_contacts(const Pair& pair, std::vector<RobotReport>& reports) const {
    const std::vector<cell::Contact>& contacts = pair.watch.contacts();
    for (std::size_t i = 0; i < 2; ++i) {
        const PlacedRobot& own = tracks_[pair.robots[i]].robot;
        const PlacedRobot& other = tracks_[pair.robots[1 - i]].robot;
        Report& report = reports[pair.robots[i]].report;
        CellFindings& findings = *report.cell;
        findings.looked_at.with_robots += pair.watch.pair_count();
        for (std::size_t n = 0; n < contacts.size(); ++n) {
            if (findings.collisions.size() == kMostListed) {
                findings.dropped += contacts.size() - n;
                report.warnings.push_back(
                    fmt::format("{} more contacts with '{}' were left out", contacts.size() - n, other.name));
                break;
            }
            const cell::Contact& contact = contacts[n];
            std::array items{contact.pair.first, contact.pair.second};
            const auto name = [](const PlacedRobot& of, std::size_t item) {
                return of.simulator.cell()->cell().items[item].name;
            };
            findings.collisions.push_back({contact.t_s, pair.met[n].places[i], name(own, items[i]),
                                           fmt::format("{}: {}", other.name, name(other, items[1 - i])),
                                           array_of(own.base.inverse() * contact.point_mm),
                                           contact.penetrating, pair.met[n].joints[i]});
        }
    }
}

}  // namespace gsim::simulation
