#include "cam/linking/axis_way.h"

#include <string_view>
#include <utility>

namespace gsim::transit {

namespace {

using path::AxisValues;
using path::Fault;

constexpr double kChords_mm = 0.01;

path::Vector linear_of(const Origin& origin) {
    path::Vector linear{};
    for (const auto& [letter, value] : origin) {
        if (letter >= 'X' && letter <= 'Z') linear[static_cast<std::size_t>(letter - 'X')] = value;
    }
    return linear;
}

class Steps final : public path::MoveSink {
  public:
    Steps(const path::AxisMoves& moves, AxisValues shift) : moves_(moves), shift_(std::move(shift)) {}

    tl::expected<void, Fault> run(std::size_t path) { return moves_.run(path, *this); }
    std::vector<AxisStep> take() { return std::move(steps_); }
    const std::optional<Fault>& fault() const { return fault_; }

    void begin(const path::TargetId& where) override { where_ = where; }
    void move(const path::AxisMove& move) override {
        steps_.push_back({where_, move.axes + shift_, move.rapid, jet_on_});
    }
    void dwell(double /*seconds*/) override {}
    void acceleration(double /*mm_s2*/) override {}
    void action(const std::string& name) override {
        if (name == "waterjet_on") jet_on_ = true;
        if (name == "waterjet_off") jet_on_ = false;
    }
    void call(const path::SubPath& use) override {
        for (int i = 0; i < use.repeats && !fault_; ++i) {
            if (auto gone = run(use.path); !gone && !fault_) fault_ = gone.error();
        }
    }
    void note(const path::TargetId& /*where*/, std::string_view /*sentence*/) override {}

  private:
    const path::AxisMoves& moves_;
    AxisValues shift_;
    path::TargetId where_;
    bool jet_on_ = false;
    std::vector<AxisStep> steps_;
    std::optional<Fault> fault_;
};

}  // namespace

tl::expected<std::vector<AxisStep>, Fault> axis_way(const path::Program& program,
                                                    const path::MachineSpace& machine, const Origin& origin) {
    const path::States states(program);
    const auto turns = path::plan_rotary(program, machine, states, {});
    if (!turns) return tl::unexpected(turns.error());
    path::MoveOptions options;
    options.tolerance_mm = kChords_mm;
    options.arcs = false;
    options.frames_mm[""] = linear_of(origin);
    const path::AxisMoves moves(program, machine, states, *turns, options);
    Steps steps(moves, shift_of(origin, machine.machine()));
    if (auto gone = steps.run(program.root); !gone) return tl::unexpected(gone.error());
    if (steps.fault()) return tl::unexpected(*steps.fault());
    return steps.take();
}

}  // namespace gsim::transit
