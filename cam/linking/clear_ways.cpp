#include "cam/linking/clear_ways.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "cam/linking/cut_look.h"

namespace gsim::transit {

namespace {

using path::Fault;
using path::Point;
using path::TargetId;

// Generated paths keep this distance in addition to the cell's clearance if possible, for controllers that
// round corners.
constexpr double kMargin_mm = 2;
constexpr double kTouch_mm = 1e-3;
constexpr double kRounding_mm = 1e-6;
// Max rounds: rotary axis angles are chosen for a complete path, so one changed path can change others.
constexpr int kMostRounds = 4;

struct Node {
    AxisValues axes;
    std::size_t step = 0;  ///< That ends there.
    bool is_free = false;  ///< Without an action, so that the path may avoid it.
};

/// Consecutive rapids.
struct Run {
    AxisValues from;
    std::vector<Node> nodes;
};

/// Changes before a target, and to it.
struct Edit {
    std::vector<AxisValues> before = {};
    bool leaves = false;  ///< The target itself is removed; otherwise it gets the tool orientation.
};

// Edits of targets, by path and number.
using Edits = std::map<std::pair<std::size_t, std::size_t>, Edit>;

std::pair<std::size_t, std::size_t> key_of(const TargetId& where) {
    return {where.path, *where.target};
}

const Point* point_at(const path::Program& program, const TargetId& where) {
    return std::get_if<Point>(&program.paths[where.path].targets[*where.target]);
}

bool is_free(const path::Program& program, const TargetId& where) {
    const Point* point = point_at(program, where);
    return point != nullptr && point->motion == path::MotionType::rapid && point->actions.empty() &&
           point->dwell_s == 0 && point->name.empty() && !point->acceleration_mm_s2;
}

std::vector<Run> runs_of(const path::Program& program, const std::vector<AxisStep>& steps,
                         const AxisValues& start) {
    std::vector<Run> runs;
    bool goes_on = false;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const AxisStep& step = steps[i];
        if (!step.rapid || step.jet_on) {
            goes_on = false;
            continue;
        }
        if (!goes_on) runs.push_back({i == 0 ? start : steps[i - 1].axes, {}});
        const bool last = i + 1 == steps.size() || !steps[i + 1].rapid || steps[i + 1].jet_on;
        const bool shares = (i > 0 && steps[i - 1].where == step.where) ||
                            (i + 1 < steps.size() && steps[i + 1].where == step.where);
        const bool free = !last && !shares && is_free(program, step.where);
        runs.back().nodes.push_back({step.axes, i, free});
        goes_on = !last && (free || shares);
    }
    return runs;
}

class WayMaker {
  public:
    WayMaker(path::Program& program, const RapidSpace& space, const AxisValues& start)
        : program_(program),
          space_(space),
          start_(start),
          clearance_mm_(space.cell().clearance_mm),
          orients_(names_orientations(program)) {}

    /// Returns true if no change was necessary.
    bool run(const std::vector<AxisStep>& steps) {
        edits_.clear();
        faults_.clear();
        runs_ = 0;
        for (const Run& run : runs_of(program_, steps, start_)) {
            ++runs_;
            lead(run, steps);
        }
        if (edits_.empty()) return true;
        apply();
        return false;
    }
    std::size_t runs() const { return runs_; }
    std::size_t changed() const { return changed_.size(); }
    /// Returns the first error of each path.
    std::vector<Fault> take_faults() {
        std::set<std::size_t> told;
        const auto again = [&](const Fault& fault) { return !told.insert(fault.where.path).second; };
        faults_.erase(std::remove_if(faults_.begin(), faults_.end(), again), faults_.end());
        return std::move(faults_);
    }

  private:
    // Returns the largest of some distances that both ends keep; none if one of them touches something.
    std::optional<double> kept_at_ends(const Run& run, std::initializer_list<double> distances_mm) const {
        for (const double mm : distances_mm) {
            if (!space_.obstacle_at(run.from, mm) && !space_.obstacle_at(run.nodes.back().axes, mm))
                return mm;
        }
        return std::nullopt;
    }

