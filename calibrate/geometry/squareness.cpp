#include "calibrate/geometry/squareness.h"

#include <cmath>

#include "motion/kinematics/chain.h"

namespace gsim::calibrate {

namespace {

constexpr double kMicrometresPerMetre = 1e6;
constexpr double kMaxSquareCosine = 0.01;  // cosine of the angle

using Directions = std::vector<Eigen::Vector3d>;

/// Returns the direction in which each axis moves the tool relative to the work.
Directions axis_directions(machine::Machine machine) {
    machine.inverse = machine::InverseKind::none;
    const auto kinematics_model = machine::make_kinematics(machine);
    const auto frames = kinematics_model->chain().joint_frames(
        rrs::JointPos::Zero(static_cast<Eigen::Index>(machine.axes.size())));
    Directions directions;
    for (std::size_t i = 0; i < frames.size(); ++i)
        directions.push_back((machine.axes[i].carries == machine::CarriedPart::work ? -1 : 1) *
                             frames[i].linear().col(2));
    return directions;
}

double squareness_um_m(const Directions& directions, std::size_t first, std::size_t second) {
    return kMicrometresPerMetre * directions[first].dot(directions[second]);
}

}  // namespace

std::vector<Squareness> compute_squareness(const machine::Machine& nominal, const GeometryFit& fit) {
    const auto count = static_cast<Eigen::Index>(fit.found.size());
    std::vector<Deviation> deviations;
    Eigen::VectorXd values(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const FittedDeviation& found = fit.found[static_cast<std::size_t>(i)];
        deviations.push_back(found.deviation);
        values[i] = found.value;
    }
    const DeviatedMachine machine({.machine = nominal, .scales = {}});
    const Directions before = axis_directions(nominal), now = axis_directions(fit.geometry.machine);
    std::vector<Directions> stepped_directions;
    std::vector<double> steps;
    for (Eigen::Index i = 0; i < count; ++i) {
        steps.push_back(0.02 * typical_size(deviations[static_cast<std::size_t>(i)]));
        Eigen::VectorXd stepped = values;
        stepped[i] += steps.back();
        stepped_directions.push_back(axis_directions(machine.at(deviations, stepped).machine));
    }
    std::vector<Squareness> list;
    const auto is_slide = [&](std::size_t i) {
        return nominal.axes[i].kind == machine::AxisKind::linear &&
               nominal.axes[i].carries != machine::CarriedPart::none;
    };
    for (std::size_t a = 0; a < now.size(); ++a) {
        for (std::size_t b = a + 1; b < now.size(); ++b) {
            if (!is_slide(a) || !is_slide(b) || std::abs(before[a].dot(before[b])) > kMaxSquareCosine)
                continue;
            const double value = squareness_um_m(now, a, b);
            Eigen::VectorXd slopes(count);
            for (Eigen::Index i = 0; i < count; ++i) {
                const auto k = static_cast<std::size_t>(i);
                slopes[i] = (squareness_um_m(stepped_directions[k], a, b) - value) / steps[k];
            }
            list.push_back({nominal.axes[a].letter, nominal.axes[b].letter, value,
                            std::sqrt(slopes.dot(fit.covariance * slopes))});
        }
    }
    return list;
}

}  // namespace gsim::calibrate
