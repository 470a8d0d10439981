#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "toolpath/placement/set_up.h"
#include "toolpath/rotary/axis_moves.h"
#include "toolpath/rotary/tcp_motion.h"

namespace gsim::path {

/// Traversal of one path that writes the moves of its points to a sink.
class MoveGenerator {
  public:
    /// All references must outlive this. `rotary`: rotary values at the start of the path; nullopt: unknown.
    MoveGenerator(const MachineSpace& space, const RotarySchedule& turns, const MoveOptions& options,
                  bool jet, std::size_t path, bool is_sub_path, const std::optional<AxisValues>& rotary,
                  const PathSetup& set_up, MoveSink& sink)
        : space_(space),
          turns_(turns),
          options_(options),
          jet_(jet),
          path_(path),
          is_sub_path_(is_sub_path),
          set_up_(set_up),
          sink_(sink),
          rotary_(rotary.value_or(AxisValues())) {}

    /// Moves to a point, which is a target of the path; `before` is the state there. Returns an error if the
    /// machine cannot.
    std::optional<TargetError> go_to(const Point& point, std::size_t target, const State& before);
    std::optional<TargetError> go_to(const MachinePoint& point, std::size_t target, const State& before);
    /// Turns about the TCP, if `to` is not null.
    std::optional<TargetError> unwind(std::size_t target, const AxisValues* to, const State& at);
    void set_rotary(const AxisValues& rotary) { rotary_ = rotary; }
    /// Updates the state after the call of a sub-path.
    void return_from(std::size_t target) {
        if (turns_.is_known(target)) rotary_ = turns_.at(target);
        work_offset_.clear();
    }

  private:
    struct Feed {
        double per_min = 0;
        bool rotary = false;
        std::optional<double> duration_s = {};  ///< Of the complete motion.
        std::optional<double> per_rev = {};
    };

    TargetId target_id() const { return {path_, target_}; }
    TargetError error(std::string message) const { return {target_id(), std::move(message)}; }
    std::optional<TargetError> check_range(const AxisValues& axes) const {
        for (const std::string& frame : set_up_.frames()) {
            const auto named = options_.frames_mm.find(frame);
            auto range_error = named == options_.frames_mm.end()
                                   ? space_.find_axis_range_error(axes)
                                   : space_.find_axis_range_error(axes, named->second);
            if (range_error) return error(std::move(range_error->message));
        }
        return std::nullopt;
    }
    std::optional<TargetError> run(const TcpMotion& motion, const Point& point, const State& before);
    std::optional<Feed> motion_feed(const TcpMotion& motion, const Point& point, const State& before,
                                    bool is_rotary_only) const;
    Feed axis_feed(const TcpMotion& motion, double from, double to, const Feed& feed) const;
    bool is_printed_equal(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;
    bool is_one_line(const TcpMotion& motion, bool is_start_known);
    std::optional<TargetError> report_work_offset(const Point& point, const State& before);
    std::optional<TargetError> set_position(const Point& point, const AxisValues& axes, const State& before);
    AxisMove feed_move(const AxisValues& axes, const Feed& feed, double share) const;
    void lines(const TcpMotion& motion, const Feed& feed, double tolerance_mm);
    using ArcPartFunction = std::optional<AxisArc> (TcpMotion::*)(double from, double to,
                                                                  double tolerance_mm) const;
    bool arcs(const TcpMotion& motion, const Feed& feed);
    bool arcs(const TcpMotion& motion, const Feed& feed, int parts, ArcPartFunction part_of_arc,
              int turns = 1);
    std::optional<TargetError> arrive(double dwell_s, const std::vector<std::string>& actions,
                                      const State& before);

    const MachineSpace& space_;
    const RotarySchedule& turns_;
    const MoveOptions& options_;
    bool jet_;
    std::size_t path_;
    bool is_sub_path_;
    const PathSetup& set_up_;
    MoveSink& sink_;
    std::size_t target_ = 0;
    AxisValues rotary_;        ///< Empty if unknown.
    std::string work_offset_;  ///< That the sink knows.
};

}  // namespace gsim::path
