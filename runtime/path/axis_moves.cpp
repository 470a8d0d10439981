#include "runtime/path/axis_moves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "runtime/path/pieces.h"

namespace gsim::path {

namespace {

using Eigen::Vector3d;

constexpr double kFullTurn_rad = 2 * std::numbers::pi;
constexpr double kLeastSteps = 20;  // of a program's numbers, in an arc's radius and between its ends
constexpr double kGreatestRadius_mm = 1e5;
constexpr int kRangeSamples = 16;

// One path on its way into the sink.
class Walk {
  public:
    Walk(const MachineSpace& space, const PathTurns& turns, const MoveOptions& options, bool jet,
         std::size_t path, MoveSink& sink)
        : space_(space), turns_(turns), options_(options), jet_(jet), path_(path), sink_(sink) {}

    std::optional<Fault> go_to(const Point& point, std::size_t target, const State& before);
    /// Turns on the spot, if `to` is not null.
    void unwind(std::size_t target, const AxisValues* to, const State& at);
    void set_rotary(const AxisValues& rotary) { rotary_ = rotary; }

  private:
    struct Feed {
        double per_min = 0;
        bool rotary = false;
    };

    TargetId here() const { return {path_, target_}; }
    Fault fault(std::string sentence) const { return {here(), std::move(sentence)}; }
    std::optional<Fault> check_range(const AxisValues& axes) const {
        std::string sentence = space_.range_fault(axes);
        if (sentence.empty()) return std::nullopt;
        return fault(std::move(sentence));
    }
    std::optional<Fault> run(const TipMotion& motion, const Point& point, const State& before);
    std::optional<Feed> feed_of(const TipMotion& motion, const Point& point, const State& before,
                                bool rotary_alone) const;
    void lines(const TipMotion& motion, const Feed& feed);
    bool arcs(const TipMotion& motion, const Feed& feed);
    bool is_worth_an_arc(const ArcShape& arc) const;

