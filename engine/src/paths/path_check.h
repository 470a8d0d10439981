#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "codegen/post/action_blocks.h"
#include "codegen/post/post.h"
#include "toolpath/rotary/axis_moves.h"

namespace gsim::engine {

/// A check of the moves of a path that a post will write. It finds errors before anything is written, and
/// collects messages.
class PathCheck final : public path::MoveSink {
  public:
    /// The findings in moves that can be written.
    struct PathSummary {
        std::vector<std::string> notes;  ///< Messages for the user.
        bool feed_modes;     ///< Some feeds are by time or by turn, and the post has words for that.
        bool accelerations;  ///< Some points have one.
        bool retracts;       ///< The tool retracts for a change.
    };

    /// `machine_coordinates`: positions will be written in machine coordinates; `continue_on_unknown`:
    /// elements for which the post has no words become comments. `file` and `post` must outlive this object.
    PathCheck(const path::PathFile& file, const codegen::Post& post, bool machine_coordinates,
              bool continue_on_unknown)
        : file_(file),
          post_(post),
          uses_machine_coordinates_(machine_coordinates),
          keep_going_(continue_on_unknown),
          words_(post.actions) {}

    void move(const path::AxisMove& move) override;
    void retract() override { ++retracts_; }
    void dwell(double) override {}
    void acceleration(double) override { ++accelerations_; }
    void action(const std::string& name) override;
    void call(const path::SubPath&) override {}
    void note(const path::TargetId& where, std::string_view message) override;

    /// Completes the check. Call it once, at the end. The error is a message: elements for which the post has
    /// no words.
    Result<PathSummary> finish();

  private:
    void add_feed_notes();
    std::string error() const;

    const path::PathFile& file_;
    const codegen::Post& post_;
    bool uses_machine_coordinates_;
    bool keep_going_;
    codegen::ActionBlocks words_;
    std::vector<std::string> notes_;
    std::size_t count_ = 0;  ///< Number of notes on moves, listed or not.
    std::size_t accelerations_ = 0, retracts_ = 0;
    std::size_t feed_modes_ = 0, mean_feeds_ = 0, per_minute_ = 0;  ///< Moves.
    std::map<std::string, int> unsupported_actions_, message_actions_;
};

}  // namespace gsim::engine
