#include "calibrate/times/models.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "machine/file/times_section.h"
#include "machine/model/machine_parameter.h"

namespace gsim::calibrate {

namespace {

using machine::Machine;
using rrs::ControllerRules;
using rrs::CornerRule;
using rrs::PlannerKind;

/// Default for a machine without a jerk limit: its acceleration in 50 ms.
constexpr double kJerkPerAcceleration_1_s = 20;
constexpr double kInitialShare = 0.75;    // of the acceleration
constexpr double kInitialBlock_s = 0.02;  // above the expected value: a limit without effect is not found
constexpr double kInitialWord_s = 0.5;
constexpr std::size_t kUnlimitedLookAhead = 1000;  // blocks

/// Corners with the name of their rule.
struct Corners {
    const char* name;
    CornerRule rule;
};

constexpr Corners kCorners[] = {{"velocity-step", CornerRule::velocity_step},
                                {"junction-deviation", CornerRule::junction_deviation},
                                {"parabolic-blend", CornerRule::parabolic_blend},
                                {"smooth-blend", CornerRule::smooth_blend}};

/// Returns the rules of a generic controller; settings of a machine file for words and offsets stay.
ControllerRules generic_rules(const ControllerRules& machines, const Corners& corners) {
    ControllerRules rules = machines;
    rules.model = "exact-stop";
    rules.planner = PlannerKind::look_ahead;
    rules.blocks.look_ahead = kUnlimitedLookAhead;
    rules.corners.continuous = corners.rule;
    rules.corners.exact_path = rrs::is_blend(corners.rule) ? CornerRule::velocity_step : corners.rule;
    rules.corners.stop_between_rapid_and_feed = false;
    rules.ramps.centripetal_share = 0.866;
    rules.position_loop.servo_period_s = 0;
    return rules;
}

/// Returns the rules of a controller that overlays the end of a move with the beginning of the next one: each
/// with a part of the acceleration, lines alone, and exactly by stops. These belong together, so refining one
/// at a time would not find them.
ControllerRules overlay_rules(const ControllerRules& machines) {
    ControllerRules rules = generic_rules(machines, {"", CornerRule::parabolic_blend});
    rules.corners.exact_path = CornerRule::stop;
    rules.corners.stop_between_rapid_and_feed = true;
    rules.ramps.continuous_acceleration_share = kInitialShare;
    return rules;
}

void limit_jerk(Machine& machine) {
    machine.controller.ramps.limit_jerk = true;
    for (machine::Axis& axis : machine.axes) {
        if (!std::isfinite(axis.max_jerk) && std::isfinite(axis.max_acceleration))
            axis.max_jerk = kJerkPerAcceleration_1_s * axis.max_acceleration;
    }
}

double max_axis_acceleration_mm_s2(const Machine& machine) {
    double max = 0;
    for (const machine::Axis& axis : machine.axes) {
        if (axis.kind == machine::AxisKind::linear && std::isfinite(axis.max_acceleration))
            max = std::max(max, axis.max_acceleration);
    }
    return max;
}

/// Collector of possible refinements of a candidate.
class Refiner {
  public:
    explicit Refiner(const Candidate& from) : base_(from) {}

    void add(const std::string& what, const std::function<void(Candidate&)>& change) {
        Candidate& refined = found_.emplace_back(base_);
        refined.name += ", " + what;
        change(refined);
    }
    std::vector<Candidate> release_candidates() { return std::move(found_); }

