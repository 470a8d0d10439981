#pragma once

#include <array>
#include <string>

#include "runtime/machine/machine.h"
#include "runtime/simulation/path_thinner.h"
#include "runtime/simulation/run_output.h"
#include "runtime/simulation/speed_buckets.h"

namespace gsim::simulation {

/// Gathers what make_plot() draws, in bounded memory: the path seen from above, that is the machine's X and Y
/// (its first two axes where it has no such letters), and the speed of the tool over time.
class PlotData : public RunOutput {
  public:
    explicit PlotData(const machine::Machine& machine);

    using RunOutput::take;
    void begin(const rrs::JointPos& start) override;
    void take(const motion::Segment& segment, const MoveInfo& info) override;

    std::vector<PathPoint> path() const { return path_.points(); }
    std::vector<SpeedPoint> speed() const { return speed_.points(); }
    /// Labels of the two path axes, such as "X (mm)".
    const std::array<std::string, 2>& labels() const { return labels_; }

  private:
    Eigen::Vector2d seen_from_above(const rrs::JointPos& joints) const;
    void add_path(const motion::Segment& segment, PathStyle style);
    void add_speed(const motion::Segment& segment, bool jet_on);

    const machine::Machine& machine_;
    std::array<std::size_t, 2> axes_{0, 0};
    std::array<std::string, 2> labels_;
    PathThinner path_;
    SpeedBuckets speed_;
};

}  // namespace gsim::simulation
