#include "toolpath/rotary/machine_approach.h"

namespace gsim::path {

namespace {

constexpr double kHeightTolerance_mm = 1e-6;

}  // namespace

MachineApproach plan_approach(const MachinePoint& point, std::optional<double> retract_mm) {
    const bool is_known = !point.axes.empty();
    std::map<char, double> across = point.axes;
    if (!is_known) across = {{'X', 0}, {'Y', 0}, {'Z', 0}};
    std::map<char, double> z;
    if (auto height = across.extract('Z')) z.insert(std::move(height));
    const bool z_first =
        !is_known || (!z.empty() && retract_mm && z.begin()->second >= *retract_mm - kHeightTolerance_mm);

    MachineApproach machine_path;
    machine_path.reference =
        point.kind == MachinePoint::Kind::reference ? point.number : 0;  // 0 if it has a name
    machine_path.retract_first = !z_first;
    for (auto* step : {z_first ? &z : &across, z_first ? &across : &z}) {
        if (!step->empty()) machine_path.steps.push_back(std::move(*step));
    }
    return machine_path;
}

}  // namespace gsim::path
