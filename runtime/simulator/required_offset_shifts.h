#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "runtime/report/report.h"

namespace gsim::simulation {

/// Shift of each work offset along each linear axis that would bring back its positions past ends of ranges,
/// and out of zones to stay in.
class RequiredOffsetShifts {
  public:
    void add(const Violation& violation);
    /// Returns the shifts in integer micrometres, rounded up. Empty if no shift helps: both ends are passed,
    /// a rotary axis, a zone that is forbidden, no work offset.
    std::vector<OffsetShift> shifts() const;

  private:
    struct RequiredShift {
        double up_mm = 0;
        double down_mm = 0;
    };

    std::map<std::pair<std::string, char>, RequiredShift> required_shifts_;  ///< By offset and axis.
    bool is_unfixable_ = false;
};

}  // namespace gsim::simulation
