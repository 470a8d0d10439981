#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/os/rooted_directory.h"

namespace gsim::studio {

/// Limits for the frequency of walks: a walk of a large folder takes long, and walks continue as long as a
/// page is open.
struct ScanLimits {
    std::size_t max_files = 10'000;
    std::chrono::milliseconds min_pause{500};
    std::chrono::milliseconds max_pause{30'000};
    int pause_per_scan = 19;  ///< Pause after a walk, in multiples of its time: 5 % of a core.
};

/// Change of a file; without a tag: it is gone.
struct FolderChange {
    std::string name;
    std::optional<os::ContentTag> tag;
};

/// Changes since an earlier response.
struct FolderChangesResult {
    std::uint64_t at = 0;        ///< Value for the next request.
    bool is_incomplete = false;  ///< Changes may be missed: all is to be listed once more.
    std::vector<FolderChange> changes;
};

/// Changes of a folder's files by other programs. The folder is walked on request, but not too often: all
/// requests share the walks. Calls may come from several threads.
class FolderChanges {
  public:
    explicit FolderChanges(os::RootedDirectory folder, const ScanLimits& bounds = {})
        : folder_(std::move(folder)), limits_(bounds) {}

    /// Returns the changes since `at`, from the previous response; no value: no previous one.
    FolderChangesResult since(std::optional<std::uint64_t> at);

  private:
    using Clock = std::chrono::steady_clock;

    struct State {
        std::optional<os::ContentTag> tag;  // no value: it is gone
        std::uint64_t at = 0;               // the walk that found it so
    };

    void scan_if_due();
    void scan();
    void compare_files(const std::vector<os::FileEntry>& found, bool is_truncated);
    void forget_deleted();

    os::RootedDirectory folder_;
    ScanLimits limits_;
    std::mutex scan_mutex_;  // held during a walk
    std::mutex mutex_;       // of what follows
    Clock::time_point next_walk_time_;
    std::uint64_t at_ = 0;                   // the last walk that found changes; 0: none yet
    std::uint64_t oldest_known_change_ = 1;  // since when no file that is gone was forgotten
    std::map<std::string, State> files_;
    std::size_t deleted_count_ = 0;
};

}  // namespace gsim::studio
