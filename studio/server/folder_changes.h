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

/// How often a folder is walked: a walk of a large one takes long, and goes on as long as a page is open.
struct WalkBounds {
    std::size_t most_files = 10'000;
    std::chrono::milliseconds least_pause{500};
    std::chrono::milliseconds most_pause{30'000};
    int pause_of_walk = 19;  ///< The pause behind a walk, in times of what it took: 5 % of a core.
};

/// What has become of a file; without a tag: it is gone.
struct FolderChange {
    std::string name;
    std::optional<os::ContentTag> tag;
};

/// What has changed since another answer.
struct ChangesAnswer {
    std::uint64_t at = 0;  ///< What is asked for next time.
    bool again = false;    ///< Changes may be missed: all is to be listed once more.
    std::vector<FolderChange> changes;
};

/// Which files of a folder other programs have changed. The folder is walked when somebody asks, and not too
/// often: all who ask share the walks. Calls may come from several threads.
class FolderChanges {
  public:
    explicit FolderChanges(os::BoundFolder folder, const WalkBounds& bounds = {})
        : folder_(std::move(folder)), bounds_(bounds) {}

    /// `at`: of the answer before; nothing: there is none.
    ChangesAnswer since(std::optional<std::uint64_t> at);

  private:
    using Clock = std::chrono::steady_clock;

    struct State {
        std::optional<os::ContentTag> tag;  // nothing: it is gone
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
