#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/text/nearest_name.h"
#include "toolpath/model/states.h"
#include "toolpath/placement/changes.h"

namespace gsim::path {

namespace {

/// Path that a feed comes from; nullopt: from the path that uses this one.
using Source = std::optional<std::size_t>;

/// Search for motions that inherit a feed from a path with changing feeds, while their own stay.
class FeedDependents {
  public:
    FeedDependents(const Program& program, std::size_t changed)
        : program_(program),
          changed_path_(changed),
          inherits_feed_(program.paths.size(), false),
          final_feed_path_(program.paths.size()) {}

    /// Returns the path that has such a motion; nullopt if no path has one.
    std::optional<std::size_t> find() {
        const States states(program_);
        const std::vector<std::size_t>& order = states.topological_order();
        for (auto path = order.rbegin(); path != order.rend(); ++path) visit_path(*path);
        return dependent_;
    }

  private:
    /// Expects that the paths used by this one have been visited.
    void visit_path(std::size_t path) {
        Source now;
        for (const Target& target : program_.paths[path].targets) {
            if (const auto* sub_path_call = std::get_if<SubPath>(&target)) {
                enter(path, *sub_path_call, now);
            } else if (const auto* point = std::get_if<Point>(&target)) {
                if (point->feed_mm_min) now = path;
                if (needs_feed(*point)) add_feed(path, now);
            }
        }
        final_feed_path_[path] = now;
    }

    void enter(std::size_t path, const SubPath& sub_path_call, Source& now) {
        if (inherits_feed_[sub_path_call.path]) add_feed(now ? sub_path_call.path : path, now);
        if (final_feed_path_[sub_path_call.path]) now = final_feed_path_[sub_path_call.path];
        if (inherits_feed_[sub_path_call.path] && sub_path_call.repeats > 1)
            add_feed(now ? sub_path_call.path : path, now);
    }

    /// Records that a motion of the path uses a feed from there.
    void add_feed(std::size_t path, const Source& from) {
        if (!from) inherits_feed_[path] = true;
        if (from == changed_path_ && path != changed_path_ && !dependent_) dependent_ = path;
    }

    static bool needs_feed(const Point& point) {
        const bool cuts = point.motion == MotionType::linear || point.motion == MotionType::circular;
        return cuts && !point.duration_s;
    }

    const Program& program_;
    std::size_t changed_path_;
    std::vector<bool> inherits_feed_;      // a feed of the path that uses it
    std::vector<Source> final_feed_path_;  // the feed at its end
    std::optional<std::size_t> dependent_;
};

/// Returns how many points got another feed.
std::size_t change_feeds(Path& path, const FeedChange& change) {
    std::size_t changed = 0;
    for (Target& target : path.targets) {
        auto* point = std::get_if<Point>(&target);
        if (point == nullptr || !point->feed_mm_min) continue;
        const double factor = change.is_factor ? change.value : change.value / *point->feed_mm_min;
        *point->feed_mm_min *= factor;
        if (point->feed_mm_rev) *point->feed_mm_rev *= factor;
        ++changed;
    }
    return changed;
}

std::optional<std::size_t> find_path(const Program& program, const std::string& name) {
    for (std::size_t path = 0; path < program.paths.size(); ++path) {
        if (program.paths[path].name == name) return path;
    }
    return std::nullopt;
}

std::string unknown_path_message(const Program& program, const std::string& name) {
    std::vector<std::string_view> names;
    for (const Path& path : program.paths) names.emplace_back(path.name);
    const auto nearest = text::nearest_name(name, names);
    return fmt::format("unknown path '{}'{}", name,
                       nearest ? fmt::format("; did you mean '{}'?", *nearest) : std::string());
}

}  // namespace

Result<void> change_feeds(Program& program, const FeedChange& change) {
    std::size_t changed = 0;
    if (change.path.empty()) {
        for (Path& path : program.paths) changed += change_feeds(path, change);
        if (changed == 0) return Unexpected("no point of the path has a feed");
        return {};
    }
    const auto path = find_path(program, change.path);
    if (!path) return Unexpected(unknown_path_message(program, change.path));
    if (const auto dependent = FeedDependents(program, *path).find()) {
        return Unexpected(fmt::format(
            "the feeds of '{}' cannot be changed alone: '{}' inherits a feed and needs a separate one",
            change.path, program.paths[*dependent].name));
    }
    if (change_feeds(program.paths[*path], change) == 0)
        return Unexpected(fmt::format("no point of '{}' has a feed", change.path));
    return {};
}

}  // namespace gsim::path
