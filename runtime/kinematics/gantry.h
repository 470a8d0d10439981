#pragma once

#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "runtime/kinematics/dh_chain.h"
#include "runtime/kinematics/kinematics.h"

namespace gsim::kinematics {

/// Three mutually orthogonal prismatic joints in any order, then up to two revolute joints whose axes pass
/// through the tool tip, so that the tip stays where it is while they turn. The inverse is in closed form:
/// position is an affine function of the prismatic joints alone, orientation one of the revolute joints
/// alone.
class GantryKinematics : public Kinematics {
  public:
    /// Takes a chain if it is such a machine (checked numerically: axes orthogonal to 1e-9, axes through the
    /// tip to 1e-6 mm); otherwise a sentence that says what is in the way.
    static tl::expected<std::shared_ptr<const GantryKinematics>, std::string> make(DhChain chain);

    const DhChain& chain() const override { return chain_; }
    int joint_count() const override { return chain_.joint_count(); }
    bool has_inverse() const override { return true; }
    rrs::CartPos forward(const rrs::JointPos& joints) const override { return chain_.forward(joints); }

    /// Two rotary axes reach two of three degrees of orientation. A pose that they reach exactly is reached
    /// exactly; of any other its tool axis (Z) is matched and the turn about it is left to the machine, with
    /// the solution nearest to `near`. Where the first rotary axis is parallel to the wanted tool axis and
    /// the pose does not say where it should stand, it stays at its value in `near`. Revolute joints come
    /// within half a turn of `near`. An error where the tool axis itself is out of reach by more than 1e-6
    /// rad.
    tl::expected<rrs::JointPos, std::string> inverse(const rrs::CartPos& pose,
                                                     const rrs::JointPos& near) const override;

    /// Where there are two rotary axes, at right angles to each other and the second one to the tool.
    std::optional<TiltingHead> tilting_head() const override;

  private:
    using Angles = Eigen::Vector2d;  // of the first and second revolute joint, rad

    explicit GantryKinematics(DhChain chain) : chain_(std::move(chain)) {}
    std::optional<std::string> study();
    std::optional<std::string> study_linear_axes(const std::vector<rrs::CartPos>& at_zero);
    std::optional<std::string> study_rotary_axes(const std::vector<rrs::CartPos>& at_zero);

    Eigen::Matrix3d turned(const Angles& angles) const;
    Angles exact_angles(const Eigen::Matrix3d& turn) const;
    std::optional<Angles> tool_axis_angles(const Eigen::Vector3d& tool_axis, const Angles& near) const;
    std::optional<Angles> one_axis_angles(const Eigen::Vector3d& tool_axis, const Angles& near) const;
    std::optional<Angles> two_axis_angles(const Eigen::Vector3d& tool_axis, const Angles& near) const;

    DhChain chain_;
    int rotary_count_ = 0;
    Eigen::Matrix3d linear_axes_ =
        Eigen::Matrix3d::Identity();  // columns: directions of the prismatic joints
    Eigen::Vector3d tip_at_zero_ = Eigen::Vector3d::Zero();
    Eigen::Matrix3d rotation_at_zero_ = Eigen::Matrix3d::Identity();
    Eigen::Vector3d first_axis_ = Eigen::Vector3d::UnitZ();  // of the revolute joints at zero, in the world
    Eigen::Vector3d second_axis_ = Eigen::Vector3d::UnitY();
};

}  // namespace gsim::kinematics
