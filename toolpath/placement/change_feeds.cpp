#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/text/nearest_name.h"
#include "toolpath/model/states.h"
#include "toolpath/placement/changes.h"

namespace gsim::path {

namespace {

using FeedFault = tl::unexpected<std::string>;

/// Path that a feed comes from; nullopt: from the path that uses this one.
using Source = std::optional<std::size_t>;

/// Search for motions that inherit a feed from a path with changing feeds, while their own stay.
class Heirs {
  public:
    Heirs(const Program& program, std::size_t changed)
        : program_(program),
          changed_(changed),
          takes_(program.paths.size(), false),
          leaves_(program.paths.size()) {}

    /// Returns the path that has such a motion; nullopt if no path has one.
    std::optional<std::size_t> find() {
        const States states(program_);
        const std::vector<std::size_t>& order = states.users_first();
        for (auto path = order.rbegin(); path != order.rend(); ++path) go_through(*path);
        return heir_;
    }

  private:
    /// Expects that the paths used by this one have been visited.
    void go_through(std::size_t path) {
        Source now;
        for (const Target& target : program_.paths[path].targets) {
            if (const auto* use = std::get_if<SubPath>(&target)) {
                enter(path, *use, now);
            } else if (const auto* point = std::get_if<Point>(&target)) {
                if (point->feed_mm_min) now = path;
                if (needs_feed(*point)) take(path, now);
            }
        }
        leaves_[path] = now;
    }

    void enter(std::size_t path, const SubPath& use, Source& now) {
        if (takes_[use.path]) take(now ? use.path : path, now);
        if (leaves_[use.path]) now = leaves_[use.path];
        if (takes_[use.path] && use.repeats > 1) take(now ? use.path : path, now);
    }

    /// Records that a motion of the path uses a feed from there.
    void take(std::size_t path, const Source& from) {
        if (!from) takes_[path] = true;
        if (from == changed_ && path != changed_ && !heir_) heir_ = path;
    }

    static bool needs_feed(const Point& point) {
        const bool cuts = point.motion == MotionType::linear || point.motion == MotionType::circular;
        return cuts && !point.duration_s;
    }

    const Program& program_;
    std::size_t changed_;
    std::vector<bool> takes_;     // a feed of the path that uses it
    std::vector<Source> leaves_;  // the feed after it
    std::optional<std::size_t> heir_;
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

std::string unknown_path(const Program& program, const std::string& name) {
    std::vector<std::string_view> names;
    for (const Path& path : program.paths) names.emplace_back(path.name);
    const auto nearest = text::nearest_name(name, names);
    return fmt::format("there is no path '{}'{}", name,
                       nearest ? fmt::format("; did you mean '{}'?", *nearest) : std::string());
}

}  // namespace

tl::expected<void, std::string> change_feeds(Program& program, const FeedChange& change) {
    std::size_t changed = 0;
    if (change.path.empty()) {
        for (Path& path : program.paths) changed += change_feeds(path, change);
        if (changed == 0) return FeedFault("no point of the path has a feed");
        return {};
    }
    const auto path = find_path(program, change.path);
    if (!path) return FeedFault(unknown_path(program, change.path));
    if (const auto heir = Heirs(program, *path).find()) {
        return FeedFault(
            fmt::format("the feeds of '{}' cannot be changed alone: '{}' takes one over, and should have "
                        "its own",
                        change.path, program.paths[*heir].name));
    }
    if (change_feeds(program.paths[*path], change) == 0)
        return FeedFault(fmt::format("no point of '{}' has a feed", change.path));
    return {};
}

}  // namespace gsim::path
