#include "machine/model/joint_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "motion/kinematics/jacobian.h"

namespace gsim::machine {

namespace {

constexpr double kMinReach_mm = 1000;
constexpr std::array<int, rrs::kMaxJoints> kPrimes{2,  3,  5,  7,  11, 13, 17, 19,
                                                   23, 29, 31, 37, 41, 43, 47, 53};

// Returns the digits of a number in a base, mirrored at the point.
double radical_inverse(int number, int base) {
    double value = 0;
    double digit = 1.0 / base;
    for (; number > 0; number /= base, digit /= base) value += digit * (number % base);
    return value;
}

}  // namespace

JointBox joint_box(const Machine& machine) {
    const double reach_mm = std::max(kMinReach_mm, kinematics::mm_per_rad(make_kinematics(machine)->chain()));
    const rrs::JointPos home = home_position(machine);
    JointBox box{home, home};
    Eigen::Index joint = 0;
    for (const Axis& axis : machine.axes) {
        double& low = box.low[joint];
        double& high = box.high[joint];
        low = joint_value(axis, axis.min);
        high = joint_value(axis, axis.max);
        if (axis.kind == AxisKind::rotary && high - low > 2 * std::numbers::pi) {
            low = std::clamp(home[joint] - std::numbers::pi, low, high - 2 * std::numbers::pi);
            high = low + 2 * std::numbers::pi;
        } else if (axis.kind == AxisKind::linear && std::isinf(high - low)) {
            box.cut.push_back(static_cast<int>(joint));
            low = std::max(low, home[joint] - reach_mm);
            high = std::min(high, home[joint] + reach_mm);
        }
        ++joint;
    }
    return box;
}

rrs::JointPos halton_point(int number, int joints) {
    rrs::JointPos point(joints);
    for (int i = 0; i < joints; ++i) point[i] = radical_inverse(number, kPrimes[static_cast<std::size_t>(i)]);
    return point;
}

rrs::JointPos JointBox::middle() const {
    return (low + high) / 2;
}

rrs::JointPos JointBox::at(const rrs::JointPos& shares) const {
    return low + shares.cwiseProduct(high - low);
}

}  // namespace gsim::machine
