#pragma once

#include <optional>

#include "controller/services/controller_rules.h"
#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/junction.h"
#include "motion/linuxcnc/merged_lines.h"
#include "motion/linuxcnc/queued_sub_segment.h"
#include "motion/linuxcnc/segment_writer.h"
#include "motion/linuxcnc/velocity_planner.h"
#include "motion/planner/motion_model.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// Trajectory planner of LinuxCNC 2.9: straight ramps, tangent junctions passed at speed, corners rounded by
/// blend arcs or by starting the next move while the last one stops, stops in full servo periods. It
/// reproduces that controller, which takes single joints beyond their acceleration limits at blends.
///
/// X, Y and Z are the position joints; moves of any other joint are passed only by parabolic blends. Speeds
/// are set by the limits of the joints and the programmed ones; a move's path_acceleration also counts if it
/// is finite. Merged lines have one segment, with the last one's target; a move without motion has none.
/// Times are not counted in periods if the servo period is 0, and the rules that need one use 1 ms.
///
/// Override changes by the operator are obeyed at once: the active sub-segment is cut there. Junctions keep
/// their speeds, which assume the highest feed override that the controller accepts.
///
/// The pending moves are as many as the look-ahead is deep, and some more; the remainder is output.
class LinuxcncModel final : public MotionModel {
  public:
    /// All must outlive the model.
    LinuxcncModel(const PlannerSetup& setup, const rrs::ControllerRules& rules, SegmentOutput& output);
    LinuxcncModel(const LinuxcncModel&) = delete;
    LinuxcncModel& operator=(const LinuxcncModel&) = delete;

    PlanResult add(const PathMove& move) override;
    void plan_to_standstill() override;
    void clear() override;
    rrs::JointPos end_position_of(const rrs::JointPos& position) const override;

  private:
    PlanResult add_complete(const PathMove& move);
    void merge(const PathMove& line);
    void finish_merged_line();
    void add_part(linuxcnc::SubSegment sub_segment);
    void push(const linuxcnc::SubSegment& sub_segment);
    void emit(bool ended);

    const PlannerSetup& setup_;
    linuxcnc::Axes axes_;
    linuxcnc::Clock clock_;
    linuxcnc::PlanningRules planning_;
    linuxcnc::JoinRules join_rules_;
    linuxcnc::MergedLines merged_;
    SegmentOutput& output_;
    linuxcnc::SubSegmentQueue queue_;
    linuxcnc::VelocityPlanner velocity_planner_;
    linuxcnc::Writer writer_;
    std::optional<rrs::JointPos> skipped_start_;  ///< Start of the moves since the last one made.
};

}  // namespace gsim::motion
