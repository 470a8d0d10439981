#include "engine/src/paths/path_check.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/text/format.h"
#include "codegen/post/gcode_writer.h"

namespace gsim::engine {

namespace {

constexpr std::size_t kMostNotes = 20;
constexpr std::size_t kMostNames = 8;  // in an error

// Returns true if an action only shows a message to people, without any effect.
bool is_said(std::string_view action) {
    constexpr std::array<std::string_view, 11> kSaid = {
        "message",  "print",      "print_open", "print_close", "debug",      "log",
        "log_open", "log_append", "log_close",  "probe_open",  "probe_close"};
    const std::string_view kind = action.substr(0, action.find(' '));
    return std::find(kSaid.begin(), kSaid.end(), kind) != kSaid.end();
}

}  // namespace

void PathCheck::move(const path::AxisMove& move) {
    if (move.duration_s) post_.feed_modes.inverse_time.empty() ? ++mean_feeds_ : ++feed_modes_;
    if (move.feed_mm_rev) post_.feed_modes.per_revolution.empty() ? ++per_minute_ : ++feed_modes_;
    if (move.lead_mm && post_.thread.empty()) ++without_word_["a line in step with the spindle"];
    if (move.lead_mm && in_machine_)
        ++without_word_["a line in step with the spindle, in machine coordinates"];
}

void PathCheck::action(const std::string& name) {
    if (name == codegen::kRest || words_.block_of(name, 1)) return;
    ++(is_said(name) ? said_ : without_word_)[fmt::format("'{}'", name)];
}

void PathCheck::note(const path::TargetId& where, std::string_view sentence) {
    if (++count_ <= kMostNotes) notes_.push_back(file_.located(where, std::string(sentence)));
}

tl::expected<PathCheck::Found, std::string> PathCheck::finish() {
    if (count_ > kMostNotes) notes_.push_back(fmt::format("{} more notes of this kind", count_ - kMostNotes));
    if (accelerations_ > 0 && post_.acceleration.empty()) {
        notes_.push_back(
            fmt::format("'acceleration_mm_s2' of {} points is not written: the post '{}' has no words for it",
                        accelerations_, post_.name));
    }
    if (retracts_ > 0 && post_.offsets.machine.empty()) {
        notes_.push_back(fmt::format(
            "the tool does not go up {} times to be changed, to another work offset or on the way "
            "of a reference point: the post '{}' has no word for machine coordinates ([offsets] "
            "machine)",
            retracts_, post_.name));
    }
    note_feeds();
    if (!go_on_ && !without_word_.empty()) return tl::unexpected(refusal());
    for (const auto* list : {&said_, &without_word_}) {
        for (const auto& [name, count] : *list) {
            notes_.push_back(fmt::format("{} is a comment, {} times: the post '{}' has no block for it", name,
                                         count, post_.name));
        }
    }
    return Found{std::move(notes_), feed_modes_ > 0, accelerations_ > 0, retracts_ > 0};
}

void PathCheck::note_feeds() {
    if (mean_feeds_ > 0) {
        notes_.push_back(
            fmt::format("times of {} moves are written as feeds: the post '{}' has no inverse time feed",
                        mean_feeds_, post_.name));
    }
    if (per_minute_ > 0) {
        notes_.push_back(fmt::format(
            "feeds per revolution of {} moves are written per minute: the post '{}' has no others",
            per_minute_, post_.name));
    }
}

std::string PathCheck::refusal() const {
    std::vector<std::string> names;
    for (const auto& [name, count] : without_word_) {
        if (names.size() == kMostNames) break;
        names.push_back(count == 1 ? name : fmt::format("{} ({} times)", name, count));
    }
    const std::size_t more = without_word_.size() - names.size();
    return fmt::format("the post '{}' has no words for {}{}; with --go-on they become comments", post_.name,
                       text::joined(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

}  // namespace gsim::engine
