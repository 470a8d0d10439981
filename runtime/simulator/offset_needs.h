#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "runtime/report/report.h"

namespace gsim::simulation {

/// By how much each work offset would have to be shifted along each linear axis, so that what it has taken
/// past ends of ranges, and out of zones to stay in, comes back.
class OffsetNeeds {
  public:
    void add(const Violation& violation);
    /// In whole micrometres, rounded up; nothing where no shift does it: both ends are passed, a rotary axis,
    /// a zone that is forbidden, no work offset.
    std::vector<OffsetShift> shifts() const;

  private:
    struct Need {
        double up_mm = 0;
        double down_mm = 0;
    };

    std::map<std::pair<std::string, char>, Need> needs_;  ///< By offset and axis.
    bool in_vain_ = false;
};

}  // namespace gsim::simulation
