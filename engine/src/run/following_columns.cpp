#include "engine/src/run/following_columns.h"

#include <limits>
#include <utility>

#include "base/units.h"

namespace gsim::engine {

namespace {

class FollowingOut : public simulation::RunOutput {
  public:
    FollowingOut(TakeFollowing take, const simulation::FollowingSetup& setup)
        : take_(std::move(take)), machine_(setup.machine), motion_(setup) {}

    using simulation::RunOutput::take;
    void begin(const rrs::JointPos& start) override { motion_.begin(start); }
    void take(const motion::Segment& segment, const simulation::MoveInfo& info) override {
        const auto put = [this](double, double to_s) { this->put(to_s); };
        motion_.enter(segment, info, put);
        line_ = info.place.line;
        motion_.leave(put);
    }
    void end(double end_s) override {
        motion_.go_to(end_s, [this](double, double to_s) { put(to_s); });
        hand_out();
    }

  private:
    void put(double t_s) {
        const simulation::FollowingInstant instant = motion_.at(t_s);
        columns_.t_s.push_back(t_s);
        columns_.line.push_back(line_);
        columns_.contour_mm.push_back(
            static_cast<float>(instant.contour_mm.value_or(std::numeric_limits<double>::quiet_NaN())));
        for (const double coordinate : instant.tip_mm)
            columns_.tip_mm.push_back(static_cast<float>(coordinate));
        for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
            const double error = instant.errors[static_cast<Eigen::Index>(i)];
            const bool linear = machine_.axes[i].kind == machine::AxisKind::linear;
            columns_.errors.push_back(static_cast<float>(linear ? error : error * kDegPerRad));
        }
        if (columns_.t_s.size() >= kColumnChunk) hand_out();
    }

    void hand_out() {
        if (columns_.t_s.empty()) return;
        take_(columns_);
        columns_ = {};
    }

    TakeFollowing take_;
    const machine::Machine& machine_;
    simulation::FollowingMotion motion_;
    std::uint32_t line_ = 0;
    FollowingColumns columns_;
};

}  // namespace

std::unique_ptr<simulation::RunOutput> hand_out_following(TakeFollowing take,
                                                          const simulation::FollowingSetup& setup) {
    return std::make_unique<FollowingOut>(std::move(take), setup);
}

}  // namespace gsim::engine
