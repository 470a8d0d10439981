#include "motion/kinematics/chain_kinematics.h"

namespace gsim::kinematics {

namespace {

tl::unexpected<std::string> no_inverse_error() {
    return tl::unexpected<std::string>(
        "This machine has no inverse kinematics; give the target as joint values.");
}

}  // namespace

tl::expected<rrs::JointPos, std::string> ChainKinematics::inverse(const rrs::CartPos&,
                                                                  const rrs::JointPos&) const {
    return no_inverse_error();
}

tl::expected<std::vector<rrs::JointPos>, std::string> ChainKinematics::solutions(const rrs::CartPos&,
                                                                                 const rrs::JointPos&) const {
    return no_inverse_error();
}

}  // namespace gsim::kinematics
