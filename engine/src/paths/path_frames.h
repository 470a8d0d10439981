#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "codegen/post/post.h"
#include "engine/path_translation.h"
#include "toolpath/model/place.h"
#include "toolpath/rotary/axis_moves.h"

namespace gsim::engine {

/// The work frames and the tools that the paths of a program, and the uses of them, name themselves.
class PathFrames {
  public:
    /// None where no frame is named. `program` must outlive this.
    explicit PathFrames(const path::Program& program);

    /// Whether any is named; then positions are counted in them.
    bool any() const { return !places_mm_.empty(); }
    bool tools() const { return tools_; }
    /// A frame that the program finds by touches.
    struct Found {
        std::string name;
        const std::vector<path::Touch>* touches = nullptr;
        path::TargetId where;  ///< What says so first.
    };
    /// In the order of the file.
    const std::vector<Found>& found() const { return found_; }
    /// Where a touch is beyond the ranges of the axes, as far as that is known: of frames that the program
    /// puts somewhere before it finds them.
    std::optional<path::Fault> fault_of_touches(const path::MachineSpace& space) const;
    /// Tells a sink, at the beginning of the program, how the frames are found.
    void tell_touches(path::MoveSink& sink) const;
    /// Where each lies, of those that the program sets.
    const std::map<std::string, std::optional<path::Vector>, std::less<>>& places_mm() const {
        return places_mm_;
    }
    /// What the user should know of those that lie nobody knows where.
    std::vector<std::string> notes() const;

  private:
    void add(const path::TargetId& where, const path::WorkFrame& frame);

    std::map<std::string, std::optional<path::Vector>, std::less<>> places_mm_;
    std::vector<Found> found_;
    bool tools_ = false;
};

/// Gives the root what the request says of frames and tools and the path does not, and a frame to all that
/// names none where others do: the first one that the post has. The error is a sentence: the control has no
/// such frame, no word to set one, or the path may have none.
tl::expected<void, std::string> complete_frames(path::PathFile& file, const PathRequest& request,
                                                const codegen::Post& post);

}  // namespace gsim::engine
