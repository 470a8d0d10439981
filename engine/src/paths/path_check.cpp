#include "engine/src/paths/path_check.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/text/format.h"
#include "codegen/post/gcode_writer.h"

namespace gsim::engine {

namespace {

constexpr std::size_t kMaxNotes = 20;
constexpr std::size_t kMaxNames = 8;  // in an error

// Returns true if an action only shows a message to people, without any effect.
bool is_message_action(std::string_view action) {
    constexpr std::array<std::string_view, 11> kMessageActions = {
        "message",  "print",      "print_open", "print_close", "debug",      "log",
        "log_open", "log_append", "log_close",  "probe_open",  "probe_close"};
    const std::string_view kind = action.substr(0, action.find(' '));
    return std::find(kMessageActions.begin(), kMessageActions.end(), kind) != kMessageActions.end();
}

}  // namespace

void PathCheck::move(const path::AxisMove& move) {
    if (move.duration_s) post_.feed_modes.inverse_time.empty() ? ++mean_feeds_ : ++feed_modes_;
    if (move.feed_mm_rev) post_.feed_modes.per_revolution.empty() ? ++per_minute_ : ++feed_modes_;
    if (move.lead_mm && post_.thread.code.empty())
        ++unsupported_actions_["a line synchronized with the spindle"];
    if (move.lead_mm && uses_machine_coordinates_)
        ++unsupported_actions_["a line synchronized with the spindle, in machine coordinates"];
}

void PathCheck::action(const std::string& name) {
    if (name == codegen::kStandstillAction || words_.find_block(name, 1)) return;
    ++(is_message_action(name) ? message_actions_ : unsupported_actions_)[fmt::format("'{}'", name)];
}

void PathCheck::note(const path::TargetId& where, std::string_view message) {
    if (++count_ <= kMaxNotes) notes_.push_back(file_.with_location(where, std::string(message)));
}

Result<PathCheck::PathSummary> PathCheck::finish() {
    if (count_ > kMaxNotes) notes_.push_back(fmt::format("{} more notes of this kind", count_ - kMaxNotes));
    if (accelerations_ > 0 && post_.acceleration.set.empty()) {
        notes_.push_back(
            fmt::format("'acceleration_mm_s2' of {} points is not written: the post '{}' has no words for it",
                        accelerations_, post_.name));
    }
    if (retracts_ > 0 && post_.offsets.machine.empty()) {
        notes_.push_back(fmt::format(
            "the tool does not retract {} times for a tool change, another work offset or a reference point: "
            "the post '{}' has no word for machine coordinates ([offsets] machine)",
            retracts_, post_.name));
    }
    add_feed_notes();
    if (!keep_going_ && !unsupported_actions_.empty()) return tl::unexpected(error());
    for (const auto* list : {&message_actions_, &unsupported_actions_}) {
        for (const auto& [name, count] : *list) {
            notes_.push_back(
                fmt::format("{} is written as a comment, {} times: the post '{}' has no block for it", name,
                            count, post_.name));
        }
    }
    return PathSummary{std::move(notes_), feed_modes_ > 0, accelerations_ > 0, retracts_ > 0};
}

void PathCheck::add_feed_notes() {
    if (mean_feeds_ > 0) {
        notes_.push_back(
            fmt::format("times of {} moves are written as feeds: the post '{}' has no inverse time feed",
                        mean_feeds_, post_.name));
    }
    if (per_minute_ > 0) {
        notes_.push_back(
            fmt::format("feeds per revolution of {} moves are written per minute: the post '{}' has no feed "
                        "per revolution",
                        per_minute_, post_.name));
    }
}

std::string PathCheck::error() const {
    std::vector<std::string> names;
    for (const auto& [name, count] : unsupported_actions_) {
        if (names.size() == kMaxNames) break;
        names.push_back(count == 1 ? name : fmt::format("{} ({} times)", name, count));
    }
    const std::size_t more = unsupported_actions_.size() - names.size();
    return fmt::format("the post '{}' has no words for {}{}; with --continue-on-unknown they become comments",
                       post_.name, text::joined(names, ", "),
                       more > 0 ? fmt::format(" and {} more", more) : "");
}

}  // namespace gsim::engine
