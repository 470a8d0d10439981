#include "collision/cell/carrier.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace gsim::cell {

rrs::CartPos Drift::at(double time_s) const {
    const double gone_s = time_s - from_s;
    rrs::CartPos now = pose;
    now.translation() += gone_s * velocity_mm_s;
    if (const double rate = spin_rad_s.norm(); rate > 0)
        now.linear() = Eigen::AngleAxisd(rate * gone_s, spin_rad_s / rate) * pose.linear();
    return now;
}

Drift drift_between(const rrs::CartPos& from, const rrs::CartPos& to, double from_s, double to_s) {
    const double duration_s = to_s - from_s;
    Drift drift{.from_s = from_s, .pose = from};
    if (!(duration_s > 0)) return drift;
    drift.velocity_mm_s = (to.translation() - from.translation()) / duration_s;
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(to.linear() * from.linear().transpose()));
    drift.spin_rad_s = turn.angle() / duration_s * turn.axis();
    return drift;
}

void Carrier::add(const Drift& drift) {
    while (drifts_.size() > 1 && drifts_.back().from_s >= drift.from_s) drifts_.pop_back();
    if (drifts_.back().from_s >= drift.from_s) drifts_.clear();
    drifts_.push_back(drift);
}

const Drift& Carrier::drift_at(double time_s) const {
    const auto behind = std::upper_bound(drifts_.begin(), drifts_.end(), time_s,
                                         [](double t, const Drift& drift) { return t < drift.from_s; });
    return behind == drifts_.begin() ? drifts_.front() : *(behind - 1);
}

std::optional<double> Carrier::next_change_s(double time_s) const {
    const auto behind = std::upper_bound(drifts_.begin(), drifts_.end(), time_s,
                                         [](double t, const Drift& drift) { return t < drift.from_s; });
    if (behind == drifts_.end()) return std::nullopt;
    return behind->from_s;
}

void Carrier::forget_before(double time_s) {
    while (drifts_.size() > 1 && drifts_[1].from_s <= time_s) drifts_.pop_front();
}

bool Drift::moves() const {
    return !velocity_mm_s.isZero(0) || !spin_rad_s.isZero(0);
}

rrs::CartPos Carrier::at(double time_s) const {
    return drift_at(time_s).at(time_s);
}

}  // namespace gsim::cell
