#include "controller/module/rcs_values.h"

#include <algorithm>

namespace gsim::rrs {

static_assert(kMaxJoints == GSIM_RCS_MAX_JOINTS);

namespace {

using RowMatrix = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

}  // namespace

gsim_rcs_pose to_rcs(const CartPos& pose) {
    gsim_rcs_pose result;
    Eigen::Map<RowMatrix>(result.matrix) = pose.matrix();
    return result;
}

CartPos from_rcs(const gsim_rcs_pose& pose) {
    CartPos result;
    result.matrix() = Eigen::Map<const RowMatrix>(pose.matrix);
    return result;
}

gsim_rcs_joints to_rcs(const JointPos& joints) {
    gsim_rcs_joints result{};
    result.count = static_cast<std::int32_t>(joints.size());
    std::copy(joints.begin(), joints.end(), result.values);
    return result;
}

JointPos from_rcs(const gsim_rcs_joints& joints) {
    const bool is_valid = joints.count >= 0 && joints.count <= kMaxJoints;
    JointPos result(is_valid ? joints.count : 0);
    std::copy_n(joints.values, result.size(), result.begin());
    return result;
}

bool copy_text(std::string_view text, std::span<char> field) {
    const std::size_t size = std::min(text.size(), field.size() - 1);
    std::copy_n(text.begin(), size, field.begin());
    std::fill(field.begin() + static_cast<std::ptrdiff_t>(size), field.end(), '\0');
    return size == text.size() && text.find('\0') == std::string_view::npos;
}

}  // namespace gsim::rrs
