#include "toolpath/rotary/axis_moves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "toolpath/placement/set_up.h"
#include "toolpath/rotary/arc_blocks.h"
#include "toolpath/rotary/pieces.h"

namespace gsim::path {

namespace {

using Eigen::Vector3d;

constexpr double kMoreThanACircle_rad = 2 * std::numbers::pi * (1 + 1e-9);
constexpr double kGreatestRotaryTurn_deg = 360'000;
constexpr int kRangeSamples = 16;
constexpr double kSamePlace_mm = 1e-6;

// Traversal of one path that writes to the sink.
class Walk {
  public:
    Walk(const MachineSpace& space, const PathTurns& turns, const MoveOptions& options, bool jet,
         std::size_t path, bool is_sub_path, const std::optional<AxisValues>& rotary, const SetUp& set_up,
         MoveSink& sink)
        : space_(space),
          turns_(turns),
          options_(options),
          jet_(jet),
          path_(path),
          is_sub_path_(is_sub_path),
          set_up_(set_up),
          sink_(sink),
          rotary_(rotary.value_or(AxisValues())) {}

    std::optional<Fault> go_to(const Point& point, std::size_t target, const State& before);
    std::optional<Fault> go_to(const MachinePoint& point, std::size_t target, const State& before);
    /// Turns about the TCP, if `to` is not null.
    std::optional<Fault> unwind(std::size_t target, const AxisValues* to, const State& at);
    void set_rotary(const AxisValues& rotary) { rotary_ = rotary; }
    /// Updates the state after the call of a sub-path.
    void return_from(std::size_t target) {
        if (turns_.knows(target)) rotary_ = turns_.at(target);
        work_offset_.clear();
    }

  private:
    struct Feed {
        double per_min = 0;
        bool rotary = false;
        std::optional<double> duration_s = {};  // of the complete motion
        std::optional<double> per_rev = {};
    };

    TargetId here() const { return {path_, target_}; }
    Fault fault(std::string sentence) const { return {here(), std::move(sentence)}; }
    std::optional<Fault> check_range(const AxisValues& axes) const {
        for (const std::string& frame : set_up_.frames()) {
            const auto named = options_.frames_mm.find(frame);
            std::string sentence = named == options_.frames_mm.end()
                                       ? space_.range_fault(axes)
                                       : space_.range_fault(axes, named->second);
            if (!sentence.empty()) return fault(std::move(sentence));
        }
        return std::nullopt;
    }
    std::optional<Fault> run(const TipMotion& motion, const Point& point, const State& before);
    std::optional<Feed> feed_of(const TipMotion& motion, const Point& point, const State& before,
                                bool rotary_alone) const;
    Feed feed_of_axes(const TipMotion& motion, double from, double to, const Feed& feed) const;
    bool prints_same(const Vector3d& a, const Vector3d& b) const;
    bool is_one_line(const TipMotion& motion, bool start_is_known);
    std::optional<Fault> tell_work_offset(const Point& point, const State& before);
    std::optional<Fault> stand(const Point& point, const AxisValues& axes, const State& before);
    AxisMove feed_move(const AxisValues& axes, const Feed& feed, double share) const;
    void lines(const TipMotion& motion, const Feed& feed, double tolerance_mm);
    using PieceOfArc = std::optional<AxisArc> (TipMotion::*)(double from, double to,
                                                             double tolerance_mm) const;
    bool arcs(const TipMotion& motion, const Feed& feed);
    bool arcs(const TipMotion& motion, const Feed& feed, int pieces, PieceOfArc piece_of, int turns = 1);
    std::optional<Fault> arrive(double dwell_s, const std::vector<std::string>& actions, const State& before);

