#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_set>

#include "base/error.h"

namespace gsim::batch {

/// Folder with our pages, and possibly with foreign files, which stay unchanged.
class Site {
  public:
    /// Creates the folder if it does not exist. The error is a message that names it.
    static Result<Site> open(const std::string& folder);

    /// Writes a page, which appears only when complete. An identical existing page, byte for byte, stays
    /// untouched. The error is a message with the name of the file: it cannot be written, or it is not one of
    /// ours.
    Result<void> save(const std::string& name, std::string_view page);
    /// Removes our pages that were not written in this run.
    Result<void> remove_stale_pages();

  private:
    explicit Site(std::filesystem::path folder) : folder_(std::move(folder)) {}

    std::filesystem::path folder_;
    std::unordered_set<std::string> names_;
};

/// Removes the pages of a folder (.html) for which `should_remove` returns true; it receives the name and the
/// first bytes. Links are skipped, and a missing folder has no pages.
Result<void> remove_files(
    const std::filesystem::path& folder,
    const std::function<bool(const std::string& name, std::string_view head)>& should_remove);

}  // namespace gsim::batch
