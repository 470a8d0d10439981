#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "motion/dynamics/servo_motion.h"
#include "runtime/monitors/following_setup.h"
#include "runtime/monitors/part_tip.h"
#include "runtime/monitors/program_way.h"
#include "runtime/monitors/set_point_way.h"
#include "runtime/simulator/move.h"

namespace gsim::simulation {

/// Whether an axis of the machine tells of its servo loop: then following errors are worked out of all.
bool has_servos(const machine::Machine& machine);
/// The loops of its joints: gains that axes do not tell are the controller's, and an axis without either
/// follows at once.
std::vector<dynamics::ServoLoop> servo_loops(const machine::Machine& machine);

/// An instant of the real motion.
struct FollowingInstant {
    double t_s = 0;
    rrs::JointPos errors;    ///< Set point less place, mm or rad.
    Eigen::Vector3d tip_mm;  ///< Where the tip really is on the part.
    /// How far that is from the way of its set points; none from a change of the tool, which turns about the
    /// part, until the axes are in their bands.
    std::optional<double> contour_mm;
    /// The same from the way that the program asks for, where that is known. It need not be where something
    /// else moves the axes at the same time (a belt, an axis group), and until they are in their bands behind
    /// that.
    std::optional<double> program_mm;
};

/// Follows the axes and the tip of a machine along its segments.
class FollowingMotion {
  public:
    /// Gets the start and the end of each step.
    using Look = std::function<void(double from_s, double to_s)>;

    explicit FollowingMotion(const FollowingSetup& setup, double step_s = dynamics::ServoMotion::kStep_s);

    /// Before all else: instants tell how far the tip is from this way, too. It outlives this.
    void follow_program(ProgramWay& program) { program_ = &program; }
    void begin(const rrs::JointPos& start);
    /// As of ServoMotion.
    void enter(const motion::Segment& segment, const MoveInfo& info, const Look& look = {});
    void go_to(double t_s, const Look& look = {});
    void leave(const Look& look = {});
    double now_s() const { return servos_.now_s(); }

    /// At an instant of the last three steps.
    FollowingInstant at(double t_s);
    rrs::JointPos errors(double t_s) const;
    /// Without what the tip does.
    bool in_bands(const rrs::JointPos& errors) const;
    /// After such a time whatever is left of an error is below 1e-8 of it.
    double longest_s() const { return memory_s_; }

  private:
    void take(const dynamics::SetPointStep& step, const Look& look);
    void enter_program(const motion::Segment& segment);
    std::optional<double> program_distance_mm(const FollowingInstant& instant);
    void change_tip(std::uint16_t tip);
    SetPointWay::End end_of(const motion::JointState& state, double duration_s) const;

    FollowingSetup setup_;
    dynamics::ServoMotion servos_;
    PartTip tip_;
    std::uint16_t tip_number_ = 0;
    double memory_s_ = 0;
    SetPointWay way_;
    ProgramWay* program_ = nullptr;
    bool program_settling_ = false;
    bool turning_ = false;      // the tip, in this segment
    bool lines_begun_ = false;  // the last piece of the way is a line of this segment
    bool settling_ = false;     // after a change of the tip
};

}  // namespace gsim::simulation