    const MachineSpace& space_;
    const PathTurns& turns_;
    const MoveOptions& options_;
    bool jet_;
    std::size_t path_;
    bool is_sub_path_;
    const SetUp& set_up_;
    MoveSink& sink_;
    std::size_t target_ = 0;
    AxisValues rotary_;        // empty if unknown
    std::string work_offset_;  // that the sink knows
};

std::optional<Fault> Walk::go_to(const Point& point, std::size_t target, const State& before) {
    target_ = target;
    const AxisValues rotary = turns_.at(target);
    const Vector3d end = to_eigen(point.position_mm);
    const AxisValues axes = space_.axes(end, rotary);
    if (auto beyond = check_range(axes)) return beyond;
    if (before.at_machine_point.value() != false) sink_.retract();
    if (point.acceleration_mm_s2) sink_.acceleration(*point.acceleration_mm_s2);
    if (auto differs = tell_work_offset(point, before)) return differs;
    std::optional<Fault> failed;
    if (point.motion == MotionType::rapid) {
        sink_.move({axes, true, std::nullopt, 0, false});
    } else if (point.motion == MotionType::none) {
        failed = stand(point, axes, before);
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
        failed =
            run(TipMotion(space_, start ? to_eigen(*start) : end, end, rotary_, rotary, arc), point, before);
    }
    rotary_ = rotary;
    return failed ? failed : arrive(point.dwell_s, point.actions, before);
}

std::optional<Fault> Walk::go_to(const MachinePoint& point, std::size_t target, const State& before) {
    target_ = target;
    if (jet_ && before.jet_on.value() != false)
        return fault(fmt::format("the jet may be on where the machine goes to {}; turn it off before",
                                 title_of(point)));
    if (std::string beyond = space_.range_fault(point.axes); !beyond.empty()) return fault(std::move(beyond));
    const MachineWay way = way_to(point, options_.retract_mm);
    if (way.from_above) sink_.retract();
    sink_.go_to(way);
    if (turns_.knows(target)) rotary_ = turns_.at(target);
    return arrive(point.dwell_s, point.actions, before);
}

std::optional<Fault> Walk::arrive(double dwell_s, const std::vector<std::string>& actions,
                                  const State& before) {
    if (dwell_s > 0) sink_.dwell(dwell_s);
    const auto all = with_restored(actions, before.running, options_.tool_change_stops);
    if (!all) return fault(all.error());
    for (const std::string& each : *all) sink_.action(each);
    return std::nullopt;
}

std::optional<Fault> Walk::tell_work_offset(const Point& point, const State& before) {
    if (point.work_offset.empty() && before.work_offset.differs())
        return fault("the point needs 'work_offset': the places that lead here hand over different ones");
    const std::string name =
        point.work_offset.empty() ? before.work_offset.value().value_or("") : point.work_offset;
    if (!name.empty() && name != work_offset_) sink_.work_offset(name);
    work_offset_ = name;
    return std::nullopt;
}

// Handles a point at which the tool already is.
std::optional<Fault> Walk::stand(const Point& point, const AxisValues& axes, const State& before) {
    const std::optional<Vector>& at = before.position_mm.value();
    if (at && (to_eigen(*at) - to_eigen(point.position_mm)).norm() > kSamePlace_mm)
        return fault("a point of motion \"none\" stands where the point before it does");
    if (!at) sink_.stand(axes);
    return std::nullopt;
}

std::optional<Walk::Feed> Walk::feed_of(const TipMotion& motion, const Point& point, const State& before,
                                        bool rotary_alone) const {
    if (point.duration_s) {
        const double way = rotary_alone ? motion.turn_deg() : motion.length_mm();
        return Feed{way * 60 / *point.duration_s, rotary_alone, point.duration_s};
    }
    const std::optional<double> feed = point.feed_mm_min ? point.feed_mm_min : before.feed_mm_min.value();
    if (rotary_alone) {
        const std::optional<double> turning =
            point.feed_deg_min ? point.feed_deg_min : before.feed_deg_min.value();
        if (turning) return Feed{*turning, true};
        if (feed) return Feed{*feed, true};  // as controllers do: one F for both
    }
    if (!feed) return std::nullopt;
    const double per_rev =
        point.feed_mm_min ? point.feed_mm_rev.value_or(0) : before.feed_mm_rev.value().value_or(0);
    return Feed{*feed, false, std::nullopt, per_rev > 0 ? std::optional(per_rev) : std::nullopt};
}

std::optional<Fault> Walk::run(const TipMotion& motion, const Point& point, const State& before) {
    // An unknown path to the point is taken for a line of some length.
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
    if (space_.coupled() && motion.turn_deg() > kGreatestRotaryTurn_deg) {
        return fault(fmt::format("the rotary axes turn by {:.6g} degrees in one motion; {:.6g} is the most",
                                 motion.turn_deg(), kGreatestRotaryTurn_deg));
    }
    if (motion.arc() || space_.coupled()) {
        for (int i = 1; i < kRangeSamples; ++i) {
            if (auto beyond = check_range(motion.at(static_cast<double>(i) / kRangeSamples))) return beyond;
        }
    }
    if (motion.tilts_over_the_upright()) {
        sink_.note(
            here(),
            "the tool, which leans at both ends of this arc, stands upright between them; with a point "
            "in between it would turn with the arc");
    }
    if (motion.arc()) {
        if (!is_worth_an_arc(*motion.arc(), options_) && (!space_.coupled() || motion.turn_deg() == 0)) {
            // The program's numbers cannot express more of such an arc.
            lines(motion, *feed, std::min(options_.tolerance_mm, options_.resolution_mm / 2));
            return std::nullopt;
        }
        if (arcs(motion, *feed)) return std::nullopt;
        const bool is_arc_of_axes = !space_.coupled() || motion.turn_deg() == 0;
        if (options_.arcs && options_.oblique_arcs == ObliqueArcs::refused && is_arc_of_axes) {
            return fault(
                "this arc lies outside the planes of X, Y and Z, and the post refuses such arcs ([arcs], "
                "oblique)");
        }
    } else if (is_one_line(motion, start_is_known)) {
        const Feed of_axes = start_is_known ? feed_of_axes(motion, 0, 1, *feed) : *feed;
        AxisMove move = feed_move(motion.at(1), of_axes, 1);
        move.lead_mm = point.lead_mm;
        sink_.move(move);
        return std::nullopt;
    }
    if (point.lead_mm) return fault("a line in step with the spindle would have to be cut into several");
    sink_.note(here(), fmt::format("{} by lines within {:.6g} mm",
                                   !motion.arc()   ? "a line with turning axes"
                                   : options_.arcs ? "an arc outside the planes of the axes"
                                                   : "an arc",
                                   options_.tolerance_mm));
    lines(motion, *feed, options_.tolerance_mm);
    return std::nullopt;
}

// Accepts a line if it is unknown how the axes come to a sub-path, because no other motion is possible.
bool Walk::is_one_line(const TipMotion& motion, bool start_is_known) {
    const bool rotary_is_known = rotary_.size() == static_cast<Eigen::Index>(space_.rotary_count());
    if (start_is_known && rotary_is_known) return motion.is_line_of_axes(options_.tolerance_mm);
    if (space_.coupled() && is_sub_path_ && (!rotary_is_known || motion.turn_deg() > 0)) {
        sink_.note(here(),
                   "the tip may leave the line to the first point of this sub-path, to which the axes come "
                   "from different places; a rapid would be better");
    }
    return true;
}

bool Walk::prints_same(const Vector3d& a, const Vector3d& b) const {
    return ((a / options_.resolution_mm).array().round() == (b / options_.resolution_mm).array().round())
        .all();
}

// Converts a feed, which is that of the TCP, or of the rotary axes if the TCP is at standstill. Coupled axes
// move another length, and a controller takes F as mm of X, Y and Z if any of them moves.
Walk::Feed Walk::feed_of_axes(const TipMotion& motion, double from, double to, const Feed& feed) const {
    const double turn_deg = motion.turn_deg() * (to - from);
    if (!space_.coupled() || turn_deg == 0) return feed;
    const double minutes = (feed.rotary ? turn_deg : motion.length_mm() * (to - from)) / feed.per_min;
    const Vector3d start = space_.linear(motion.at(from));
    const Vector3d end = space_.linear(motion.at(to));
    if (prints_same(start, end)) return {turn_deg / minutes, true, feed.duration_s};
    return {(end - start).norm() / minutes, false, feed.duration_s};
}

// Returns a feed move for a share of the motion.
AxisMove Walk::feed_move(const AxisValues& axes, const Feed& feed, double share) const {
    AxisMove move{axes, false, std::nullopt, feed.per_min, feed.rotary};
    if (feed.duration_s) move.duration_s = *feed.duration_s * share;
    move.feed_mm_rev = feed.per_rev;
    return move;
}

void Walk::lines(const TipMotion& motion, const Feed& feed, double tolerance_mm) {
    double before = 0;
    motion.cut(tolerance_mm, [&](double share) {
        const Feed of_axes = feed_of_axes(motion, before, share, feed);
        sink_.move(feed_move(motion.at(share), of_axes, share - before));
        before = share;
    });
}

bool Walk::arcs(const TipMotion& motion, const Feed& feed) {
    const ArcShape& arc = *motion.arc();
    if (!options_.arcs || !is_worth_an_arc(arc, options_)) return false;
    const bool bends = space_.coupled() && motion.turn_deg() > 0;
    const int turns = bends ? 1 : turns_in_one(arc, options_);
    if (turns > 1 && arcs(motion, feed, 1, &TipMotion::axis_arc, turns)) return true;
    if (arcs(motion, feed, pieces_in_plane(arc, options_), &TipMotion::axis_arc)) return true;
    return options_.oblique_arcs == ObliqueArcs::through_points &&
           arcs(motion, feed, pieces_through_points(arc, options_), &TipMotion::oblique_arc);
}

bool Walk::arcs(const TipMotion& motion, const Feed& feed, int pieces, PieceOfArc piece_of, int turns) {
    std::vector<AxisArc> found;
    found.reserve(static_cast<std::size_t>(pieces));
    for (int i = 0; i < pieces; ++i) {
        const auto piece = (motion.*piece_of)(static_cast<double>(i) / pieces,
                                              static_cast<double>(i + 1) / pieces, options_.tolerance_mm);
        if (!piece) return false;
        found.push_back(*piece);
    }
    if (turns == 1 && motion.arc()->turn_rad > kMoreThanACircle_rad)
        sink_.note(here(), "an arc of several turns by several blocks");
    for (int i = 0; i < pieces; ++i) {
        AxisMove move = feed_move(motion.at(static_cast<double>(i + 1) / pieces), feed, 1.0 / pieces);
        move.arc = found[static_cast<std::size_t>(i)];
        move.arc->turn_rad = motion.arc()->turn_rad / pieces;
        move.arc->turns = turns;
        sink_.move(move);
    }
    return pieces > 0;
}

// Turns the jet off, so that it does not cut a hole at standstill.
std::optional<Fault> Walk::unwind(std::size_t target, const AxisValues* to, const State& at) {
    if (to == nullptr) return std::nullopt;
    target_ = target;
    const bool jet = jet_ && at.jet_on.value() != false;
    const bool abrasive = jet && at.abrasive_on.value() == true;
    sink_.note(here(), jet ? "the rotary axes unwind, with the jet off" : "the rotary axes unwind");
    if (abrasive) sink_.action("abrasive_off");
    if (jet) sink_.action("waterjet_off");
    // A TCP off the axes would otherwise swing about them, through the work.
    const Vector3d tip = to_eigen(*at.position_mm.value());
    const TipMotion turn(space_, tip, tip, rotary_, *to, std::nullopt);
    std::optional<Fault> beyond;
    turn.cut(options_.tolerance_mm, [&](double share) {
        const AxisValues axes = turn.at(share);
        if (!beyond) beyond = check_range(axes);
        sink_.move({axes, true, std::nullopt, 0, false});
    });
    if (jet) sink_.action("waterjet_on");
    if (abrasive) sink_.action("abrasive_on");
    rotary_ = *to;
    return beyond;
}

// Writes one call, or one for each repeat if the axes unwind in between.
std::optional<Fault> call(const SubPath& sub_path, std::size_t target, const PathTurns& turns,
                          const State& behind, Walk& walk, MoveSink& sink) {
    const AxisValues* to = turns.between_repeats(target);
    if (to == nullptr) {
        sink.call(sub_path);
    } else {
        for (int i = 0; i < sub_path.repeats; ++i) {
            walk.set_rotary(turns.at(target));
            auto fault = i > 0 ? walk.unwind(target, to, behind) : std::nullopt;
            if (fault) return fault;
            sink.call({sub_path.path, 1});
        }
    }
    walk.return_from(target);
    return std::nullopt;
}

}  // namespace

tl::expected<void, Fault> AxisMoves::run(std::size_t path, MoveSink& sink) const {
    SetUp set_up(program_, states_, path, options_.tool_change_stops, jet_, sink);
    Walk walk(space_, turns_[path], options_, jet_, path, path != program_.root, entries_[path], set_up,
              sink);
    State state = states_.entry(path);
    const std::vector<Target>& targets = program_.paths[path].targets;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        sink.begin({path, i});
        if (auto fault = set_up.before(i, state)) return tl::unexpected(*fault);
        states_.set_up(state, path, targets[i]);
        if (const auto* point = std::get_if<Point>(&targets[i])) {
            if (auto fault = walk.go_to(*point, i, state)) return tl::unexpected(*fault);
        } else if (const auto* place = std::get_if<MachinePoint>(&targets[i])) {
            if (auto fault = walk.go_to(*place, i, state)) return tl::unexpected(*fault);
        }
        states_.pass(state, targets[i]);
        if (const auto* use = std::get_if<SubPath>(&targets[i])) {
            if (auto fault = call(*use, i, turns_[path], state, walk, sink)) return tl::unexpected(*fault);
        }
        if (auto fault = walk.unwind(i, turns_[path].unwinding(i), state)) return tl::unexpected(*fault);
    }
    if (path == program_.root) return {};
    if (auto fault = set_up.finish(state)) return tl::unexpected(*fault);
    return {};
}

}  // namespace gsim::path
