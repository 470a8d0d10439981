#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "toolpath/json/keys.h"
#include "toolpath/model/path.h"

namespace gsim::path {

/// The work frame and the tool of a path while their keys are read, in any order. Errors are sentences.
class PathDraft {
  public:
    /// What kind of value a key takes; those of the name and of the targets are others.
    enum class ValueKind { other, text, number, vector, touches };
    static ValueKind kind_of(PathKey key);

    tl::expected<void, std::string> set_text(PathKey key, std::string_view value);
    tl::expected<void, std::string> set_number(PathKey key, double value);
    /// As many values as a vector has, no more and no fewer.
    tl::expected<void, std::string> set_vector(PathKey key, const std::vector<double>& values);

    /// One of the list of `probe_offset`, and behind the last one of it.
    void add_touch(const Touch& touch) { frame_.touches.push_back(touch); }
    tl::expected<void, std::string> end_touches() const;

    /// Gives them to the path, once all keys are there.
    tl::expected<void, std::string> finish(Path& path) const;
    /// Of a use of a path, which has no tool.
    tl::expected<WorkFrame, std::string> finish_frame() const;

  private:
    WorkFrame frame_;
    std::optional<int> tool_, length_offset_, diameter_offset_;
};

}  // namespace gsim::path
