#include "toolpath/rotary/machine_way.h"

namespace gsim::path {

namespace {

constexpr double kSameHeight_mm = 1e-6;

}  // namespace

MachineWay way_to(const MachinePoint& point, std::optional<double> up_mm) {
    const bool is_known = !point.axes.empty();
    std::map<char, double> across = point.axes;
    if (!is_known) across = {{'X', 0}, {'Y', 0}, {'Z', 0}};
    std::map<char, double> z;
    if (auto height = across.extract('Z')) z.insert(std::move(height));
    const bool leads_up = !is_known || (!z.empty() && up_mm && z.begin()->second >= *up_mm - kSameHeight_mm);

    MachineWay way;
    way.reference = point.kind == MachinePoint::Kind::reference ? point.number : 0;  // 0 if it has a name
    way.from_above = !leads_up;
    for (auto* step : {leads_up ? &z : &across, leads_up ? &across : &z}) {
        if (!step->empty()) way.steps.push_back(std::move(*step));
    }
    return way;
}

}  // namespace gsim::path
