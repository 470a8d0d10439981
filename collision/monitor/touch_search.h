#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "collision/cell/cell.h"
#include "collision/pairs/meeting_pairs.h"

namespace gsim::cell {

/// Whether this body of a cell probes: it is on the tool, as a part of the machine or as an object.
bool probes(const Cell& cell, std::size_t item);

/// When the probe of a machine begins to touch the bodies of its cell, and when it ceases to. The probe is
/// made of the bodies that probes() tells, which touch what they may meet (meeting_pairs()), or, where there
/// are none, of the tool's tip: a point, which touches all but what carries it. The jet is not felt.
class TouchSearch {
  public:
    /// `cell` and `machine`, for which it was read, must outlive this; its frames stay where they are.
    /// `tip_mm` is the tip in the frame of the tool centre point. The error is a sentence: in a cell some of
    /// whose frames go by themselves there is no search.
    static tl::expected<TouchSearch, std::string> make(const Cell& cell, const machine::Machine& machine,
                                                       const Eigen::Vector3d& tip_mm);

    /// Whether the probe touches something, for joint values in mm and rad.
    bool touches(const rrs::JointPos& joints) const;
    /// When it first touches something in a segment, to 1e-9 s since its start.
    std::optional<double> first_touch_s(const motion::Segment& segment) const;
    /// When it first touches nothing in a segment in which it touches something at the start, to 1e-9 s since
    /// then. A gap that it passes in less than 0.01 mm of its way may be missed.
    std::optional<double> first_release_s(const motion::Segment& segment) const;

  private:
    explicit TouchSearch(std::shared_ptr<const kinematics::Kinematics> kinematics)
        : kinematics_(std::move(kinematics)) {}
    void add_tip_pairs(const Cell& cell, const Eigen::Vector3d& tip_mm);

    std::shared_ptr<const kinematics::Kinematics> kinematics_;
    std::shared_ptr<const Shape> tip_;
    std::vector<BodyPair> pairs_;
};

}  // namespace gsim::cell
