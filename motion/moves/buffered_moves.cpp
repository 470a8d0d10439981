#include "motion/moves/buffered_moves.h"

#include <utility>

#include "motion/klipper/klipper_model.h"
#include "motion/linuxcnc/linuxcnc_model.h"
#include "motion/lookahead/block.h"
#include "motion/lookahead/look_ahead.h"
#include "motion/path/master_path.h"

namespace gsim::motion {

namespace {

constexpr double kRelativeTolerance = 1e-9;  // relative

std::unique_ptr<MotionModel> make_model(const PlannerSetup& setup, SegmentOutput& output) {
    switch (setup.controller.planner) {
        case rrs::PlannerKind::look_ahead: return std::make_unique<LookAhead>(setup, output);
        case rrs::PlannerKind::linuxcnc:
            return std::make_unique<LinuxcncModel>(setup, setup.controller, output);
        case rrs::PlannerKind::klipper: return std::make_unique<KlipperModel>(setup, output);
        case rrs::PlannerKind::rest_to_rest: break;
    }
    return nullptr;
}

/// A model takes moves before it can report their times. This is the minimum time of the move by the
/// machine's speeds. It is 0 if the program requests no time, or if the controller uses the time of an arc
/// differently.
double min_time_s(const PathMove& move, const PlannerSetup& setup) {
    const bool is_per_chord =
        move.kind == SegmentKind::circular && setup.controller.curves.inverse_time_per_chord;
    if (move.rules.min_duration_s <= 0 || is_per_chord) return 0;
    const auto block = make_block(move, setup);
    if (!block || !*block) return 0;
    return (*block)->master.length / (*block)->max_speed * (1 - kRelativeTolerance);
}

}  // namespace

BufferedMoves::BufferedMoves(const ActiveMachine& machine, const TrackedFrame& tracked_frame,
                             PathBuilder& paths, Timeline& timeline, RobotPosition& position)
    : machine_(machine),
      tracked_frame_(tracked_frame),
      paths_(paths),
      timeline_(timeline),
      position_(position),
      model_(make_model(machine.setup(), timeline)) {}

EnqueueResult BufferedMoves::enqueue(const Move& move) {
    const auto path = paths_.build(move);
    if (!path) return tl::unexpected(path.error());
    const PathMove& path_move = **path;
    // The target is pending before the model outputs its motion.
    const bool is_pending = timeline_.pending().enqueue(path_move.target_id);
    if (path_sink_ != nullptr) path_sink_->on_programmed_move(path_move);
    if (PlanResult planned = model_->add(path_move); !planned) {
        if (is_pending) timeline_.pending().discard_last_move();
        if (path_sink_ != nullptr) path_sink_->discard_last_move();
        return tl::unexpected(std::move(planned.error()));
    }
    position_.move_to(path_move.end);
    if (move.move_parameters.motion_time_s <= 0) return {};
    return find_raised_time(min_time_s(path_move, machine_.setup()), move.move_parameters.motion_time_s,
                            true);
}

void BufferedMoves::plan_to_standstill() {
    if (!model_) return;
    model_->plan_to_standstill();
    timeline_.mark_pending_reached();
}

void BufferedMoves::leave() {
    if (!model_) return;
    plan_to_standstill();
    position_.move_to(standstill_position());
    model_->clear();
}

rrs::JointPos BufferedMoves::standstill_position() const {
    return accepts_moves() ? model_->end_position_of(position_.joints()) : position_.joints();
}

void BufferedMoves::clear() {
    if (model_) model_->clear();
}

void BufferedMoves::drop() {
    clear();
    if (path_sink_ != nullptr) path_sink_->forget();
}

}  // namespace gsim::motion
