#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "collision/cell/cell.h"
#include "collision/pairs/candidate_pairs.h"

namespace gsim::cell {

/// Returns true if this body of a cell probes: it is on the tool, as a part of the machine or as an object.
bool is_probe(const Cell& cell, std::size_t item);

/// Search for the instants at which the probe of a machine begins to touch the bodies of its cell, and at
/// which it ceases to. The probe consists of the bodies for which probes() is true. They touch what they may
/// meet (candidate_pairs()). Without such bodies the probe is the tool tip: a point that touches everything
/// except what carries it. The jet is not felt.
class TouchSearch {
  public:
    /// Makes the search. `cell` and `machine`, for which it was read, must outlive this; its frames stay
    /// unchanged. `tcp_mm` is the tool tip in the frame of the tool centre point. The error is a message: a
    /// cell with independently moving frames allows no search.
    static Result<TouchSearch> make(const Cell& cell, const machine::Machine& machine,
                                    const Eigen::Vector3d& tcp_mm);

    /// Returns true if the probe touches something at these joint values, in mm and rad.
    bool touches(const rrs::JointPos& joints) const;
    /// Returns the time of the first contact in a segment, to 1e-9 s since its start.
    std::optional<double> first_touch_s(const motion::Segment& segment) const;
    /// Returns the time of the first release in a segment that starts in contact, to 1e-9 s since its start.
    /// A gap that the probe passes in less than 0.01 mm of its path may be missed.
    std::optional<double> first_release_s(const motion::Segment& segment) const;

  private:
    explicit TouchSearch(std::shared_ptr<const kinematics::Kinematics> kinematics)
        : kinematics_(std::move(kinematics)) {}
    void add_probe_point_pairs(const Cell& cell, const Eigen::Vector3d& tcp_mm);

    std::shared_ptr<const kinematics::Kinematics> kinematics_;
    std::shared_ptr<const Shape> probe_point_;
    std::vector<BodyPair> pairs_;
};

}  // namespace gsim::cell
