#include "tests/cam/solid/wheel_path.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include "base/text/json.h"
#include "base/units.h"

namespace gsim::solid::models {

namespace {

using Pair = std::array<double, 2>;

Pair place_of(const nlohmann::json& target, const char* key) {
    return {target.at(key).at(0).get<double>() - kWheelMiddle_mm[0],
            target.at(key).at(1).get<double>() - kWheelMiddle_mm[1]};
}

// Returns B turned by full turns, or with C in the other direction, so that it is as near as possible.
Pair nearest(const Pair& from, Pair to) {
    if (from[1] * to[1] < 0) to = {to[0] + 180, -to[1]};
    return {from[0] + std::remainder(to[0] - from[0], 360), to[1]};
}

void make_arc(const Pair& via, WheelStep& step) {
    const Pair a{via[0] - step.begin_mm[0], via[1] - step.begin_mm[1]};
    const Pair b{step.end_mm[0] - step.begin_mm[0], step.end_mm[1] - step.begin_mm[1]};
    const double cross = 2 * (a[0] * b[1] - a[1] * b[0]);
    const double a2 = a[0] * a[0] + a[1] * a[1];
    const double b2 = b[0] * b[0] + b[1] * b[1];
    const Pair center{step.begin_mm[0] + (b[1] * a2 - a[1] * b2) / cross,
                      step.begin_mm[1] + (a[0] * b2 - b[0] * a2) / cross};
    const auto angle = [&](const Pair& position) {
        return std::atan2(position[1] - center[1], position[0] - center[0]);
    };
    double sweep = std::fmod(angle(step.end_mm) - angle(step.begin_mm) + 2 * kTurn_rad, kTurn_rad);
    if (cross < 0) sweep -= kTurn_rad;
    step.center_mm = center;
    step.sweep_rad = sweep;
}

}  // namespace

Pair WheelStep::at(double share) const {
    if (!center_mm) {
        return {begin_mm[0] + share * (end_mm[0] - begin_mm[0]),
                begin_mm[1] + share * (end_mm[1] - begin_mm[1])};
    }
    const double x = begin_mm[0] - (*center_mm)[0];
    const double y = begin_mm[1] - (*center_mm)[1];
    const double turn = share * sweep_rad;
    return {(*center_mm)[0] + x * std::cos(turn) - y * std::sin(turn),
            (*center_mm)[1] + x * std::sin(turn) + y * std::cos(turn)};
}

std::array<double, 3> WheelStep::axis(double share) const {
    const double turn = (begin_deg[0] + share * (end_deg[0] - begin_deg[0])) * kRadPerDeg;
    const double tilt = (begin_deg[1] + share * (end_deg[1] - begin_deg[1])) * kRadPerDeg;
    return {std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt)};
}

double WheelStep::distance_mm(const Pair& position) const {
    if (center_mm) {
        const double radius = std::hypot(begin_mm[0] - (*center_mm)[0], begin_mm[1] - (*center_mm)[1]);
        const double from = std::atan2(begin_mm[1] - (*center_mm)[1], begin_mm[0] - (*center_mm)[0]);
        const double to = std::atan2(position[1] - (*center_mm)[1], position[0] - (*center_mm)[0]);
        double turn = std::fmod((to - from) * (sweep_rad < 0 ? -1 : 1) + 2 * kTurn_rad, kTurn_rad);
        if (turn <= std::abs(sweep_rad))
            return std::abs(std::hypot(position[0] - (*center_mm)[0], position[1] - (*center_mm)[1]) -
                            radius);
        return std::min(std::hypot(position[0] - begin_mm[0], position[1] - begin_mm[1]),
                        std::hypot(position[0] - end_mm[0], position[1] - end_mm[1]));
    }
    const double x = end_mm[0] - begin_mm[0];
    const double y = end_mm[1] - begin_mm[1];
    const double share = std::clamp(
        ((position[0] - begin_mm[0]) * x + (position[1] - begin_mm[1]) * y) / (x * x + y * y), 0.0, 1.0);
    return std::hypot(position[0] - begin_mm[0] - share * x, position[1] - begin_mm[1] - share * y);
}

std::vector<std::vector<WheelStep>> wheel_pockets(const std::filesystem::path& path_file) {
    std::ifstream path_text(path_file);
    const nlohmann::json document = text::parse_json<nlohmann::json>(path_text);
    std::vector<std::vector<WheelStep>> pockets;
    for (const auto& path : document.at("paths")) {
        if (path.at("name") != "pockets") continue;
        nlohmann::json last;
        for (const auto& target : path.at("targets")) {
            const auto actions = target.value("actions", std::vector<std::string>{});
            if (!actions.empty() && actions.front() == "waterjet_on") {
                pockets.emplace_back();
            } else {
                WheelStep step;
                step.begin_mm = place_of(last, "position_mm");
                step.end_mm = place_of(target, "position_mm");
                step.begin_deg = {last["rotary_deg"]["B"], last["rotary_deg"]["C"]};
                step.end_deg =
                    nearest(step.begin_deg, {target["rotary_deg"]["B"], target["rotary_deg"]["C"]});
                if (target.contains("via_mm")) make_arc(place_of(target, "via_mm"), step);
                pockets.back().push_back(step);
            }
            last = target;
        }
    }
    return pockets;
}

}  // namespace gsim::solid::models
