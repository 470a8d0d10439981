#include "cam/linking/collision_avoidance.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "cam/linking/contact_check.h"

namespace gsim::linking {

namespace {

using path::Point;
using path::TargetError;
using path::TargetId;

// Generated paths keep this distance in addition to the cell's clearance if possible, for controllers that
// round corners.
constexpr double kExtraClearance_mm = 2;
constexpr double kContactTolerance_mm = 1e-3;
constexpr double kRoundingStep_mm = 1e-6;
// Max rounds: rotary axis angles are chosen for a complete path, so one changed path can change others.
constexpr int kMaxRounds = 4;

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
    bool is_removed = false;  ///< The target itself is removed; otherwise it gets the tool orientation.
};

// Edits of targets, by path and number.
using Edits = std::map<std::pair<std::size_t, std::size_t>, Edit>;

std::pair<std::size_t, std::size_t> target_key(const TargetId& where) {
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

std::vector<Run> find_rapid_runs(const path::Program& program, const std::vector<AxisStep>& steps,
                                 const AxisValues& start) {
    std::vector<Run> runs;
    bool continues = false;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const AxisStep& step = steps[i];
        if (!step.rapid || step.process_on) {
            continues = false;
            continue;
        }
        if (!continues) runs.push_back({i == 0 ? start : steps[i - 1].axes, {}});
        const bool last = i + 1 == steps.size() || !steps[i + 1].rapid || steps[i + 1].process_on;
        const bool shares = (i > 0 && steps[i - 1].where == step.where) ||
                            (i + 1 < steps.size() && steps[i + 1].where == step.where);
        const bool free = !last && !shares && is_free(program, step.where);
        runs.back().nodes.push_back({step.axes, i, free});
        continues = !last && (free || shares);
    }
    return runs;
}

class RapidRerouter {
  public:
    RapidRerouter(path::Program& program, const RapidPlanner& space, const AxisValues& start)
        : program_(program),
          space_(space),
          start_(start),
          clearance_mm_(space.cell().clearance_mm),
          has_orientations_(has_orientations(program)) {}

    /// Returns true if no change was necessary.
    bool run(const std::vector<AxisStep>& steps) {
        edits_.clear();
        errors_.clear();
        runs_ = 0;
        for (const Run& run : find_rapid_runs(program_, steps, start_)) {
            ++runs_;
            lead(run, steps);
        }
        if (edits_.empty()) return true;
        apply();
        return false;
    }
    std::size_t runs() const { return runs_; }
    std::size_t changed() const { return rerouted_runs_.size(); }
    /// Returns the first error of each path.
    std::vector<TargetError> release_errors() {
        std::set<std::size_t> reported;
        const auto is_repeated = [&](const TargetError& error) {
            return !reported.insert(error.where.path).second;
        };
        errors_.erase(std::remove_if(errors_.begin(), errors_.end(), is_repeated), errors_.end());
        return std::move(errors_);
    }

  private:
    // Returns the largest of some distances that both ends keep; none if one of them touches something.
    std::optional<double> end_clearance(const Run& run, std::initializer_list<double> distances_mm) const {
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
        while (!run.nodes.empty() && space_.obstacle_at(run.nodes.back().axes, min_mm())) {
            const TargetId& last = steps[run.nodes.back().step].where;
            if (last.path == program_.root || !is_free(program_, last)) return;
            edits_[target_key(last)].is_removed = true;
            run.nodes.pop_back();
        }
    }

    double min_mm() const { return std::max(clearance_mm_, kContactTolerance_mm); }

    void lead(Run run, const std::vector<AxisStep>& steps) {
        shorten_end(run, steps);
        if (run.nodes.empty()) return;
        const TargetId& to = steps[run.nodes.back().step].where;
        const auto min_mm = end_clearance(run, {this->min_mm(), clearance_mm_ / 4, kContactTolerance_mm});
        if (!min_mm) return report_ends(run, steps);
        std::optional<cell::Obstacle> obstacle;
        const AxisValues* at = &run.from;
        for (const Node& node : run.nodes) {
            if ((obstacle = space_.obstacle(*at, node.axes, *min_mm))) break;
            at = &node.axes;
        }
        if (!obstacle) return;
        const double requested_mm =
            end_clearance(run, {clearance_mm_ + kExtraClearance_mm, *min_mm}).value_or(*min_mm);
        for (const double mm : {requested_mm, *min_mm}) {
            if (reroute(run, steps, mm)) {
                rerouted_runs_.insert(runs_);
                return;
            }
            if (requested_mm == *min_mm) break;
        }
        errors_.push_back(
            {to, fmt::format("no collision-free path with a clearance of {:.3g} mm was found: '{}' comes too "
                             "close to '{}'",
                             *min_mm, name(obstacle->items.first), name(obstacle->items.second))});
    }

    std::string name(std::size_t item) const { return space_.cell().items[item].name; }

