#include "studio/server/folder_changes.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace gsim::studio {

ChangesAnswer FolderChanges::since(std::optional<std::uint64_t> at) {
    walk_when_due();
    const std::lock_guard lock(mutex_);
    ChangesAnswer answer{.at = at_, .again = !at || *at < oldest_ || *at > at_, .changes = {}};
    if (answer.again || *at == at_) return answer;
    for (const auto& [name, state] : files_) {
        if (state.at > *at) answer.changes.push_back({name, state.tag});
    }
    return answer;
}

// A caller during the walk of another thread gets the state known by then.
void FolderChanges::walk_when_due() {
    const auto is_due = [this] {
        const std::lock_guard lock(mutex_);
        return Clock::now() >= due_;
    };
    const auto is_known = [this] {
        const std::lock_guard lock(mutex_);
        return at_ > 0;
    };
    if (!is_due()) return;
    std::unique_lock walking(walking_, std::defer_lock);
    if (!is_known()) {
        walking.lock();
    } else if (!walking.try_lock()) {
        return;
    }
    if (is_due()) walk();
}

void FolderChanges::walk() {
    const auto began = Clock::now();
    bool is_cut = false;
    const std::vector<os::FoundFile> found = folder_.list(bounds_.most_files, is_cut);
    take(found, is_cut);
    const Clock::duration took = Clock::now() - began;
    const std::lock_guard lock(mutex_);
    due_ = Clock::now() +
           std::clamp<Clock::duration>(bounds_.pause_of_walk * took, bounds_.least_pause, bounds_.most_pause);
}

void FolderChanges::take(const std::vector<os::FoundFile>& found, bool is_cut) {
    const std::lock_guard lock(mutex_);
    const std::uint64_t now = at_ + 1;
    bool is_changed = at_ == 0;
    const auto set = [&](State& state, std::optional<os::ContentTag> tag) {
        state = {std::move(tag), now};
        is_changed = true;
    };
    std::set<std::string_view> names;
    for (const os::FoundFile& file : found) {
        names.insert(file.name);
        State& state = files_[file.name];
        if (state.at > 0 && !state.tag) --gone_;
        if (state.tag != file.tag) set(state, file.tag);
    }
    for (auto each = files_.begin(); each != files_.end();) {
        auto& [name, state] = *each;
        const bool was_there = state.tag && names.count(name) == 0;
        // A cut list may omit a file because more files come before it now, so it is no longer listed.
        const bool is_beyond = was_there && is_cut && folder_.tag_of(name);
        if (was_there && !is_beyond) {
            set(state, std::nullopt);
            ++gone_;
        }
        each = is_beyond ? files_.erase(each) : std::next(each);
    }
    if (is_changed) at_ = now;
    if (gone_ > bounds_.most_files) forget_gone();
}

void FolderChanges::forget_gone() {
    for (auto each = files_.begin(); each != files_.end();)
        each = each->second.tag ? std::next(each) : files_.erase(each);
    gone_ = 0;
    oldest_ = at_;
}

}  // namespace gsim::studio
