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

#include "base/os/bound_folder.h"

namespace gsim::studio {

/// Limits for the frequency of walks: a walk of a large folder takes long, and walks continue as long as a
/// page is open.
struct WalkBounds {
    std::size_t most_files = 10'000;
    std::chrono::milliseconds least_pause{500};
    std::chrono::milliseconds most_pause{30'000};
    int pause_of_walk = 19;  ///< Pause after a walk, in multiples of its time: 5 % of a core.
};

/// Change of a file; without a tag: it is gone.
struct FolderChange {
    std::string name;
    std::optional<os::ContentTag> tag;
};

/// Changes since an earlier response.
struct ChangesAnswer {
    std::uint64_t at = 0;  ///< Value for the next request.
    bool again = false;    ///< Changes may be missed: all is to be listed once more.
    std::vector<FolderChange> changes;
};

/// Changes of a folder's files by other programs. The folder is walked on request, but not too often: all
/// requests share the walks. Calls may come from several threads.
class FolderChanges {
  public:
    explicit FolderChanges(os::BoundFolder folder, const WalkBounds& bounds = {})
        : folder_(std::move(folder)), bounds_(bounds) {}

    /// Returns the changes since `at`, from the previous response; no value: no previous one.
    ChangesAnswer since(std::optional<std::uint64_t> at);

  private:
    using Clock = std::chrono::steady_clock;

    struct State {
        std::optional<os::ContentTag> tag;  // no value: it is gone
        std::uint64_t at = 0;               // the walk that found it so
    };

    void walk_when_due();
    void walk();
    void take(const std::vector<os::FoundFile>& found, bool is_cut);
    void forget_gone();

    os::BoundFolder folder_;
    WalkBounds bounds_;
    std::mutex walking_;  // held during a walk
    std::mutex mutex_;    // of what follows
    Clock::time_point due_;
    std::uint64_t at_ = 0;      // the last walk that found changes; 0: none yet
    std::uint64_t oldest_ = 1;  // since when no file that is gone was forgotten
    std::map<std::string, State> files_;
    std::size_t gone_ = 0;
};

}  // namespace gsim::studio
