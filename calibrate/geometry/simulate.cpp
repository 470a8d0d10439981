#include "calibrate/geometry/simulate.h"

#include <Eigen/Geometry>
#include <random>

#include "base/units.h"
#include "calibrate/geometry/identify.h"

namespace gsim::calibrate {

namespace {

Eigen::Vector3d drawn(std::mt19937_64& random, double sigma) {
    std::normal_distribution<double> normal;
    const double x = normal(random), y = normal(random), z = normal(random);
    return sigma * Eigen::Vector3d(x, y, z);
}

}  // namespace

std::vector<MeasuredTip> simulated(const Geometry& geometry, std::vector<MeasuredTip> poses,
                                   const Noise& noise, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const TipFinder finder(geometry);
    for (MeasuredTip& pose : poses) {
        pose.tip = finder.tip(pose.readings);
        pose.tip.translation() += drawn(random, noise.mm);
        const Eigen::Vector3d turn_deg = drawn(random, noise.deg);
        const double angle_deg = turn_deg.norm();
        if (!pose.has_orientation || angle_deg == 0) continue;
        pose.tip.linear() =
            Eigen::AngleAxisd(angle_deg * kRadPerDeg, turn_deg / angle_deg).toRotationMatrix() *
            pose.tip.linear();
    }
    return poses;
}

Eigen::VectorXd drawn_values(const std::vector<Deviation>& deviations, double share, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Eigen::VectorXd values(static_cast<Eigen::Index>(deviations.size()));
    for (std::size_t i = 0; i < deviations.size(); ++i)
        values[static_cast<Eigen::Index>(i)] = share * usual_size(deviations[i]) * normal(random);
    return values;
}

HiddenMachine hidden_machine(const machine::Machine& machine, const std::vector<MeasuredTip>& poses,
                             const DeviationChoice& choice, std::uint64_t seed) {
    constexpr double kShare = 0.2;  // 0.1 mm, 0.02 deg, 200 ppm
    const DeviatedMachine nominal({.machine = machine, .scales = {}});
    const std::vector<Deviation> all = all_deviations(machine, choice);
    const WeightedErrors errors(nominal, all, poses, {});
    const Eigen::MatrixXd slopes =
        errors.slopes(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(all.size())));
    HiddenMachine hidden{.geometry = nominal.nominal(), .deviations = {}, .values = {}};
    for (const std::size_t i : identify(slopes, all).chosen) hidden.deviations.push_back(all[i]);
    hidden.values = drawn_values(hidden.deviations, kShare, seed);
    hidden.geometry = nominal.at(hidden.deviations, hidden.values);
    return hidden;
}

}  // namespace gsim::calibrate
