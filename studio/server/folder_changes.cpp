#include "studio/server/folder_changes.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace gsim::studio {

FolderChangesResult FolderChanges::since(std::optional<std::uint64_t> at) {
    scan_if_due();
    const std::lock_guard lock(mutex_);
    FolderChangesResult response{
        .at = at_, .is_incomplete = !at || *at < oldest_known_change_ || *at > at_, .changes = {}};
    if (response.is_incomplete || *at == at_) return response;
    for (const auto& [name, state] : files_) {
        if (state.at > *at) response.changes.push_back({name, state.tag});
    }
    return response;
}

// A caller during the walk of another thread gets the state known by then.
void FolderChanges::scan_if_due() {
    const auto is_due = [this] {
        const std::lock_guard lock(mutex_);
        return Clock::now() >= next_walk_time_;
    };
    const auto is_known = [this] {
        const std::lock_guard lock(mutex_);
        return at_ > 0;
    };
    if (!is_due()) return;
    std::unique_lock scan_lock(scan_mutex_, std::defer_lock);
    if (!is_known()) {
        scan_lock.lock();
    } else if (!scan_lock.try_lock()) {
        return;
    }
    if (is_due()) scan();
}

void FolderChanges::scan() {
    const auto began = Clock::now();
    bool is_truncated = false;
    const std::vector<os::FileEntry> found = folder_.list(limits_.max_files, is_truncated);
    compare_files(found, is_truncated);
    const Clock::duration walk_time = Clock::now() - began;
    const std::lock_guard lock(mutex_);
    next_walk_time_ = Clock::now() + std::clamp<Clock::duration>(limits_.pause_per_scan * walk_time,
                                                                 limits_.min_pause, limits_.max_pause);
}

void FolderChanges::compare_files(const std::vector<os::FileEntry>& found, bool is_truncated) {
    const std::lock_guard lock(mutex_);
    const std::uint64_t now = at_ + 1;
    bool is_changed = at_ == 0;
    const auto set = [&](State& state, std::optional<os::ContentTag> tag) {
        state = {std::move(tag), now};
        is_changed = true;
    };
    std::set<std::string_view> names;
    for (const os::FileEntry& file : found) {
        names.insert(file.name);
        State& state = files_[file.name];
        if (state.at > 0 && !state.tag) --deleted_count_;
        if (state.tag != file.tag) set(state, file.tag);
    }
    for (auto each = files_.begin(); each != files_.end();) {
        auto& [name, state] = *each;
        const bool existed = state.tag && names.count(name) == 0;
        // A cut list may omit a file because more files come before it now, so it is no longer listed.
        const bool exists_beyond_limit = existed && is_truncated && folder_.content_tag(name);
        if (existed && !exists_beyond_limit) {
            set(state, std::nullopt);
            ++deleted_count_;
        }
        each = exists_beyond_limit ? files_.erase(each) : std::next(each);
    }
    if (is_changed) at_ = now;
    if (deleted_count_ > limits_.max_files) forget_deleted();
}

void FolderChanges::forget_deleted() {
    for (auto each = files_.begin(); each != files_.end();)
        each = each->second.tag ? std::next(each) : files_.erase(each);
    deleted_count_ = 0;
    oldest_known_change_ = at_;
}

}  // namespace gsim::studio
