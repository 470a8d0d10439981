#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "codegen/post/post.h"
#include "engine/path_translation.h"
#include "runtime/path/place.h"

namespace gsim::engine {

/// The work frames and the tools that the paths of a program, and the uses of them, name themselves.
class PathFrames {
  public:
    /// None where no frame is named.
    explicit PathFrames(const path::Program& program);

    /// Whether any is named; then positions are counted in them.
    bool any() const { return !places_mm_.empty(); }
    bool tools() const { return tools_; }
    /// Where each lies, of those that the program sets.
    const std::map<std::string, std::optional<path::Vector>, std::less<>>& places_mm() const {
        return places_mm_;
    }
    /// What the user should know of those that lie nobody knows where.
    std::vector<std::string> notes() const;

  private:
    void add(const path::WorkFrame& frame);

    std::map<std::string, std::optional<path::Vector>, std::less<>> places_mm_;
    bool tools_ = false;
};

/// Gives the root what the request says of frames and tools and the path does not, and a frame to all that
/// names none where others do: the first one that the post has. The error is a sentence: the control has no
/// such frame, no word to set one, or the path may have none.
tl::expected<void, std::string> complete_frames(path::PathFile& file, const PathRequest& request,
                                                const codegen::Post& post);

}  // namespace gsim::engine
