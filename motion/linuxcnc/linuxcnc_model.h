#pragma once

#include <optional>

#include "controller/services/controller_rules.h"
#include "motion/linuxcnc/axes.h"
#include "motion/linuxcnc/held_piece.h"
#include "motion/linuxcnc/join.h"
#include "motion/linuxcnc/merged_lines.h"
#include "motion/linuxcnc/pacer.h"
#include "motion/linuxcnc/writer.h"
#include "motion/planner/motion_model.h"
#include "motion/planner/planner_setup.h"

namespace gsim::motion {

/// The trajectory planner of LinuxCNC 2.9: straight ramps, tangent junctions passed at speed, corners rounded
/// by blend arcs or by starting the next move while the last one comes to rest, stops in whole servo periods.
/// It does what that controller does, which at blends takes single joints beyond their acceleration limits.
///
/// X, Y and Z are the position joints; moves of any other joint are passed by parabolic blends alone. Speeds
/// are set by the joints' limits and the programmed ones; a move's path_acceleration counts, too, where it is
/// finite. Lines that are merged into one have one segment, with the last one's target; a move that goes
/// nowhere has none. With a servo period of 0 times are not counted in periods, and the rules that need one
/// take 1 ms.
///
/// What the operator turns an override to is obeyed at once: the piece under way is cut there. Junctions keep
/// their speeds, which count with the highest feed override that the controller takes.
///
/// Held back are as many moves as the look-ahead is deep, and some more; the rest is put out.
class LinuxcncModel final : public MotionModel {
  public:
    /// All must outlive the model.
    LinuxcncModel(const PlannerSetup& setup, const rrs::ControllerRules& rules, SegmentOutput& output);
    LinuxcncModel(const LinuxcncModel&) = delete;
    LinuxcncModel& operator=(const LinuxcncModel&) = delete;

    Planned add(const PathMove& move) override;
    void come_to_rest() override;
    void clear() override;
    rrs::JointPos standing_at(const rrs::JointPos& position) const override;

  private:
    Planned add_whole(const PathMove& move);
    void merge(const PathMove& line);
    void end_merged();
    void take(linuxcnc::Piece piece);
    void push(const linuxcnc::Piece& piece);
    void put_out(bool ended);

    const PlannerSetup& setup_;
    linuxcnc::Axes axes_;
    linuxcnc::Clock clock_;
    linuxcnc::Planning planning_;
    linuxcnc::JoinRules join_rules_;
    linuxcnc::MergedLines merged_;
    SegmentOutput& output_;
    linuxcnc::PieceQueue queue_;
    linuxcnc::Pacer pacer_;
    linuxcnc::Writer writer_;
    std::optional<rrs::JointPos> left_out_;  ///< Where the moves since the last one made began.
};

}  // namespace gsim::motion
