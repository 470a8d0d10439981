#include "runtime/monitors/early_braking_monitor.h"

#include <fmt/format.h>

namespace gsim::simulation {

void EarlyBrakingMonitor::on_segment(const motion::Segment& segment, const MoveInfo& info) {
    if (segment.limited_by.kind != motion::LimitKind::short_brakes) return;
    ++count_;
    crawl_time_s_ += segment.duration_s;
    if (segment.duration_s <= longest_s_) return;
    longest_s_ = segment.duration_s;
    longest_mm_ = segment.master.length();
    longest_location_ = info.location;
}

std::optional<std::string> EarlyBrakingMonitor::warning(const std::vector<std::string>& files) const {
    if (count_ == 0) return std::nullopt;
    const std::string where = longest_location_.line > 0 ? fmt::format("{}:{}", files[longest_location_.file],
                                                                       longest_location_.line)
                                                         : "a script";
    return fmt::format(
        "the stepped ramps of the controller brake before the ends of {} block{}, and the machine crawls "
        "there for {:.3f} s in total, at worst {:.3f} mm in {:.3f} s in {}",
        count_, count_ == 1 ? "" : "s", crawl_time_s_, longest_mm_, longest_s_, where);
}

}  // namespace gsim::simulation
