#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "toolpath/json/keys.h"
#include "toolpath/model/path.h"

namespace gsim::path {

/// Work frame and tool of a path while their keys are read, in any order. Errors are messages.
class PathDraft {
  public:
    /// Kind of value of a key; the name and the targets have other kinds.
    enum class ValueKind { other, text, number, vector, touches };
    static ValueKind value_kind(PathKey key);

    Result<void> set_text(PathKey key, std::string_view value);
    Result<void> set_number(PathKey key, double value);
    /// Sets a vector, which needs its exact number of values.
    Result<void> set_vector(PathKey key, const std::vector<double>& values);

    /// Adds one of the list of `probe_offset`; end_touches() follows the last one.
    void add_touch(const Touch& touch) { frame_.touches.push_back(touch); }
    Result<void> end_touches() const;

    /// Sets both in the path, once all keys are read.
    Result<void> finish(Path& path) const;
    /// Returns the frame for a use of a path, which has no tool.
    Result<WorkFrame> finish_frame() const;

  private:
    WorkFrame frame_;
    std::optional<int> tool_, length_offset_, diameter_offset_;
};

}  // namespace gsim::path
