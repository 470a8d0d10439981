#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "motion/lookahead/block.h"
#include "motion/lookahead/blocks_before.h"
#include "motion/lookahead/corner.h"
#include "motion/planner/motion_model.h"
#include "motion/profile/following_error.h"
#include "motion/profile/stepped_ramps.h"

namespace gsim::motion {

/// Controller that knows some blocks ahead and passes corners by a rule: at a speed that it sets, exactly on
/// the path, or by blends, which cut the ends of blocks off (blend.h).
///
/// The window holds look_ahead_blocks blocks, the active one included, and as many sub-segments of tool moves
/// (ToolPiece) as these have, up to a bound. The newest is planned to stop at its end. A block's entry speed,
/// from there back, is what its corner allows and what its length lets slow down from. (It is planned if an
/// entry is requested that further blocks can still raise.) The oldest block becomes final when the window is
/// full: its exit speed is the next one's entry speed, and its law the fastest one between the two
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
        : setup_(setup), output_(setup.controller, output), stepped_(setup.controller.ramp_step_s) {}

    Planned add(const PathMove& move) override;
    void come_to_rest() override;
    void clear() override;
    rrs::JointPos standing_at(const rrs::JointPos& position) const override;

  private:
    Planned add_line(const PathMove& move);
    Planned add_block(const PathMove& move);
    void join(std::size_t count, Block& to);
    bool window_is_full() const;
    void plan_back(double held_back);
    void put_out_front();
    // Operator overrides (look_ahead_overrides.cpp).
    bool turn_overrides();
    void take_overrides(double now_s);
    void limit_again(Block& block) const;
    bool is_held() const;
    double least_exit() const;
    TimeLaw front_law(double exit_speed) const;
    void put_out_part(const TimeLaw& law, double t_s);
    void put_out_hold(double now_s);
    void join_faster(const std::vector<double>& most);
    void plan_anew();
    void put_out_way(const Block& block, double exit_speed, bool reaches_target);
    // Ramps in steps of time (look_ahead_steps.cpp).
    void put_out_steps(const Block& block, double exit_speed, bool reaches_target);
    void put_out_pieces(const Block& block, const TimeLaw& law, double from, LimitedBy limited_by,
                        bool reaches_target);
    void put_out_rest(rrs::TargetId id, const rrs::JointPos& end, double settle_s);
    CornerSpeed limited_corner(const BlocksBefore& before, Block& to);
    void drop_slow_blend();
    void fit_blend(double speed);
    void reach_with_last(const PathMove& move);
    bool knows_exit() const;
    double front_exit_speed() const;
    double reachable_exit() const;
    double settle_s(const Block& block) const;
    LimitedBy blend_limited_by(const Block& from, const Block& to, double speed) const;
    LimitedBy limited_by(const Block& block, const TimeLaw& law, double exit_speed) const;

    const PlannerSetup& setup_;
    FollowingError output_;
    SteppedRamps stepped_;
    std::deque<Block> window_;
    std::size_t planned_ = 0;  ///< Blocks of the window with planned entries, from the oldest on.
    std::size_t inner_ = 0;    ///< Sub-segments in it that only continue their move: they count as no blocks.
    Overrides overrides_;      ///< That the window is planned for,
    double overrides_s_ = 0;   ///< and the instant from which on they hold.
    bool ending_ = false;      ///< No block follows the newest one.
    double speed_ = 0;         ///< At the start of the oldest block, which cannot change any more.
    rrs::JointPos rounded_;    ///< End of the last block, on the grid of the joint steps.
    bool has_rounded_ = false;
};

}  // namespace gsim::motion
