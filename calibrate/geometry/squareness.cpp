#include "calibrate/geometry/squareness.h"

#include <cmath>

#include "motion/kinematics/chain.h"

namespace gsim::calibrate {

namespace {

constexpr double kMicrometresPerMetre = 1e6;
constexpr double kNearlySquare = 0.01;  // cosine of the angle

using Directions = std::vector<Eigen::Vector3d>;

/// Returns the direction in which each axis moves the tool relative to the work.
Directions directions_of(machine::Machine machine) {
    machine.inverse = machine::InverseKind::none;
    const auto made = machine::make_kinematics(machine);
    const auto frames =
        made->chain().joint_frames(rrs::JointPos::Zero(static_cast<Eigen::Index>(machine.axes.size())));
    Directions directions;
    for (std::size_t i = 0; i < frames.size(); ++i)
        directions.push_back((machine.axes[i].carries == machine::Carries::work ? -1 : 1) *
                             frames[i].linear().col(2));
    return directions;
}

double off_square(const Directions& directions, std::size_t first, std::size_t second) {
    return kMicrometresPerMetre * directions[first].dot(directions[second]);
}

}  // namespace

std::vector<Squareness> squareness_of(const machine::Machine& nominal, const GeometryFit& fit) {
    const auto count = static_cast<Eigen::Index>(fit.found.size());
    std::vector<Deviation> deviations;
    Eigen::VectorXd values(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const FoundDeviation& found = fit.found[static_cast<std::size_t>(i)];
        deviations.push_back(found.deviation);
        values[i] = found.value;
    }
    const DeviatedMachine machine({.machine = nominal, .scales = {}});
    const Directions before = directions_of(nominal), now = directions_of(fit.geometry.machine);
    std::vector<Directions> beside;
    std::vector<double> steps;
    for (Eigen::Index i = 0; i < count; ++i) {
        steps.push_back(0.02 * usual_size(deviations[static_cast<std::size_t>(i)]));
        Eigen::VectorXd stepped = values;
        stepped[i] += steps.back();
        beside.push_back(directions_of(machine.at(deviations, stepped).machine));
    }
    std::vector<Squareness> list;
    const auto is_slide = [&](std::size_t i) {
        return nominal.axes[i].kind == machine::AxisKind::linear &&
               nominal.axes[i].carries != machine::Carries::nothing;
    };
    for (std::size_t a = 0; a < now.size(); ++a) {
        for (std::size_t b = a + 1; b < now.size(); ++b) {
            if (!is_slide(a) || !is_slide(b) || std::abs(before[a].dot(before[b])) > kNearlySquare) continue;
            const double value = off_square(now, a, b);
            Eigen::VectorXd slopes(count);
            for (Eigen::Index i = 0; i < count; ++i) {
                const auto k = static_cast<std::size_t>(i);
                slopes[i] = (off_square(beside[k], a, b) - value) / steps[k];
            }
            list.push_back({nominal.axes[a].letter, nominal.axes[b].letter, value,
                            std::sqrt(slopes.dot(fit.covariance * slopes))});
        }
    }
    return list;
}

}  // namespace gsim::calibrate
