#include "controller/services/planner_capabilities.h"

#include <vector>

#include <fmt/format.h>

namespace gsim::rrs {

std::string planners_without(bool PlannerCapabilities::*capability) {
    std::vector<std::string> names;
    for (const PlannerCapabilities& planner : kPlannerCapabilities) {
        if (!(planner.*capability)) names.push_back(fmt::format("\"{}\"", planner.name));
    }
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) list += i + 1 == names.size() ? " and " : ", ";
        list += names[i];
    }
    return list;
}

}  // namespace gsim::rrs