    // After the last cut the tool does not need to rise as far as for the next cut, unless the root defines
    // the end of the program.
    void shorten_end(Run& run, const std::vector<AxisStep>& steps) {
        if (run.nodes.back().step + 1 != steps.size()) return;
        while (!run.nodes.empty() && space_.obstacle_at(run.nodes.back().axes, least_mm())) {
            const TargetId& last = steps[run.nodes.back().step].where;
            if (last.path == program_.root || !is_free(program_, last)) return;
            edits_[key_of(last)].leaves = true;
            run.nodes.pop_back();
        }
    }

    double least_mm() const { return std::max(clearance_mm_, kTouch_mm); }

    void lead(Run run, const std::vector<AxisStep>& steps) {
        shorten_end(run, steps);
        if (run.nodes.empty()) return;
        const TargetId& to = steps[run.nodes.back().step].where;
        const auto least_mm = kept_at_ends(run, {this->least_mm(), clearance_mm_ / 4, kTouch_mm});
        if (!least_mm) return tell_ends(run, steps);
        std::optional<cell::Obstacle> obstacle;
        const AxisValues* at = &run.from;
        for (const Node& node : run.nodes) {
            if ((obstacle = space_.obstacle(*at, node.axes, *least_mm))) break;
            at = &node.axes;
        }
        if (!obstacle) return;
        const double wanted_mm =
            kept_at_ends(run, {clearance_mm_ + kMargin_mm, *least_mm}).value_or(*least_mm);
        for (const double mm : {wanted_mm, *least_mm}) {
            if (make_round(run, steps, mm)) {
                changed_.insert(runs_);
                return;
            }
            if (wanted_mm == *least_mm) break;
        }
        faults_.push_back(
            {to,
             fmt::format("no way was found there that keeps {:.3g} mm away from everything: '{}' comes too "
                         "near to '{}'",
                         *least_mm, name(obstacle->items.first), name(obstacle->items.second))});
    }

    std::string name(std::size_t item) const { return space_.cell().items[item].name; }

    // An error at the start belongs to the cut before.
    void tell_ends(const Run& run, const std::vector<AxisStep>& steps) {
        const Node& last = run.nodes.back();
        const std::size_t first = run.nodes.front().step;
        tell_end(run.from, steps[first > 0 ? first - 1 : first].where);
        tell_end(last.axes, steps[last.step].where);
    }

    void tell_end(const AxisValues& axes, const TargetId& where) {
        if (const auto obstacle = space_.obstacle_at(axes, kTouch_mm))
            faults_.push_back({where, "the tool cannot stand at " + space_.told(axes, obstacle->items)});
    }

    // Leads the path through its original positions, without those near an obstacle, or else past all of
    // them.
    bool make_round(const Run& run, const std::vector<AxisStep>& steps, double clearance_mm) {
        std::vector<const Node*> kept;
        for (const Node& node : run.nodes) {
            if (!node.is_free || !space_.obstacle_at(node.axes, clearance_mm)) kept.push_back(&node);
        }
        std::vector<Way> ways = ways_by(run.from, kept, clearance_mm);
        if (ways.empty()) {
            kept = {&run.nodes.back()};
            if (std::any_of(run.nodes.begin(), std::prev(run.nodes.end()),
                            [](const Node& node) { return !node.is_free; }))
                return false;
            ways = ways_by(run.from, kept, clearance_mm);
        }
        if (ways.empty()) return false;
        for (const Node& node : run.nodes) {
            Edit& edit = edits_[key_of(steps[node.step].where)];
            edit.leaves = std::find(kept.begin(), kept.end(), &node) == kept.end();
        }
        for (std::size_t i = 0; i < kept.size(); ++i) {
            ways[i].pop_back();
            edits_[key_of(steps[kept[i]->step].where)].before = std::move(ways[i]);
        }
        return true;
    }

