#pragma once

#include <array>
#include <string>

#include "runtime/machine/machine.h"
#include "runtime/simulation/path_thinner.h"
#include "runtime/simulation/run_output.h"
#include "runtime/simulation/time_buckets.h"

namespace gsim::simulation {

/// Gathers what make_plot() draws, in bounded memory: the path seen from above, that is the machine's X and Y
/// (its first two axes where it has no such letters), and the tool's speed, acceleration along its path and
/// programmed feed over time.
class PlotData : public RunOutput {
  public:
    explicit PlotData(const machine::Machine& machine);

    using RunOutput::take;
    void begin(const rrs::JointPos& start) override;
    void take(const motion::Segment& segment, const MoveInfo& info) override;

    std::vector<PathPoint> path() const { return path_.points(); }
    std::vector<TimePoint> speed() const { return speed_.points(); }
    std::vector<TimePoint> acceleration() const { return acceleration_.points(); }
    /// At the ends of moves for which a feed in mm/min is programmed, in mm/s.
    std::vector<TimePoint> feed() const { return feed_.points(); }
    /// The machine's limit of acceleration along the path, mm/s2; infinite where it has none.
    double max_acceleration_mm_s2() const { return machine_.path.max_acceleration_mm_s2; }
    /// Labels of the two path axes, such as "X (mm)".
    const std::array<std::string, 2>& labels() const { return labels_; }

  private:
    Eigen::Vector2d seen_from_above(const rrs::JointPos& joints) const;
    void add_path(const motion::Segment& segment, PathStyle style);
    void add_speed(const motion::Segment& segment, bool jet_on);
    void add_acceleration(const motion::Segment& segment, bool jet_on);
    void add_acceleration_of_two(const motion::Segment& segment, bool jet_on);
    void add_rest(const motion::Segment& segment, bool jet_on);
    void add_feed(const motion::Segment& segment, const MoveInfo& info);

    const machine::Machine& machine_;
    std::array<std::size_t, 2> axes_{0, 0};
    std::array<std::string, 2> labels_;
    PathThinner path_;
    TimeBuckets speed_;
    TimeBuckets acceleration_;
    TimeBuckets feed_;
};

}  // namespace gsim::simulation
