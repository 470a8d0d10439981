#include "studio/engine/run_series.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include "engine/columns.h"
#include "studio/engine/message.h"

namespace gsim::studio {

namespace {

using Json = nlohmann::ordered_json;

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

Json channel(const char* of) {
    return {{"of", of}};
}

Json channel(const char* of, std::size_t axis) {
    return {{"of", of}, {"axis", axis}};
}

/// Returns axes with a motor that delivers less at some speeds than at others.
std::vector<std::size_t> axes_with_speed_dependent_motors(const Json& axes) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (axes[i].at("motor_fades").get<bool>()) found.push_back(i);
    }
    return found;
}

std::span<const float> row(const std::vector<float>& all, std::size_t width, std::size_t at) {
    return std::span(all).subspan(at * width, width);
}

/// Returns the share of a motor's peak effort; without a peak it is not reported.
float share(float effort, float peak) {
    return peak > 0 ? effort / peak : kUnknown;
}

}  // namespace

Series& RunSeries::add(const char* is, std::size_t robot, const Json& channels) {
    entries_.push_back(
        {.header = {{"robot", robot}, {"channels", channels}}, .is = is, .series = Series(channels.size())});
    return entries_.back().series;
}

void RunSeries::add_run(engine::Run& run, std::size_t robot, const Json& scene) {
    on_efforts(run, robot, scene.at("axes"));
    on_following(run, robot, scene.at("axes"));
}

void RunSeries::on_efforts(engine::Run& run, std::size_t robot, const Json& axes) {
    const std::size_t count = axes.size();
    const std::vector<std::size_t> speed_dependent_axes = axes_with_speed_dependent_motors(axes);
    Json channels = Json::array({channel("power")});
    for (std::size_t i = 0; i < count; ++i) channels.push_back(channel("effort", i));
    for (const std::size_t axis : speed_dependent_axes) channels.push_back(channel("motor_peak", axis));
    for (const std::size_t axis : speed_dependent_axes) channels.push_back(channel("share", axis));
    Series& series = add("efforts", robot, channels);
    std::vector<float> values;
    const auto add_run = [&series, speed_dependent_axes, count,
                          values](const engine::EffortColumns& columns) mutable {
        for (std::size_t i = 0; i < columns.t_s.size(); ++i) {
            const auto efforts = row(columns.efforts, count, i);
            const auto peaks = row(columns.motor_peaks, count, i);
            values.assign({columns.power_w[i]});
            values.insert(values.end(), efforts.begin(), efforts.end());
            for (const std::size_t axis : speed_dependent_axes) values.push_back(peaks[axis]);
            for (const std::size_t axis : speed_dependent_axes)
                values.push_back(share(efforts[axis], peaks[axis]));
            series.add(columns.t_s[i], values);
        }
    };
    if (!run.on_efforts(add_run, robot)) entries_.pop_back();  // no masses are known
}

void RunSeries::on_following(engine::Run& run, std::size_t robot, const Json& axes) {
    const std::size_t count = axes.size();
    Json channels = Json::array({channel("contour")});
    for (std::size_t i = 0; i < count; ++i) channels.push_back(channel("error", i));
    Series& series = add("following", robot, channels);
    std::vector<float> values;
    const auto add_run = [&series, count, values](const engine::FollowingColumns& columns) mutable {
        for (std::size_t i = 0; i < columns.t_s.size(); ++i) {
            const auto errors = row(columns.errors, count, i);
            values.assign({columns.contour_error_mm[i]});
            values.insert(values.end(), errors.begin(), errors.end());
            series.add(columns.t_s[i], values);
        }
    };
    if (!run.on_following(add_run, robot)) entries_.pop_back();  // no servo loops are known
}

void RunSeries::post(const Post& post) const {
    for (const Entry& entry : entries_) {
        if (entry.series.empty()) continue;
        Message message(entry.is);
        message.header().update(entry.header);
        entry.series.add_columns(message);
        post(message.bytes());
    }
}

}  // namespace gsim::studio
