#pragma once

#include <Eigen/Core>
#include <vector>

#include "motion/linuxcnc/axes.h"
#include "motion/planner/motion_model.h"

namespace gsim::motion::linuxcnc {

/// True if lines may be merged with this one: a feed move in continuous mode with a merge tolerance, straight
/// or an arc in the XY plane so flat that it counts as two lines.
bool may_merge(const PathMove& move);

/// Successive lines that one straight line replaces: their ends are within the merge tolerance of it.
class MergedLines {
  public:
    explicit MergedLines(const Axes& axes) : axes_(axes) {}

    bool empty() const { return ends_.empty(); }
    /// True if several lines are merged.
    bool several() const { return ends_.size() > 1; }
    /// True if the line, or flat arc, that follows may become part of this one.
    bool accepts(const PathMove& line) const;
    void add(const PathMove& line);
    /// Returns the merged line, with the target and the rules of the last one.
    const PathMove& line() const { return line_; }
    void clear() { ends_.clear(); }

  private:
    const Axes& axes_;
    std::vector<Eigen::Vector3d> ends_;
    PathMove line_;
};

/// Returns the line from `start` to the end of `move`, or to the middle of its arc.
PathMove line_to_end(const PathMove& move, const rrs::JointPos& start);
PathMove line_to_middle(const PathMove& move, const Axes& axes);

}  // namespace gsim::motion::linuxcnc
