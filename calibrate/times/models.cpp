#include "calibrate/times/models.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace gsim::calibrate {

namespace {

using rrs::ControllerRules;
using rrs::CornerRule;
using rrs::PlannerKind;

constexpr std::size_t kTried = 2;  // of all candidates, by cross-validation
constexpr double kJerkOfAcceleration_1_s =
    20;  // where a machine has no jerk limit: its acceleration in 50 ms

/// Corners, by the name of their rule.
struct Corners {
    const char* name;
    CornerRule rule;
    bool rounded;
};

constexpr Corners kCorners[] = {{"velocity-step", CornerRule::velocity_step, false},
                                {"junction-deviation", CornerRule::junction_deviation, false},
                                {"smooth-blend", CornerRule::smooth_blend, true}};

/// The rules of a generic control; what a machine file says of words and offsets stays.
ControllerRules rules_of(const ControllerRules& machines, const Corners& corners) {
    ControllerRules rules = machines;
    rules.model = "exact-stop";
    rules.planner = PlannerKind::look_ahead;
    rules.look_ahead_blocks = 200;
    rules.corner = corners.rule;
    rules.exact_path_corner = corners.rounded ? CornerRule::velocity_step : corners.rule;
    rules.stop_between_rapid_and_feed = false;
    rules.centripetal_share = 0.866;
    rules.servo_period_s = 0;
    return rules;
}

void limit_jerk(machine::Machine& machine) {
    machine.controller.limit_jerk = true;
    for (machine::Axis& axis : machine.axes) {
        if (!std::isfinite(axis.max_jerk) && std::isfinite(axis.max_acceleration))
            axis.max_jerk = kJerkOfAcceleration_1_s * axis.max_acceleration;
    }
}

/// Places of the runs in a part of several, or of those outside it.
std::vector<std::size_t> places_of(std::size_t runs, std::size_t parts, std::size_t part, bool inside) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < runs; ++i) {
        if ((i % parts == part) == inside) places.push_back(i);
    }
    return places;
}

std::vector<RecordedRun> runs_at(std::span<const RecordedRun> runs, std::span<const std::size_t> places) {
    std::vector<RecordedRun> chosen;
    for (const std::size_t place : places) chosen.push_back(runs[place]);
    return chosen;
}

/// What a fit to the other parts says of one, in percent; the error says why it cannot be fitted.
tl::expected<std::vector<double>, std::string> foretell(const Candidate& candidate,
                                                        std::span<const RecordedRun> runs,
                                                        const Predictor& predictor, std::size_t parts,
                                                        std::size_t part, bool each_axis) {
    const auto others = places_of(runs.size(), parts, part, false);
    const auto places = places_of(runs.size(), parts, part, true);
    const auto fit = fit_times(candidate.machine, runs_at(runs, others), predictor.part(others), each_axis);
    if (!fit) return tl::unexpected(fit.error());
    const auto times = predictor.part(places).times_s(fit->machine);
    std::vector<double> errors;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const RecordedRun& run = runs[places[i]];
        if (!times[i]) return tl::unexpected(fmt::format("{}: {}", run.program, times[i].error()));
        errors.push_back(100 * std::abs(*times[i] - run.time_s) / run.time_s);
    }
    return errors;
}

/// How near a candidate comes to runs that it is fitted to.
Score fitted_score(const Candidate& candidate, std::span<const RecordedRun> runs, const Predictor& predictor,
                   bool each_axis) {
    Score score{candidate.name};
    const auto fit = fit_times(candidate.machine, runs, predictor, each_axis);
    if (!fit) {
        score.refused = fit.error();
        return score;
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
        score.fitted_percent += 100 * std::abs(fit->times_s[i] - runs[i].time_s) / runs[i].time_s /
                                static_cast<double>(runs.size());
    }
    return score;
}

void cross_validate(const Candidate& candidate, std::span<const RecordedRun> runs, const Predictor& predictor,
                    std::size_t parts, bool each_axis, Score& score) {
    double sum = 0;
    for (std::size_t part = 0; part < parts; ++part) {
        const auto errors = foretell(candidate, runs, predictor, parts, part, each_axis);
        if (!errors) {
            score.refused = errors.error();
            return;
        }
        for (const double error : *errors) {
            sum += error;
            score.largest_percent = std::max(score.largest_percent, error);
        }
    }
    score.foretells = true;
    score.mean_percent = sum / static_cast<double>(runs.size());
}

std::string words_on(const Score& score) {
    if (!score.refused.empty()) return fmt::format("{}: {}", score.name, score.refused);
    if (!score.foretells)
        return fmt::format("{}: fitted to {:.2f} % in the mean", score.name, score.fitted_percent);
    return fmt::format("{}: foretells to {:.2f} % in the mean, {:.2f} % at worst", score.name,
                       score.mean_percent, score.largest_percent);
}

/// Places of the scores that come nearest to the runs.
std::vector<std::size_t> nearest(const std::vector<Score>& scores, std::size_t most) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < scores.size(); ++i) {
        if (scores[i].refused.empty()) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return scores[a].fitted_percent < scores[b].fitted_percent;
    });
    order.resize(std::min(order.size(), most));
    return order;
}

}  // namespace

std::vector<Candidate> generic_candidates(const machine::Machine& machine) {
    std::vector<Candidate> candidates;
    const auto add = [&](const std::string& name, const ControllerRules& rules) {
        machine::Machine straight = machine;
        straight.controller = rules;
        straight.controller.limit_jerk = false;
        candidates.push_back({name + ", straight ramps", straight});
        limit_jerk(straight);
        candidates.push_back({name + ", limited jerk", std::move(straight)});
    };
    ControllerRules rests = machine.controller;
    rests.model = "exact-stop";
    rests.planner = PlannerKind::rest_to_rest;
    add("rest-to-rest", rests);
    for (const Corners& corners : kCorners) add(corners.name, rules_of(machine.controller, corners));
    return candidates;
}

tl::expected<Choice, std::string> choose_model(std::span<const Candidate> candidates,
                                               std::span<const RecordedRun> runs, const Predictor& predictor,
                                               std::size_t parts, bool each_axis,
                                               const std::function<void(const std::string&)>& told) {
    Choice choice;
    for (const Candidate& candidate : candidates) {
        choice.scores.push_back(fitted_score(candidate, runs, predictor, each_axis));
        if (told) told(words_on(choice.scores.back()));
    }
    std::optional<std::size_t> best;
    for (const std::size_t i : nearest(choice.scores, kTried)) {
        Score& score = choice.scores[i];
        cross_validate(candidates[i], runs, predictor, parts, each_axis, score);
        if (told) told(words_on(score));
        if (!score.foretells) continue;
        if (!best || score.mean_percent < choice.scores[*best].mean_percent) best = i;
    }
    if (!best)
        return tl::unexpected(choice.scores.empty() ? std::string("there is no model to choose from")
                                                    : choice.scores.front().refused);
    choice.best = *best;
    return choice;
}

}  // namespace gsim::calibrate
