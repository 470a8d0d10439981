#include "engine/src/run/following_columns.h"

#include <limits>
#include <utility>

#include "base/units.h"

namespace gsim::engine {

namespace {

class FollowingOutput : public simulation::RunOutput {
  public:
    FollowingOutput(FollowingHandler on_segment, const simulation::FollowingSetup& setup)
        : handler_(std::move(on_segment)), machine_(setup.machine), motion_(setup) {}

    void begin(const rrs::JointPos& start) override { motion_.begin(start); }
    void on_segment(const motion::Segment& segment, const simulation::MoveInfo& info) override {
        const auto append = [this](double, double to_s) { this->append(to_s); };
        motion_.enter(segment, info, append);
        line_ = info.location.line;
        motion_.leave(append);
    }
    void end(double end_s) override {
        motion_.go_to(end_s, [this](double, double to_s) { append(to_s); });
        deliver();
    }

  private:
    void append(double t_s) {
        const simulation::FollowingInstant instant = motion_.at(t_s);
        columns_.t_s.push_back(t_s);
        columns_.line.push_back(line_);
        columns_.contour_error_mm.push_back(
            static_cast<float>(instant.contour_error_mm.value_or(std::numeric_limits<double>::quiet_NaN())));
        for (const double coordinate : instant.tcp_mm)
            columns_.tcp_mm.push_back(static_cast<float>(coordinate));
        for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
            const double error = instant.errors[static_cast<Eigen::Index>(i)];
            const bool linear = machine_.axes[i].kind == machine::AxisKind::linear;
            columns_.errors.push_back(static_cast<float>(linear ? error : error * kDegPerRad));
        }
        if (columns_.t_s.size() >= kColumnChunk) deliver();
    }

    void deliver() {
        if (columns_.t_s.empty()) return;
        handler_(columns_);
        columns_ = {};
    }

    FollowingHandler handler_;
    const machine::Machine& machine_;
    simulation::FollowingMotion motion_;
    std::uint32_t line_ = 0;
    FollowingColumns columns_;
};

}  // namespace

std::unique_ptr<simulation::RunOutput> make_following_output(FollowingHandler on_segment,
                                                             const simulation::FollowingSetup& setup) {
    return std::make_unique<FollowingOutput>(std::move(on_segment), setup);
}

}  // namespace gsim::engine