  private:
    const Candidate& base_;
    std::vector<Candidate> found_;
};

void refine_path(const Machine& machine, Refiner& refiner) {
    const double initial_mm_s2 = max_axis_acceleration_mm_s2(machine);
    if (std::isfinite(machine.path.max_acceleration_mm_s2)) return;
    refiner.add("an acceleration along the path",
                [&](Candidate& to) { to.machine.path.max_acceleration_mm_s2 = initial_mm_s2; });
    refiner.add("one along the path of rapids, too", [&](Candidate& to) {
        to.machine.path.max_acceleration_mm_s2 = initial_mm_s2;
        to.machine.path.max_rapid_acceleration_mm_s2 = initial_mm_s2;
    });
}

void refine_look_ahead(const ControllerRules& rules, Refiner& refiner) {
    if (rules.blocks.look_ahead != kUnlimitedLookAhead) return;
    for (const std::size_t blocks : {16U, 64U}) {
        refiner.add(fmt::format("{} blocks ahead", blocks),
                    [&](Candidate& to) { to.machine.controller.blocks.look_ahead = blocks; });
    }
}

void refine_words(const Machine& machine, std::span<const std::string> words, Refiner& refiner) {
    if (words.empty() || !machine::nonzero_time_keys(machine.times).empty()) return;
    refiner.add("words that take time", [&](Candidate& to) {
        for (const std::string& key : words) machine::set_value({"times", key}, kInitialWord_s, to.machine);
    });
}

void refine_curves(const ControllerRules& rules, Refiner& refiner) {
    if (rules.curves.arc_chord_tolerance_mm <= 0 && !rrs::is_blend(rules.corners.continuous)) {
        refiner.add("arcs as chords within 0.005 mm",
                    [](Candidate& to) { to.machine.controller.curves.arc_chord_tolerance_mm = 0.005; });
    }
    if (rules.ramps.centripetal_share < 1) {
        refiner.add("curves by themselves",
                    [](Candidate& to) { to.machine.controller.ramps.centripetal_share = 1; });
    }
    if (std::isfinite(rules.ramps.centripetal_share)) {
        refiner.add("curves do not slow it", [](Candidate& to) {
            to.machine.controller.ramps.centripetal_share = std::numeric_limits<double>::infinity();
        });
    }
}

}  // namespace

std::vector<Candidate> generic_candidates(const Machine& machine, const FreeParameters& open) {
    std::vector<Candidate> candidates;
    const auto add = [&](const std::string& name, const ControllerRules& rules) {
        Machine straight = machine;
        straight.controller = rules;
        straight.controller.ramps.limit_jerk = false;
        candidates.push_back({name + ", constant acceleration", straight, open});
        limit_jerk(straight);
        candidates.push_back({name + ", limited jerk", std::move(straight), open});
    };
    ControllerRules exact_stop_rules = machine.controller;
    exact_stop_rules.model = "exact-stop";
    exact_stop_rules.planner = PlannerKind::rest_to_rest;
    add("rest-to-rest", exact_stop_rules);
    for (const Corners& corners : kCorners) add(corners.name, generic_rules(machine.controller, corners));
    add("superimposed moves", overlay_rules(machine.controller));
    return candidates;
}

std::vector<Candidate> refinements(const Candidate& candidate, std::span<const std::string> words) {
    Refiner refiner(candidate);
    const ControllerRules& rules = candidate.machine.controller;
    if (!candidate.open.each_axis)
        refiner.add("each axis by itself", [](Candidate& to) { to.open.each_axis = true; });
    if (!candidate.open.speeds)
        refiner.add("speeds that are not known", [](Candidate& to) { to.open.speeds = true; });
    refine_path(candidate.machine, refiner);
    refine_words(candidate.machine, words, refiner);
    if (!rules.capabilities().applies_corner_rules) return refiner.release_candidates();
    refine_look_ahead(rules, refiner);
    refine_curves(rules, refiner);
    if (rules.ramps.continuous_acceleration_share >= 1) {
        refiner.add("a part of the acceleration in continuous mode", [](Candidate& to) {
            to.machine.controller.ramps.continuous_acceleration_share = kInitialShare;
        });
    }
    if (rules.blocks.time_s <= 0) {
        refiner.add("a time for each block",
                    [](Candidate& to) { to.machine.controller.blocks.time_s = kInitialBlock_s; });
    }
    if (rules.corners.exact_path != CornerRule::stop) {
        refiner.add("stops at corners in exact path mode",
                    [](Candidate& to) { to.machine.controller.corners.exact_path = CornerRule::stop; });
    }
    if (!rules.corners.stop_between_rapid_and_feed) {
        refiner.add("a stop between rapid and feed",
                    [](Candidate& to) { to.machine.controller.corners.stop_between_rapid_and_feed = true; });
    }
    return refiner.release_candidates();
}

}  // namespace gsim::calibrate
