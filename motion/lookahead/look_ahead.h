#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "motion/lookahead/block.h"
#include "motion/lookahead/corner.h"
#include "motion/lookahead/preceding_blocks.h"
#include "motion/planner/motion_model.h"
#include "motion/profile/following_error.h"
#include "motion/profile/stepped_ramps.h"

namespace gsim::motion {

/// Controller that knows some blocks ahead and passes corners by a rule: at a speed that it sets, exactly on
/// the path, or by blends, which cut the ends of blocks off (blend.h).
///
/// The window holds look_ahead_blocks blocks, the active one included, and as many sub-segments of tool moves
/// (ToolSubSegment) as these have, up to a bound. The newest is planned to stop at its end. A block's entry
/// speed, from there back, is what its corner allows and what its length lets slow down from. (It is planned
/// if an entry is requested that further blocks can still raise.) The oldest block becomes final when the
/// window is full: its exit speed is the next one's entry speed, and its law the fastest one between the two
/// (TimeLaw::between). The acceleration is 0 at the ends of blocks with jerk limits.
///
/// An override change by the operator cuts the active block at that instant. The remainder continues as a
/// separate block, and all speeds of the window are planned again. Corners keep the path that they were
/// given, unless they may now be passed faster. The change waits for an instant without acceleration with
/// jerk limits.
///
/// An override acts from the next block on if ramps run in steps of time (SteppedRamps).
///
/// The length that a blend may still cut off the newest block does not count as braking distance. So a corner
/// that becomes known never makes final speeds infeasible.
class LookAhead final : public MotionModel {
  public:
    /// Both must outlive this.
    LookAhead(const PlannerSetup& setup, SegmentOutput& output)
        : setup_(setup),
          output_(setup.controller.position_loop, output),
          stepped_ramps_(setup.controller.ramps.step_s) {}

    PlanResult add(const PathMove& move) override;
    void plan_to_standstill() override;
    void clear() override;
    rrs::JointPos end_position_of(const rrs::JointPos& position) const override;

  private:
    PlanResult add_line(const PathMove& move);
    PlanResult add_block(const PathMove& move);
    void join(std::size_t count, Block& to);
    bool is_window_full() const;
    void plan_backward(double reserved_length);
    void emit_front_block();
    // Operator overrides (look_ahead_overrides.cpp).
    bool handle_override_change();
    void update_overrides(double now_s);
    void update_limits(Block& block) const;
    bool is_on_hold() const;
    double min_exit_speed() const;
    TimeLaw front_law(double exit_speed) const;
    void emit_part(const TimeLaw& law, double t_s);
    void emit_hold(double now_s);
    void rejoin_corners(const std::vector<double>& speed_caps);
    void replan();
    void emit_path(const Block& block, double exit_speed, bool reaches_target);
    // Ramps in steps of time (look_ahead_steps.cpp).
    void emit_steps(const Block& block, double exit_speed, bool reaches_target);
    void emit_sections(const Block& block, const TimeLaw& law, double from, LimitCause limited_by,
                       bool reaches_target);
    void emit_dwell(rrs::TargetId id, const rrs::JointPos& end, double settle_s);
    CornerSpeed limited_corner_speed(const PrecedingBlocks& before, Block& to);
    void drop_slow_blend();
    void shrink_blend(double speed);
    void mark_target_reached(const PathMove& move);
    bool is_exit_known() const;
    double front_exit_speed() const;
    double reachable_exit_speed() const;
    double settle_s(const Block& block) const;
    LimitCause blend_limited_by(const Block& from, const Block& to, double speed) const;
    LimitCause limited_by(const Block& block, const TimeLaw& law, double exit_speed) const;

    const PlannerSetup& setup_;
    FollowingError output_;
    SteppedRamps stepped_ramps_;
    std::deque<Block> window_;
    std::size_t planned_count_ = 0;  ///< Blocks of the window with planned entries, from the oldest on.
    std::size_t inner_count_ =
        0;                    ///< Sub-segments in it that only continue their move: they count as no blocks.
    Overrides overrides_;     ///< That the window is planned for,
    double overrides_s_ = 0;  ///< and the instant from which on they hold.
    bool is_ending_ = false;  ///< No block follows the newest one.
    double speed_ = 0;        ///< At the start of the oldest block, which cannot change any more.
    rrs::JointPos rounded_end_;  ///< End of the last block, on the grid of the joint steps.
    bool has_rounded_end_ = false;
};

}  // namespace gsim::motion
