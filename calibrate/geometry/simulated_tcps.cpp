#include "calibrate/geometry/simulated_tcps.h"

#include <Eigen/Geometry>
#include <random>

#include "base/units.h"
#include "calibrate/geometry/identification.h"

namespace gsim::calibrate {

namespace {

Eigen::Vector3d random_vector(std::mt19937_64& random, double sigma) {
    std::normal_distribution<double> normal;
    const double x = normal(random), y = normal(random), z = normal(random);
    return sigma * Eigen::Vector3d(x, y, z);
}

}  // namespace

std::vector<MeasuredTcp> simulated_tcps(const Geometry& geometry, std::vector<MeasuredTcp> poses,
                                        const Noise& noise, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const TcpCalculator calculator(geometry);
    for (MeasuredTcp& pose : poses) {
        pose.tcp = calculator.tcp(pose.readings);
        pose.tcp.translation() += random_vector(random, noise.mm);
        const Eigen::Vector3d rotation_deg = random_vector(random, noise.deg);
        const double angle_deg = rotation_deg.norm();
        if (!pose.has_orientation || angle_deg == 0) continue;
        pose.tcp.linear() =
            Eigen::AngleAxisd(angle_deg * kRadPerDeg, rotation_deg / angle_deg).toRotationMatrix() *
            pose.tcp.linear();
    }
    return poses;
}

Eigen::VectorXd random_deviations(const std::vector<Deviation>& deviations, double share,
                                  std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Eigen::VectorXd values(static_cast<Eigen::Index>(deviations.size()));
    for (std::size_t i = 0; i < deviations.size(); ++i)
        values[static_cast<Eigen::Index>(i)] = share * typical_size(deviations[i]) * normal(random);
    return values;
}

GroundTruth make_ground_truth(const machine::Machine& machine, const std::vector<MeasuredTcp>& poses,
                              const DeviationOptions& deviation_options, std::uint64_t seed) {
    constexpr double kDeviationShare = 0.2;  // 0.1 mm, 0.02 deg, 200 ppm
    const DeviatedMachine nominal({.machine = machine, .scales = {}});
    const std::vector<Deviation> all = all_deviations(machine, deviation_options);
    const WeightedErrors errors(nominal, all, poses, {});
    const Eigen::MatrixXd slopes =
        errors.slopes(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(all.size())));
    GroundTruth ground_truth{.geometry = nominal.nominal(), .deviations = {}, .values = {}};
    for (const std::size_t i : identify(slopes, all).selected) ground_truth.deviations.push_back(all[i]);
    ground_truth.values = random_deviations(ground_truth.deviations, kDeviationShare, seed);
    ground_truth.geometry = nominal.at(ground_truth.deviations, ground_truth.values);
    return ground_truth;
}

}  // namespace gsim::calibrate
