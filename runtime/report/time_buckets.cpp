#include "runtime/report/time_buckets.h"

#include <algorithm>
#include <utility>

namespace gsim::simulation {

void TimeBuckets::add(const TimePoint& point) {
    while (point.t_s >= width_s_ * static_cast<double>(kMaxBuckets)) halve();
    const auto index = static_cast<std::size_t>(std::max(0.0, point.t_s) / width_s_);
    if (buckets_.size() <= index) buckets_.resize(index + 1);
    merge(buckets_[index][static_cast<std::size_t>(point.style)], {point, count_++});
}

void TimeBuckets::merge(std::optional<Extremes>& into, const NumberedPoint& sample) {
    if (!into) into = {sample, sample};
    if (sample.point.value < into->low.point.value) into->low = sample;
    if (sample.point.value > into->high.point.value) into->high = sample;
}

void TimeBuckets::halve() {
    width_s_ *= 2;
    for (std::size_t i = 1; i < buckets_.size(); ++i) {
        for (std::size_t style = 0; style < buckets_[i].size(); ++style) {
            std::optional<Extremes>& into = buckets_[i / 2][style];
            const std::optional<Extremes> from = std::exchange(buckets_[i][style], std::nullopt);
            if (!from) continue;
            merge(into, from->low);
            merge(into, from->high);
        }
    }
    buckets_.resize((buckets_.size() + 1) / 2);
}

std::vector<TimePoint> TimeBuckets::points() const {
    std::vector<NumberedPoint> samples;
    for (const Bucket& bucket : buckets_) {
        for (const std::optional<Extremes>& extremes : bucket) {
            if (!extremes) continue;
            samples.push_back(extremes->low);
            if (extremes->high.number != extremes->low.number) samples.push_back(extremes->high);
        }
    }
    std::sort(samples.begin(), samples.end(),
              [](const NumberedPoint& a, const NumberedPoint& b) { return a.number < b.number; });
    std::vector<TimePoint> points;
    points.reserve(samples.size());
    for (const NumberedPoint& sample : samples) points.push_back(sample.point);
    return points;
}

}  // namespace gsim::simulation
