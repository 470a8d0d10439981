#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "codegen/post/post.h"
#include "engine/path_translation.h"
#include "toolpath/model/source_location.h"
#include "toolpath/rotary/axis_moves.h"

namespace gsim::engine {

/// The work frames and the tools that the paths of a program, and their uses, name themselves.
class PathFrames {
  public:
    /// Contains none if no frame is named. `program` must outlive this object.
    explicit PathFrames(const path::Program& program);

    /// Returns true if a frame is named; then positions are relative to frames.
    bool any() const { return !origins_mm_.empty(); }
    bool tools() const { return has_tools_; }
    /// A frame that the program finds by touches.
    struct ProbedFrame {
        std::string name;
        const std::vector<path::Touch>* touches = nullptr;
        path::TargetId where;  ///< Its first mention.
    };
    /// Returns them in the order of the file.
    const std::vector<ProbedFrame>& found() const { return found_; }
    /// Returns an error if a touch is beyond the ranges of the axes, as far as that is known: for frames that
    /// the program places before it finds them.
    std::optional<path::TargetError> check_touches(const path::MachineSpace& space) const;
    /// Writes the touches that find the frames to a sink, at the beginning of the program.
    void emit_touches(path::MoveSink& sink) const;
    /// Returns the positions of the frames that the program sets.
    const std::map<std::string, std::optional<path::Vector>, std::less<>>& positions_mm() const {
        return origins_mm_;
    }
    /// Returns messages for the user about frames with unknown positions.
    std::vector<std::string> notes() const;

  private:
    void add(const path::TargetId& where, const path::WorkFrame& frame);

    std::map<std::string, std::optional<path::Vector>, std::less<>> origins_mm_;
    std::vector<ProbedFrame> found_;
    bool has_tools_ = false;
};

/// Adds to the root the request's frames and tools that the path lacks. If some paths name a frame, all
/// others get one: the first one of the post. The error is a message: the controller has no such frame, no
/// word to set one, or the path may have none.
Result<void> complete_frames(path::PathFile& file, const PathRequest& request, const codegen::Post& post);

}  // namespace gsim::engine
