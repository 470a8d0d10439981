#include "tests/cam/solid/jet_record.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <sstream>

#include "base/units.h"

namespace gsim::solid::models {

namespace {

// By the number of the line, from 1 on.
std::vector<bool> lines_with_jet(const std::string& program) {
    std::vector<bool> on{false};
    std::istringstream lines(program);
    std::string line;
    while (std::getline(lines, line)) {
        on.push_back(on.back());
        if (line.ends_with("M08")) on.back() = true;
        if (line.ends_with("M09")) on.back() = false;
    }
    return on;
}

/// Consecutive jets, with a ball about their TCPs, so that those that are far are not checked.
struct Together {
    std::span<const Jet> jets;
    Eigen::Vector3d middle_mm;
    double radius_mm = 0;
};

std::vector<Together> in_groups(std::span<const Jet> jets) {
    constexpr std::size_t kSize = 100;
    std::vector<Together> groups;
    for (; !jets.empty(); jets = jets.subspan(groups.back().jets.size())) {
        Together group{jets.first(std::min(kSize, jets.size())), jets.front().tcp_mm};
        for (const Jet& jet : group.jets)
            group.radius_mm = std::max(group.radius_mm, (jet.tcp_mm - group.middle_mm).norm());
        groups.push_back(group);
    }
    return groups;
}

}  // namespace

std::vector<Jet> read_jets(const std::string& csv, const std::string& program,
                           const Eigen::Vector3d& origin_mm) {
    const std::vector<bool> process_on = lines_with_jet(program);
    std::vector<Jet> jets;
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);  // the header: t_s,line,x_mm,y_mm,z_mm,b_deg,c_deg,speed_mm_s
    while (std::getline(lines, line)) {
        std::istringstream fields(line);
        std::array<double, 7> value{};
        std::string field;
        for (double& each : value) {
            std::getline(fields, field, ',');
            each = std::stod(field);
        }
        const auto line_number = static_cast<std::size_t>(value[1]);
        if (line_number >= process_on.size() || !process_on[line_number]) continue;
        const double turn = value[5] * kRadPerDeg;
        const double tilt = value[6] * kRadPerDeg;
        jets.push_back({Eigen::Vector3d(value[2], value[3], value[4]) - origin_mm,
                        {std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt)}});
    }
    return jets;
}

Deviation deviation(const std::vector<Eigen::Vector3d>& points, const std::vector<Jet>& jets,
                    double kerf_mm) {
    constexpr double kReach_mm = 40;  // of the jet, from its TCP
    constexpr double kTube_mm = 5;    // the nozzle ends so far above the TCP
    const std::vector<Together> groups = in_groups(jets);
    Deviation found{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Eigen::Vector3d& point : points) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Together& group : groups) {
            if ((point - group.middle_mm).norm() - group.radius_mm > kReach_mm + std::sqrt(nearest)) continue;
            for (const Jet& jet : group.jets) {
                const Eigen::Vector3d off = point - jet.tcp_mm;
                const double along = off.dot(jet.axis);
                if (along > kTube_mm || along < -kReach_mm) continue;
                nearest = std::min(nearest, off.squaredNorm() - along * along);
            }
        }
        const double left = std::sqrt(std::max(nearest, 0.0)) - kerf_mm / 2;
        found.min_mm = std::min(found.min_mm, left);
        found.greatest_mm = std::max(found.greatest_mm, left);
    }
    return found;
}

}  // namespace gsim::solid::models
