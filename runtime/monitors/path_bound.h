#pragma once

#include <optional>

#include "machine/model/machine.h"
#include "motion/planner/time_bound.h"
#include "runtime/monitors/compensated_sum.h"
#include "runtime/outputs/run_output.h"

namespace gsim::simulation {

/// Min time that any controller could take over the path of a run, within the feeds of the program and the
/// limits of the machine (motion::TimeBound), and its dwells. It is not above the cycle time, whatever
/// controller made the motion:
/// - a limit that the motion did not keep counts as what it took;
/// - an arc on which a joint got more acceleration than it has is bounded by its length, not by its shape;
/// - joints that do not move in proportion to the path, and two motions at once, do not count.
class PathBound : public RunOutput {
  public:
    /// `machine` must outlive this.
    explicit PathBound(const machine::Machine& machine);

    void on_segment(const motion::Segment& segment, const MoveInfo& info) override;

    /// Returns the bound for the segments so far, as if the run ended here.
    double bound_s() const { return bound_.bound_s() + dwells_.value(); }

  private:
    /// Unit in which the length of a path is counted.
    enum class Measure {
        position,   ///< mm of the tool's path.
        secondary,  ///< mm of other linear joints.
        rotary,     ///< rad, the norm of the angles.
        direction,  ///< rad of the tool's direction along great circles.
        separate,   ///< For joint motion: a measure that no other move shares.
    };
    /// Path of a segment, run in one direction.
    struct SegmentPath {
        Measure measure;
        double length;
        rrs::JointPos q1;  ///< For the joints that move in proportion to it.
    };

    SegmentPath segment_path(const motion::Segment& segment) const;
    motion::PathCaps path_caps(const motion::Segment& segment, const MoveInfo& info,
                               const SegmentPath& path) const;
    void continue_measure(Measure measure);
    void standstill(const motion::Segment& segment, const MoveInfo& info);
    void add_line(const SegmentPath& path, motion::PathCaps caps, const motion::TimeLaw& law);
    void add_arc(const motion::Segment& segment, const SegmentPath& path, const motion::PathCaps& caps);
    bool is_within_limits(const motion::Segment& segment, const SegmentPath& path) const;

    const machine::Machine& machine_;
    motion::JointLimits limits_;
    motion::TimeBound bound_;
    CompensatedSum dwells_;
    bool at_standstill_ = true;
    std::optional<Measure> measure_;  // of the segment before; nullopt: its speed has no one measure
};

}  // namespace gsim::simulation
