#include "cam/linking/axis_steps.h"

#include <string_view>
#include <utility>

namespace gsim::linking {

namespace {

using path::AxisValues;
using path::TargetError;

constexpr double kChordTolerance_mm = 0.01;

path::Vector linear_origin(const Origin& origin) {
    path::Vector linear{};
    for (const auto& [letter, value] : origin) {
        if (letter >= 'X' && letter <= 'Z') linear[static_cast<std::size_t>(letter - 'X')] = value;
    }
    return linear;
}

class StepRecorder final : public path::MoveSink {
  public:
    StepRecorder(const path::AxisMoves& moves, AxisValues shift) : moves_(moves), shift_(std::move(shift)) {}

    tl::expected<void, TargetError> run(std::size_t path) { return moves_.run(path, *this); }
    std::vector<AxisStep> release() { return std::move(steps_); }
    const std::optional<TargetError>& error() const { return error_; }

    void begin(const path::TargetId& where) override { target_id_ = where; }
    void move(const path::AxisMove& move) override {
        steps_.push_back({target_id_, move.axes + shift_, move.rapid, process_on_});
    }
    void dwell(double /*seconds*/) override {}
    void acceleration(double /*mm_s2*/) override {}
    void action(const std::string& name) override {
        if (name == "waterjet_on") process_on_ = true;
        if (name == "waterjet_off") process_on_ = false;
    }
    void call(const path::SubPath& sub_path_call) override {
        for (int i = 0; i < sub_path_call.repeats && !error_; ++i) {
            if (auto result = run(sub_path_call.path); !result && !error_) error_ = result.error();
        }
    }
    void note(const path::TargetId& /*where*/, std::string_view /*sentence*/) override {}

  private:
    const path::AxisMoves& moves_;
    AxisValues shift_;
    path::TargetId target_id_;
    bool process_on_ = false;
    std::vector<AxisStep> steps_;
    std::optional<TargetError> error_;
};

}  // namespace

tl::expected<std::vector<AxisStep>, TargetError> axis_steps(const path::Program& program,
                                                            const path::MachineSpace& machine,
                                                            const Origin& origin) {
    const path::States states(program);
    const auto rotary_schedules = path::plan_rotary(program, machine, states, {});
    if (!rotary_schedules) return tl::unexpected(rotary_schedules.error());
    path::MoveOptions options;
    options.tolerance_mm = kChordTolerance_mm;
    options.arcs = false;
    options.frames_mm[""] = linear_origin(origin);
    const path::AxisMoves moves(program, machine, states, *rotary_schedules, options);
    StepRecorder steps(moves, axis_shift(origin, machine.machine()));
    if (auto result = steps.run(program.root); !result) return tl::unexpected(result.error());
    if (steps.error()) return tl::unexpected(*steps.error());
    return steps.release();
}

}  // namespace gsim::linking
