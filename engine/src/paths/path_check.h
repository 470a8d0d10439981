#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "codegen/post/action_words.h"
#include "codegen/post/post.h"
#include "toolpath/rotary/axis_moves.h"

namespace gsim::engine {

/// A check of the moves of a path that a post will write. It finds errors before anything is written, and
/// collects messages.
class PathCheck final : public path::MoveSink {
  public:
    /// The findings in moves that can be written.
    struct Found {
        std::vector<std::string> notes;  ///< Messages for the user.
        bool feed_modes;     ///< Some feeds are by time or by turn, and the post has words for that.
        bool accelerations;  ///< Some points have one.
        bool retracts;       ///< The tool retracts for a change.
    };

    /// `in_machine`: positions will be written in machine coordinates; `go_on`: elements for which the post
    /// has no words become comments. `file` and `post` must outlive this object.
    PathCheck(const path::PathFile& file, const codegen::Post& post, bool in_machine, bool go_on)
        : file_(file), post_(post), in_machine_(in_machine), go_on_(go_on), words_(post.actions) {}

    void move(const path::AxisMove& move) override;
    void retract() override { ++retracts_; }
    void dwell(double) override {}
    void acceleration(double) override { ++accelerations_; }
    void action(const std::string& name) override;
    void call(const path::SubPath&) override {}
    void note(const path::TargetId& where, std::string_view sentence) override;

    /// Completes the check, once after all moves. The error is a message: elements for which the post has no
    /// words.
    tl::expected<Found, std::string> finish();

  private:
    void note_feeds();
    std::string refusal() const;

    const path::PathFile& file_;
    const codegen::Post& post_;
    bool in_machine_;
    bool go_on_;
    codegen::ActionWords words_;
    std::vector<std::string> notes_;
    std::size_t count_ = 0;  ///< Number of notes on moves, listed or not.
    std::size_t accelerations_ = 0, retracts_ = 0;
    std::size_t feed_modes_ = 0, mean_feeds_ = 0, per_minute_ = 0;  ///< Moves.
    std::map<std::string, int> without_word_, said_;
};

}  // namespace gsim::engine