    // Returns no paths if one of them is not found.
    std::vector<Way> ways_by(const AxisValues& from, const std::vector<const Node*>& nodes,
                             double clearance_mm) const {
        std::vector<Way> ways;
        const AxisValues* at = &from;
        for (const Node* node : nodes) {
            auto way = space_.find(*at, node->axes, clearance_mm);
            if (!way) return {};
            ways.push_back(*std::move(way));
            at = &node->axes;
        }
        return ways;
    }

    Point point_of(const AxisValues& axes) const {
        const machine::Machine& machine = space_.machine().machine();
        const AxisValues values = space_.in_program(axes);
        const Eigen::Vector3d tip = space_.machine().tip(values);
        Point point;
        point.motion = path::MotionType::rapid;
        // Digits beyond this are only rounding errors.
        for (std::size_t i = 0; i < 3; ++i)
            point.position_mm[i] =
                std::round(tip[static_cast<Eigen::Index>(i)] / kRounding_mm) * kRounding_mm;
        if (!orients_) return point;
        path::RotaryAxes rotary;
        for (std::size_t i = 0; i < machine.axes.size(); ++i) {
            if (machine.axes[i].kind == machine::AxisKind::rotary)
                rotary[machine.axes[i].letter] = values[static_cast<Eigen::Index>(i)];
        }
        if (!rotary.empty()) point.orientation = rotary;
        return point;
    }

    void apply() {
        const path::States states(program_);
        for (std::size_t i = 0; i < program_.paths.size(); ++i) {
            if (!states.used(i)) continue;
            path::State state = states.entry(i);
            std::vector<path::Target> targets;
            std::vector<path::Target>& old = program_.paths[i].targets;
            for (std::size_t target = 0; target < old.size(); ++target) {
                states.pass(state, old[target]);
                const auto edit = edits_.find({i, target});
                if (edit != edits_.end()) {
                    for (const AxisValues& axes : edit->second.before) targets.emplace_back(point_of(axes));
                    if (edit->second.leaves) continue;
                    if (auto* point = std::get_if<Point>(&old[target]))
                        point->orientation = state.orientation.value();
                }
                targets.push_back(std::move(old[target]));
            }
            old = std::move(targets);
        }
    }

    path::Program& program_;
    const RapidSpace& space_;
    const AxisValues& start_;
    double clearance_mm_;
    bool orients_;
    Edits edits_;
    std::size_t runs_ = 0;
    std::set<std::size_t> changed_;  ///< Indices of runs, which keep their order.
    std::vector<Fault> faults_;
};

}  // namespace

bool names_orientations(const path::Program& program) {
    return std::any_of(program.paths.begin(), program.paths.end(), [](const path::Path& path) {
        return std::any_of(path.targets.begin(), path.targets.end(), [](const path::Target& target) {
            const auto* point = std::get_if<Point>(&target);
            return point != nullptr && point->orientation;
        });
    });
}

tl::expected<Transit, Fault> clear_ways(path::Program& program, const RapidSpace& space,
                                        const AxisValues& start) {
    WayMaker maker(program, space, start);
    Transit transit;
    bool settled = false;
    for (int round = 0; round < kMostRounds && !settled; ++round) {
        const auto steps = axis_way(program, space.machine(), space.origin());
        if (!steps) return tl::unexpected(steps.error());
        settled = maker.run(*steps);
        transit.faults = maker.take_faults();
    }
    transit.ways = maker.runs();
    transit.changed = maker.changed();
    if (!transit.faults.empty()) return transit;
    const auto steps = axis_way(program, space.machine(), space.origin());
    if (!steps) return tl::unexpected(steps.error());
    transit.faults = look_at_steps(*steps, space, start);
    return transit;
}

}  // namespace gsim::transit
