#include "calibrate/times/passage_times.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gsim::calibrate {

namespace {

constexpr double kStationary_mm = 0.01;
constexpr double kTolerance_mm = 1;

/// Nearest approach of the straight line between two samples to a position.
struct NearestApproach {
    double t_s = 0;
    double distance_mm = std::numeric_limits<double>::infinity();
};

NearestApproach nearest_on_segment(const MotionSample& from, const MotionSample& to,
                                   const Eigen::Vector3d& position_mm) {
    const Eigen::Vector3d displacement = to.at_mm - from.at_mm;
    const double squared_length = displacement.squaredNorm();
    const double part =
        squared_length > 0 ? std::clamp(displacement.dot(position_mm - from.at_mm) / squared_length, 0.0, 1.0)
                           : 0;
    return {from.t_s + part * (to.t_s - from.t_s), (from.at_mm + part * displacement - position_mm).norm()};
}

}  // namespace

std::optional<TimeSpan> motion_span(std::span<const MotionSample> samples) {
    const auto away_from = [](const Eigen::Vector3d& position_mm) {
        return [position_mm](const MotionSample& sample) {
            return (sample.at_mm - position_mm).cwiseAbs().maxCoeff() > kStationary_mm;
        };
    };
    if (samples.empty()) return std::nullopt;
    const auto first = std::find_if(samples.begin(), samples.end(), away_from(samples.front().at_mm));
    if (first == samples.end()) return std::nullopt;
    const auto last = std::find_if(samples.rbegin(), samples.rend(), away_from(samples.back().at_mm));
    if (last == samples.rend()) return TimeSpan{std::prev(first)->t_s, samples.back().t_s};
    return TimeSpan{std::prev(first)->t_s, std::prev(last)->t_s};
}

// The search starts at the previous passage. It takes the first approach that is left again by more than the
// possible error.
std::vector<std::optional<double>> passage_times_s(std::span<const MotionSample> samples,
                                                   std::span<const Eigen::Vector3d> positions_mm) {
    std::vector<std::optional<double>> found;
    std::size_t from = 0;
    for (const Eigen::Vector3d& position_mm : positions_mm) {
        NearestApproach best;
        std::size_t at = from;
        for (std::size_t i = from; i + 1 < samples.size(); ++i) {
            const NearestApproach current = nearest_on_segment(samples[i], samples[i + 1], position_mm);
            if (current.distance_mm < best.distance_mm) {
                best = current;
                at = i;
            }
            if (best.distance_mm <= kTolerance_mm && current.distance_mm > best.distance_mm + kTolerance_mm)
                break;
        }
        if (best.distance_mm <= kTolerance_mm) {
            found.emplace_back(best.t_s);
            from = at;
        } else {
            found.emplace_back();
        }
    }
    return found;
}

}  // namespace gsim::calibrate
