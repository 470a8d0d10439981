// Findings of a RobotsWatch, for the reports of the robots.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "runtime/monitors/cell_findings.h"
#include "runtime/monitors/robots_watch.h"

namespace gsim::simulation {

std::string RobotsWatch::item_name(const Track& track, std::size_t item) {
    if (track.simulator == nullptr) return fmt::format("zone {}", track.name);
    return track.simulator->cell()->cell().items[item].name;
}

/// Records new contacts of a pair, while the parts of both sides still exist.
void RobotsWatch::note(Pair& pair, const std::array<const Piece*, 2>& pieces) {
    const std::vector<cell::Contact>& contacts = pair.watch.contacts();
    for (; pair.told < contacts.size(); ++pair.told) {
        const cell::Contact& contact = contacts[pair.told];
        Found found{static_cast<std::size_t>(&pair - pairs_.data()), pair.told, {}};
        const auto add = [&](std::size_t robot, const Piece& piece, std::string own, std::string other) {
            const motion::Segment& segment = piece.segment;
            const double t_s = std::clamp(contact.t_s - segment.start_s, 0.0, segment.duration_s);
            found.sides.push_back(
                {robot, piece.place, segment.position_at(t_s), std::move(own), std::move(other)});
        };
        const Track& first = tracks_[pair.tracks[0]];
        const Track& second = tracks_[pair.tracks[1]];
        const std::string of_first = item_name(first, contact.pair.first);
        const std::string of_second = item_name(second, contact.pair.second);
        const std::string told_first = fmt::format("{}: {}", first.name, of_first);
        if (!pair.zone) {
            add(pair.tracks[0], *pieces[0], of_first, fmt::format("{}: {}", second.name, of_second));
            add(pair.tracks[1], *pieces[1], of_second, told_first);
        } else {
            const Holder& holder = *zones_[*pair.zone].turns[pair.turn].holder;
            add(pair.tracks[0], *pieces[0], of_first, fmt::format("{} of '{}'", of_second, holder.name));
            const auto robot = robot_of(holder, contact.t_s);
            if (robot && tracks_[*robot].kinematics != nullptr)
                add(*robot, piece_at(tracks_[*robot], contact.t_s), of_second, told_first);
        }
        found_.push_back(std::move(found));
    }
}

void RobotsWatch::add_findings(std::vector<RobotReport>& reports) const {
    for (const Pair& pair : pairs_) {
        if (pair.zone) continue;
        for (const std::size_t robot : pair.tracks)
            reports[robot].report.cell->looked_at.with_robots += pair.watch.pair_count();
    }
    for (const Found& found : found_) {
        for (const Side& side : found.sides) add_collision(found, side, reports);
    }
    for (RobotReport& robot : reports) {
        if (robot.report.cell) sort_by_time(*robot.report.cell);
    }
}

void RobotsWatch::add_collision(const Found& found, const Side& side,
                                std::vector<RobotReport>& reports) const {
    CellFindings& findings = *reports[side.robot].report.cell;
    const cell::Contact& contact = pairs_[found.pair].watch.contacts()[found.contact];
    const Eigen::Vector3d point_mm = tracks_[side.robot].base.inverse() * contact.point_mm;
    list(findings, Collision{contact.t_s, side.place, side.own, side.other, array_of(point_mm),
                             contact.penetrating, side.joints});
}

std::vector<std::string> RobotsWatch::warnings() const {
    std::vector<std::string> list;
    for (std::size_t a = 0; a < robots_; ++a) {
        for (std::size_t b = a + 1; b < robots_; ++b) {
            if (!has_bodies(a) || !has_bodies(b) || has_place_of_its_own(a, b)) continue;
            list.push_back(
                fmt::format("robots '{}' and '{}' stand in the same place (base): not looked at against each "
                            "other; give each a base",
                            tracks_[a].name, tracks_[b].name));
        }
    }
    return list;
}

}  // namespace gsim::simulation
