#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "toolpath/model/path.h"

namespace gsim::record {

/// Pose of the tool.
struct ToolState {
    path::Vector position_mm{};
    std::optional<path::Orientation> orientation;

    bool operator==(const ToolState&) const = default;
};

/// Builder of a program of paths from points and calls, in the order of a run. A call with the same targets
/// as an earlier one of that name uses its path; other calls become separate paths. Calls that are nested
/// deeper than paths may be are written into the path that calls them.
class PathBuilder {
  public:
    PathBuilder() : open_calls_(1) {}

    /// Begins a call of a program of that name, which may be any; end_call() ends it. Calls without targets
    /// leave no path.
    void begin_call(const std::string& name);
    void end_call();

    /// Returns true if the path that currently gets targets has none yet.
    bool at_beginning() const { return open_calls_.back().targets.empty(); }
    /// Returns true if any path has a target.
    bool has_targets() const { return targets_ > 0; }
    std::size_t target_count() const { return targets_; }
    /// Returns the approximate memory of all targets.
    std::size_t retained_bytes() const;
    /// Returns the last target, if it is a point.
    path::Point* last_point();
    void add(path::Point point);
    /// Records that the first motion of this path depends on its start: the path serves only calls from
    /// there.
    void depends_on(ToolState start) { open_calls_.back().start = std::move(start); }

    /// Ends the open calls and returns the program, which must have a target.
    path::Program finish(const std::string& name);

  private:
    /// Path with a call that has not ended, or the distinctive data of one that has.
    struct Call {
        std::string name;
        std::vector<path::Target> targets;
        std::optional<ToolState> start;
    };
    /// Origin of a path in program_: the name it was called by, and its dependency.
    struct Origin {
        std::string name;
        std::optional<ToolState> start;
    };

    std::size_t find_or_add_path(Call call);
    std::size_t add_path(Call call);
    std::string unique_name(const std::string& name);

    path::Program program_;
    std::vector<Origin> origins_;                                // one for each path
    std::unordered_multimap<std::size_t, std::size_t> by_hash_;  // of targets, to the index of the path
    std::unordered_map<std::string, int> name_counts_;           // of each name
    std::set<std::string> names_;
    std::vector<Call> open_calls_;  // the root first
    int excess_depth_ = 0;          // calls that are open beyond these
    std::size_t targets_ = 0;
};

}  // namespace gsim::record
