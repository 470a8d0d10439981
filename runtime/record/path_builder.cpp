#include "runtime/record/path_builder.h"

#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "base/bits.h"
#include "runtime/record/action_name.h"

namespace gsim::record {

using path::Point;
using path::SubPath;
using path::Target;

namespace {

std::size_t mixed(std::size_t hash, std::uint64_t value) {
    return (hash ^ value) * 0x100000001b3ULL;  // FNV-1a, by words
}

std::size_t combined_hash(std::size_t hash, const Point& point) {
    for (const double value : point.position_mm) hash = mixed(hash, bits_as<std::uint64_t>(value));
    return mixed(hash, bits_as<std::uint64_t>(point.feed_mm_min.value_or(0)));
}

std::size_t combined_hash(std::size_t hash, const SubPath& sub_path) {
    return mixed(mixed(hash, sub_path.path), static_cast<std::uint64_t>(sub_path.repeats));
}

// A run has no such point.
std::size_t combined_hash(std::size_t hash, const path::MachinePoint& point) {
    return mixed(hash, static_cast<std::uint64_t>(point.number));
}

std::size_t combined_hash(const std::vector<Target>& targets) {
    std::size_t hash = 0xcbf29ce484222325ULL;
    for (const Target& target : targets) {
        hash = std::visit([hash](const auto& each) { return combined_hash(hash, each); }, target);
    }
    return hash;
}

}  // namespace

void PathBuilder::begin_call(const std::string& name) {
    if (excess_depth_ > 0 || open_calls_.size() > static_cast<std::size_t>(path::kMaxDepth)) {
        ++excess_depth_;
        return;
    }
    open_calls_.push_back({sanitized_name(name), {}, {}});
}

void PathBuilder::end_call() {
    if (excess_depth_ > 0) {
        --excess_depth_;
        return;
    }
    if (open_calls_.size() < 2) return;
    Call call = std::move(open_calls_.back());
    open_calls_.pop_back();
    if (call.targets.empty()) return;
    const std::size_t path = find_or_add_path(std::move(call));
    std::vector<Target>& caller = open_calls_.back().targets;
    auto* last = caller.empty() ? nullptr : std::get_if<SubPath>(&caller.back());
    if (last != nullptr && last->path == path) {
        ++last->repeats;
        return;
    }
    caller.emplace_back(SubPath{path, 1});
    ++targets_;
}

std::size_t PathBuilder::retained_bytes() const {
    // Vectors grow to twice their content; rotary axes are in a map of, say, two.
    constexpr std::size_t kBytesOfTarget = sizeof(Target) * 3 / 2 + std::size_t{2} * 64;
    return targets_ * kBytesOfTarget;
}

Point* PathBuilder::last_point() {
    return at_beginning() ? nullptr : std::get_if<Point>(&open_calls_.back().targets.back());
}

void PathBuilder::add(Point point) {
    open_calls_.back().targets.emplace_back(std::move(point));
    ++targets_;
}

// Returns the path that such an earlier call has left, or a new one.
std::size_t PathBuilder::find_or_add_path(Call call) {
    const std::size_t hash = combined_hash(call.targets);
    const auto [first, last] = by_hash_.equal_range(hash);
    for (auto each = first; each != last; ++each) {
        const Origin& origin = origins_[each->second];
        if (origin.name == call.name && origin.start == call.start &&
            program_.paths[each->second].targets == call.targets) {
            targets_ -= call.targets.size();
            return each->second;
        }
    }
    const std::size_t path = add_path(std::move(call));
    by_hash_.emplace(hash, path);
    return path;
}

std::size_t PathBuilder::add_path(Call call) {
    program_.paths.push_back({unique_name(call.name), std::move(call.targets)});
    origins_.push_back({std::move(call.name), std::move(call.start)});
    return program_.paths.size() - 1;
}

std::string PathBuilder::unique_name(const std::string& name) {
    const std::string& base = name.empty() ? "path" : name;
    std::string free = base;
    for (int& copies = name_counts_[base]; !names_.insert(free).second;) {
        free = fmt::format("{} ({})", base, ++copies + 1);
    }
    return free;
}

path::Program PathBuilder::finish(const std::string& name) {
    excess_depth_ = 0;
    while (open_calls_.size() > 1) end_call();
    Call root = std::move(open_calls_.back());
    root.name = sanitized_name(name);
    program_.name = root.name;
    program_.root = add_path(std::move(root));
    return std::move(program_);
}

}  // namespace gsim::record
