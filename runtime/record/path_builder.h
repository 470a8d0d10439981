#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "toolpath/model/path.h"

namespace gsim::record {

/// Where the tool stands.
struct Stand {
    path::Vector position_mm{};
    std::optional<path::Orientation> orientation;

    bool operator==(const Stand&) const = default;
};

/// Puts points and calls, in the order of a run, together to a program of paths. A call that runs through the
/// same targets as an earlier one of that name uses its path; other calls become paths of their own. Calls
/// that are nested deeper than paths may be go into the path that calls them.
class PathBuilder {
  public:
    PathBuilder() : open_(1) {}

    /// A call of a program of that name, which may be any, and its end. Calls without targets leave nothing.
    void begin_call(const std::string& name);
    void end_call();

    /// Whether the path that targets now go to has none yet.
    bool at_beginning() const { return open_.back().targets.empty(); }
    /// Whether any path has a target.
    bool has_targets() const { return targets_ > 0; }
    std::size_t target_count() const { return targets_; }
    /// About the memory of all targets.
    std::size_t held_bytes() const;
    /// The last target, if it is a point.
    path::Point* last_point();
    void add(path::Point point);
    /// The first motion of this path depends on where it starts: the path serves calls from there alone.
    void depends_on(Stand start) { open_.back().start = std::move(start); }

    /// Ends the calls that are open and gives the program away. There must be a target.
    path::Program finish(const std::string& name);

  private:
    /// A path whose call has not ended, or what distinguishes one that has.
    struct Call {
        std::string name;
        std::vector<path::Target> targets;
        std::optional<Stand> start;
    };
    /// Of a path in program_: the name it was called by, and what it depends on.
    struct Origin {
        std::string name;
        std::optional<Stand> start;
    };

    std::size_t path_of(Call call);
    std::size_t add_path(Call call);
    std::string free_name(const std::string& name);

    path::Program program_;
    std::vector<Origin> origins_;                                // one for each path
    std::unordered_multimap<std::size_t, std::size_t> by_hash_;  // of targets, to the index of the path
    std::unordered_map<std::string, int> copies_;                // of each name
    std::set<std::string> names_;
    std::vector<Call> open_;  // the root first
    int too_deep_ = 0;        // calls that are open beyond these
    std::size_t targets_ = 0;
};

}  // namespace gsim::record