    // An error at the start belongs to the cut before.
    void report_ends(const Run& run, const std::vector<AxisStep>& steps) {
        const Node& last = run.nodes.back();
        const std::size_t first = run.nodes.front().step;
        report_end(run.from, steps[first > 0 ? first - 1 : first].where);
        report_end(last.axes, steps[last.step].where);
    }

    void report_end(const AxisValues& axes, const TargetId& where) {
        if (const auto obstacle = space_.obstacle_at(axes, kContactTolerance_mm))
            errors_.push_back(
                {where, "the tool cannot be positioned at " + space_.collision_text(axes, obstacle->items)});
    }

    // Leads the path through its original positions, without those near an obstacle, or else past all of
    // them.
    bool reroute(const Run& run, const std::vector<AxisStep>& steps, double clearance_mm) {
        std::vector<const Node*> kept;
        for (const Node& node : run.nodes) {
            if (!node.is_free || !space_.obstacle_at(node.axes, clearance_mm)) kept.push_back(&node);
        }
        std::vector<AxisPath> paths = paths_via(run.from, kept, clearance_mm);
        if (paths.empty()) {
            kept = {&run.nodes.back()};
            if (std::any_of(run.nodes.begin(), std::prev(run.nodes.end()),
                            [](const Node& node) { return !node.is_free; }))
                return false;
            paths = paths_via(run.from, kept, clearance_mm);
        }
        if (paths.empty()) return false;
        for (const Node& node : run.nodes) {
            Edit& edit = edits_[target_key(steps[node.step].where)];
            edit.is_removed = std::find(kept.begin(), kept.end(), &node) == kept.end();
        }
        for (std::size_t i = 0; i < kept.size(); ++i) {
            paths[i].pop_back();
            edits_[target_key(steps[kept[i]->step].where)].before = std::move(paths[i]);
        }
        return true;
    }

    // Returns no paths if one of them is not found.
    std::vector<AxisPath> paths_via(const AxisValues& from, const std::vector<const Node*>& nodes,
                                    double clearance_mm) const {
        std::vector<AxisPath> paths;
        const AxisValues* at = &from;
        for (const Node* node : nodes) {
            auto path = space_.find(*at, node->axes, clearance_mm);
            if (!path) return {};
            paths.push_back(*std::move(path));
            at = &node->axes;
        }
        return paths;
    }

    Point to_point(const AxisValues& axes) const {
        const machine::Machine& machine = space_.machine().machine();
        const AxisValues values = space_.in_program(axes);
        const Eigen::Vector3d tcp = space_.machine().tcp(values);
        Point point;
        point.motion = path::MotionType::rapid;
        // Digits beyond this are only rounding errors.
        for (std::size_t i = 0; i < 3; ++i)
            point.position_mm[i] =
                std::round(tcp[static_cast<Eigen::Index>(i)] / kRoundingStep_mm) * kRoundingStep_mm;
        if (!has_orientations_) return point;
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
                    for (const AxisValues& axes : edit->second.before) targets.emplace_back(to_point(axes));
                    if (edit->second.is_removed) continue;
                    if (auto* point = std::get_if<Point>(&old[target]))
                        point->orientation = state.orientation.value();
                }
                targets.push_back(std::move(old[target]));
            }
            old = std::move(targets);
        }
    }

    path::Program& program_;
    const RapidPlanner& space_;
    const AxisValues& start_;
    double clearance_mm_;
    bool has_orientations_;
    Edits edits_;
    std::size_t runs_ = 0;
    std::set<std::size_t> rerouted_runs_;  ///< Indices of runs, which keep their order.
    std::vector<TargetError> errors_;
};

}  // namespace

bool has_orientations(const path::Program& program) {
    return std::any_of(program.paths.begin(), program.paths.end(), [](const path::Path& path) {
        return std::any_of(path.targets.begin(), path.targets.end(), [](const path::Target& target) {
            const auto* point = std::get_if<Point>(&target);
            return point != nullptr && point->orientation;
        });
    });
}

tl::expected<LinkingResult, TargetError> avoid_collisions(path::Program& program, const RapidPlanner& space,
                                                          const AxisValues& start) {
    RapidRerouter maker(program, space, start);
    LinkingResult linking;
    bool converged = false;
    for (int round = 0; round < kMaxRounds && !converged; ++round) {
        const auto steps = axis_steps(program, space.machine(), space.origin());
        if (!steps) return tl::unexpected(steps.error());
        converged = maker.run(*steps);
        linking.errors = maker.release_errors();
    }
    linking.linking_paths = maker.runs();
    linking.changed = maker.changed();
    if (!linking.errors.empty()) return linking;
    const auto steps = axis_steps(program, space.machine(), space.origin());
    if (!steps) return tl::unexpected(steps.error());
    linking.errors = check_contacts(*steps, space, start);
    return linking;
}

}  // namespace gsim::linking