    const MachineSpace& space_;
    const PathTurns& turns_;
    const MoveOptions& options_;
    bool jet_;
    std::size_t path_;
    MoveSink& sink_;
    std::size_t target_ = 0;
    AxisValues rotary_;  // empty where it is not known
};

std::optional<Fault> Walk::go_to(const Point& point, std::size_t target, const State& before) {
    target_ = target;
    const AxisValues rotary = turns_.at(target);
    const Vector3d end = to_eigen(point.position_mm);
    const AxisValues axes = space_.axes(end, rotary);
    if (auto beyond = check_range(axes)) return beyond;
    std::optional<Fault> failed;
    if (point.motion == MotionType::rapid) {
        sink_.move({axes, true, std::nullopt, 0, false});
    } else {
        const std::optional<Vector>& start = before.position_mm.value();
        std::optional<ArcShape> arc;
        if (point.motion == MotionType::circular) {
            if (!start) {
                return fault(
                    "this arc starts elsewhere from each place that uses the sub-path; begin the "
                    "sub-path with a line or a rapid");
            }
            arc = arc_shape(*start, point).value();
        }
    if (point.acceleration_mm_s2) sink_.acceleration(*point.acceleration_mm_s2);
        failed =
            run(TipMotion(space_, start ? to_eigen(*start) : end, end, rotary_, rotary, arc), point, before);
    }
    rotary_ = rotary;
    if (failed) return failed;
    if (point.dwell_s > 0) sink_.dwell(point.dwell_s);
    for (const std::string& action : point.actions) sink_.action(action);
    return std::nullopt;
}

std::optional<Walk::Feed> Walk::feed_of(const TipMotion& motion, const Point& point, const State& before,
                                        bool rotary_alone) const {
    if (point.duration_s) {
        const double way = rotary_alone ? motion.turn_deg() : motion.length_mm();
        return Feed{way * 60 / *point.duration_s, rotary_alone};
    }
    const std::optional<double> feed = point.feed_mm_min ? point.feed_mm_min : before.feed_mm_min.value();
    if (rotary_alone) {
        const std::optional<double> turning =
            point.feed_deg_min ? point.feed_deg_min : before.feed_deg_min.value();
        if (turning) return Feed{*turning, true};
        if (feed) return Feed{*feed, true};  // as controllers take it: one F for both
    }
    if (feed) return Feed{*feed, false};
    return std::nullopt;
}

std::optional<Fault> Walk::run(const TipMotion& motion, const Point& point, const State& before) {
    // Where the way to the point is not known, it is taken for a line of some length.
    const bool start_is_known = before.position_mm.value().has_value();
    const bool rotary_alone = start_is_known && motion.length_mm() < options_.resolution_mm / 2;
    if (point.duration_s && !start_is_known) {
        return fault("'duration_s' needs a start, which differs between the places that lead here");
    }
    const std::optional<Feed> feed = feed_of(motion, point, before, rotary_alone);
    if (!feed) {
        return fault(
            before.feed_mm_min.differs()
                ? "the first motion of this sub-path needs 'feed_mm_min': the places that use it hand "
                  "over different feeds"
                : "the motion needs 'feed_mm_min': no point before has one");
    }
    if (motion.arc()) {
        for (int i = 1; i < kRangeSamples; ++i) {
            if (auto beyond = check_range(motion.at(static_cast<double>(i) / kRangeSamples))) return beyond;
        }
        if (arcs(motion, *feed)) return std::nullopt;
    } else if (!start_is_known || rotary_.size() != static_cast<Eigen::Index>(space_.rotary_count()) ||
               motion.is_line_of_axes(options_.tolerance_mm)) {
        sink_.move({motion.at(1), false, std::nullopt, feed->per_min, feed->rotary});
        return std::nullopt;
    }
    lines(motion, *feed);
    return std::nullopt;
}

void Walk::lines(const TipMotion& motion, const Feed& feed) {
    sink_.note(here(), fmt::format("{} by lines within {:.6g} mm",
                                   motion.arc() ? "an arc outside the planes of the axes"
                                                : "a line with turning axes",
                                   options_.tolerance_mm));
    double before = 0;
    Vector3d from = space_.linear(motion.at(0));
    motion.cut(options_.tolerance_mm, [&](double share) {
        const AxisValues axes = motion.at(share);
        const Vector3d to = space_.linear(axes);
        // The feed is of the tip; the axes go another length where they are coupled.
        const double tip_mm = motion.length_mm() * (share - before);
        const double axes_mm = (to - from).norm();
        const double scale =
            space_.coupled() && tip_mm > 0 && axes_mm > 0 && !feed.rotary ? axes_mm / tip_mm : 1;
        sink_.move({axes, false, std::nullopt, feed.per_min * scale, feed.rotary});
        before = share;
        from = to;
    });
}

// A short arc's rounded end may lie on the wrong side of its rounded start.
bool Walk::is_worth_an_arc(const ArcShape& arc) const {
    const double least = kLeastSteps * options_.resolution_mm;
    const double radius = arc.radius_mm();
    return radius >= least && radius <= kGreatestRadius_mm && radius * arc.turn_rad >= least;
}

// Arcs of a turn at most; one that nearly closes is halved, since rounding might close it.
bool Walk::arcs(const TipMotion& motion, const Feed& feed) {
    const ArcShape& arc = *motion.arc();
    if (!is_worth_an_arc(arc)) return false;
    const double turns = arc.turn_rad / kFullTurn_rad;
    int pieces = std::max(1, static_cast<int>(std::ceil(turns - 1e-9)));
    const double gap_mm = std::abs(turns / pieces - 1) * kFullTurn_rad * arc.radius_mm();
    const bool closed = gap_mm < 1e-6 && std::abs(arc.radius_mm() - arc.end_radius_mm) < 1e-6;
    if (!closed && gap_mm < kLeastSteps * options_.resolution_mm) pieces *= 2;
    std::vector<AxisArc> found;
    found.reserve(static_cast<std::size_t>(pieces));
    for (int i = 0; i < pieces; ++i) {
        const auto piece = motion.axis_arc(static_cast<double>(i) / pieces,
                                           static_cast<double>(i + 1) / pieces, options_.tolerance_mm);
        if (!piece) return false;
        found.push_back(*piece);
    }
    for (int i = 0; i < pieces; ++i) {
        sink_.move({motion.at(static_cast<double>(i + 1) / pieces), false, found[static_cast<std::size_t>(i)],
                    feed.per_min, feed.rotary});
    }
    return true;
}

// With the jet off, so that it does not cut a hole where it stands.
void Walk::unwind(std::size_t target, const AxisValues* to, const State& at) {
    if (to == nullptr) return;
    target_ = target;
    const bool jet = jet_ && at.jet_on.value() != false;
    const bool abrasive = jet && at.abrasive_on.value() == true;
    sink_.note(here(), jet ? "the rotary axes unwind, with the jet off" : "the rotary axes unwind");
    if (abrasive) sink_.action("abrasive_off");
    if (jet) sink_.action("waterjet_off");
    sink_.move({space_.axes(to_eigen(*at.position_mm.value()), *to), true, std::nullopt, 0, false});
    if (jet) sink_.action("waterjet_on");
    if (abrasive) sink_.action("abrasive_on");
    rotary_ = *to;
}

// A call, or one for each repeat where the axes unwind in between.
void call(const SubPath& sub_path, std::size_t target, const PathTurns& turns, const State& behind,
          Walk& walk, MoveSink& sink) {
    const AxisValues* to = turns.between_repeats(target);
    if (to == nullptr) {
        sink.call(sub_path);
    } else {
        for (int i = 0; i < sub_path.repeats; ++i) {
            if (i > 0) walk.unwind(target, to, behind);
            sink.call({sub_path.path, 1});
        }
    }
    walk.set_rotary(turns.at(target));
}

}  // namespace

tl::expected<void, Fault> AxisMoves::run(std::size_t path, MoveSink& sink) const {
    Walk walk(space_, turns_[path], options_, jet_, path, sink);
    State state = states_.entry(path);
    const std::vector<Target>& targets = program_.paths[path].targets;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (const auto* point = std::get_if<Point>(&targets[i])) {
            if (auto fault = walk.go_to(*point, i, state)) return tl::unexpected(*fault);
            states_.pass(state, targets[i]);
        } else {
            states_.pass(state, targets[i]);
            call(std::get<SubPath>(targets[i]), i, turns_[path], state, walk, sink);
        }
        walk.unwind(i, turns_[path].unwinding(i), state);
    }
    return {};
}

}  // namespace gsim::path
