// The work of the motors against energies that are worked out from the frames of the links alone.
#include <gtest/gtest.h>

#include "motion/dynamics/dynamics.h"
#include "tests/motion/dynamics/models.h"

namespace gsim::dynamics {
namespace {

using Eigen::Vector3d;

/// Smooth path of the joints: sums of sines, with its derivatives.
class Way {
  public:
    Way(Random& random, const Chain& chain) : chain_(chain) {
        for (int wave = 0; wave < 3; ++wave) {
            sizes_.push_back(random.joints(chain.joint_count(), 0.6));
            rates_.push_back(random.joints(chain.joint_count(), 4));
        }
    }
    rrs::JointPos at(double t_s, int derivative) const {
        rrs::JointPos values = rrs::JointPos::Zero(chain_.joint_count());
        for (std::size_t wave = 0; wave < sizes_.size(); ++wave) {
            for (int j = 0; j < values.size(); ++j) {
                const double w = rates_[wave][j];
                values[j] += scale(j) * sizes_[wave][j] * std::pow(w, derivative) *
                             std::sin(w * t_s + derivative * kinematics::kQuarter);
            }
        }
        return values;
    }

  private:
    double scale(int joint) const { return chain_.kind(joint) == rrs::JointKind::prismatic ? 1000 : 1; }

    const Chain& chain_;
    std::vector<rrs::JointPos> sizes_, rates_;
};

/// Bodies with their frames, from both sides of the chain.
struct Placed {
    const RigidBody* body;
    Eigen::Isometry3d frame;
};

std::vector<Placed> placed(const Chain& chain, const DynamicsModel& model, const rrs::JointPos& q) {
    std::vector<Placed> list;
    const auto metres = [](Eigen::Isometry3d frame) {
        frame.translation() /= 1000;
        return frame;
    };
    const auto add = [&](const Branch& branch, const std::vector<rrs::CartPos>& frames,
                         const RigidBody& end) {
        for (std::size_t i = 0; i < branch.links.size(); ++i)
            list.push_back(
                {&model.links[static_cast<std::size_t>(branch.links[i].joint)], metres(frames[i + 1])});
        list.push_back({&end, metres(frames.back())});
    };
    add(chain.tool_side(), chain.tool_frames(q), model.tool);
    add(chain.work_side(), chain.work_frames(q), model.work);
    return list;
}

/// By differences of the frames over time, of fourth order.
double kinetic_j(const Chain& chain, const DynamicsModel& model, const Way& path, double t_s) {
    constexpr double kStep_s = 1e-3;
    std::array<std::vector<Placed>, 4> near;
    constexpr std::array kSteps{-2, -1, 1, 2};
    constexpr std::array kWeights{1.0 / 12, -8.0 / 12, 8.0 / 12, -1.0 / 12};
    for (std::size_t i = 0; i < near.size(); ++i)
        near[i] = placed(chain, model, path.at(t_s + kSteps[i] * kStep_s, 0));
    const std::vector<Placed> current = placed(chain, model, path.at(t_s, 0));
    double energy = 0;
    for (std::size_t b = 0; b < current.size(); ++b) {
        Vector3d velocity = Vector3d::Zero();
        Eigen::Matrix3d turn_rate = Eigen::Matrix3d::Zero();
        for (std::size_t i = 0; i < near.size(); ++i) {
            velocity += kWeights[i] / kStep_s * (near[i][b].frame * current[b].body->centre_m);
            turn_rate += kWeights[i] / kStep_s * near[i][b].frame.linear();
        }
        const Eigen::Matrix3d spin = current[b].frame.linear().transpose() * turn_rate;
        const Vector3d angular_velocity(spin(2, 1), spin(0, 2), spin(1, 0));  // in the body's axes
        energy += 0.5 * current[b].body->mass_kg * velocity.squaredNorm() +
                  0.5 * angular_velocity.dot(current[b].body->inertia_kg_m2 * angular_velocity);
    }
    const rrs::JointPos rates = path.at(t_s, 1);
    for (int j = 0; j < rates.size(); ++j) {
        const double rate = chain.kind(j) == rrs::JointKind::prismatic ? rates[j] / 1000 : rates[j];
        energy += 0.5 * model.drives[static_cast<std::size_t>(j)].rotor * rate * rate;
    }
    return energy;
}

double potential_j(const Chain& chain, const DynamicsModel& model, const Way& path, double t_s) {
    const rrs::JointPos q = path.at(t_s, 0);
    double energy = 0;
    for (const Placed& one : placed(chain, model, q))
        energy -= one.body->mass_kg * model.gravity_m_s2.dot(one.frame * one.body->centre_m);
    for (int j = 0; j < q.size(); ++j) {
        const double value = chain.kind(j) == rrs::JointKind::prismatic ? q[j] / 1000 : q[j];
        energy -= model.drives[static_cast<std::size_t>(j)].counterweight * value;
    }
    for (const Hose& hose : model.hoses) {
        Eigen::Isometry3d tool = chain.tool_frames(q).back();
        tool.translation() /= 1000;
        const double elongation_m = (tool * hose.point_m - hose.anchor_m).norm() - hose.free_length_m;
        if (elongation_m > 0) energy += 0.5 * hose.stiffness_n_per_m * elongation_m * elongation_m;
    }
    return energy;
}

TEST(Energy, MotorWorkIsEnergyChangePlusFriction) {
    constexpr int kSteps = 20'000;
    constexpr double kTime_s = 1.7;
    Random random(21);
    for (int round = 0; round < 100; ++round) {
        const Chain chain = random.chain(round % 5 + 1, round % 3);
        const DynamicsModel model = random.model(chain.joint_count());
        const Dynamics dynamics(chain, model);
        const Way path(random, chain);
        double work = 0;
        double friction = 0;
        double through = 0;                  // total energy, in any direction
        for (int i = 0; i <= kSteps; ++i) {  // Simpson's rule
            const double t_s = kTime_s * i / kSteps;
            const double weight = (i == 0 || i == kSteps ? 1 : (i % 2 == 1 ? 4 : 2)) * kTime_s / kSteps / 3;
            const rrs::JointPos v = path.at(t_s, 1);
            // Coulomb's friction jumps if a joint reverses, which disturbs every rule of integration: another
            // test checks its work.
            const Dynamics::Motion motion{path.at(t_s, 0), v, path.at(t_s, 2),
                                          rrs::JointPos::Zero(chain.joint_count())};
            const double power = dynamics.powers_w(dynamics.efforts(motion), v).sum();
            work += weight * power;
            through += weight * std::abs(power);
            friction += weight * dynamics.powers_w(dynamics.friction(v, motion.sense), v).sum();
        }
        const auto energy = [&](double t_s) {
            return kinetic_j(chain, model, path, t_s) + potential_j(chain, model, path, t_s);
        };
        EXPECT_NEAR(work, energy(kTime_s) - energy(0) + friction, 1e-8 * through) << round;
    }
}

}  // namespace
}  // namespace gsim::dynamics
