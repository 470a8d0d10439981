// Findings of a MultiRobotMonitor, for the reports of the robots.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "runtime/monitors/cell_findings.h"
#include "runtime/monitors/multi_robot_monitor.h"

namespace gsim::simulation {

std::string MultiRobotMonitor::item_name(const Track& track, std::size_t item) {
    if (track.cell == nullptr) return fmt::format("zone {}", track.name);
    return track.cell->cell().items[item].name;
}

/// Records new contacts of a pair, while the parts of both sides still exist.
void MultiRobotMonitor::note(Pair& pair, const std::array<const TrackSegment*, 2>& sub_segments) {
    const std::vector<cell::Contact>& contacts = pair.monitor.contacts();
    for (; pair.reported_count < contacts.size(); ++pair.reported_count) {
        const cell::Contact& contact = contacts[pair.reported_count];
        CollisionFinding found{static_cast<std::size_t>(&pair - pairs_.data()), pair.reported_count, {}};
        const auto add = [&](std::size_t robot, const TrackSegment& sub_segment, std::string robot_body,
                             std::string other) {
            const motion::Segment& segment = sub_segment.segment;
            const double t_s = std::clamp(contact.t_s - segment.start_s, 0.0, segment.duration_s);
            found.sides.push_back({robot, sub_segment.location, segment.position_at(t_s),
                                   std::move(robot_body), std::move(other)});
        };
        const Track& first = tracks_[pair.tracks[0]];
        const Track& second = tracks_[pair.tracks[1]];
        const std::string first_name = item_name(first, contact.pair.first);
        const std::string second_name = item_name(second, contact.pair.second);
        const std::string first_report = fmt::format("{}: {}", first.name, first_name);
        if (!pair.zone) {
            add(pair.tracks[0], *sub_segments[0], first_name,
                fmt::format("{}: {}", second.name, second_name));
            add(pair.tracks[1], *sub_segments[1], second_name, first_report);
        } else {
            const ZoneHolder& holder = *zones_[*pair.zone].turns[pair.turn].holder;
            add(pair.tracks[0], *sub_segments[0], first_name,
                fmt::format("{} of '{}'", second_name, holder.name));
            const auto robot = find_robot(holder, contact.t_s);
            if (robot && tracks_[*robot].kinematics != nullptr)
                add(*robot, segment_at(tracks_[*robot], contact.t_s), second_name, first_report);
        }
        found_.push_back(std::move(found));
    }
}

void MultiRobotMonitor::add_findings(std::vector<RobotReport>& reports) const {
    for (const Pair& pair : pairs_) {
        if (pair.zone) continue;
        for (const std::size_t robot : pair.tracks)
            reports[robot].report.cell->checked_bodies.robot_pairs += pair.monitor.pair_count();
    }
    for (const CollisionFinding& found : found_) {
        for (const ContactSide& side : found.sides) add_collision(found, side, reports);
    }
    for (RobotReport& robot : reports) {
        if (robot.report.cell) sort_by_time(*robot.report.cell);
    }
}

void MultiRobotMonitor::add_collision(const CollisionFinding& found, const ContactSide& side,
                                      std::vector<RobotReport>& reports) const {
    CellFindings& findings = *reports[side.robot].report.cell;
    const cell::Contact& contact = pairs_[found.pair].monitor.contacts()[found.contact];
    const Eigen::Vector3d point_mm = tracks_[side.robot].base.inverse() * contact.point_mm;
    list(findings, Collision{contact.t_s, side.location, side.robot_body, side.other, to_array(point_mm),
                             contact.penetrating, side.joints});
}

std::vector<std::string> MultiRobotMonitor::warnings() const {
    std::vector<std::string> list;
    for (std::size_t a = 0; a < robots_; ++a) {
        for (std::size_t b = a + 1; b < robots_; ++b) {
            if (!has_bodies(a) || !has_bodies(b) || has_separate_base(a, b)) continue;
            list.push_back(
                fmt::format("robots '{}' and '{}' have the same base position: not checked against each "
                            "other; give each a base",
                            tracks_[a].name, tracks_[b].name));
        }
    }
    return list;
}

}  // namespace gsim::simulation
