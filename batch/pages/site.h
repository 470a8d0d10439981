#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_set>

#include <tl/expected.hpp>

namespace gsim::batch {

/// A folder with pages of ours, and maybe with files of others, which stay as they are.
class Site {
  public:
    /// Makes the folder where there is none. The error is a sentence that names it.
    static tl::expected<Site, std::string> open(const std::string& folder);

    /// Writes a page, which appears as a whole; one that is there already, byte for byte, stays untouched.
    /// The error is a sentence with the name of the file: it cannot be written, or it is not one of ours.
    tl::expected<void, std::string> put(const std::string& name, std::string_view page);
    /// Removes the pages of ours that were not put.
    tl::expected<void, std::string> remove_others();

  private:
    explicit Site(std::filesystem::path folder) : folder_(std::move(folder)) {}

    std::filesystem::path folder_;
    std::unordered_set<std::string> names_;
};

/// Removes the pages of a folder (.html) of which `is_one` is true; it is given the name
/// and the first bytes. Links are no such files, and a folder that is not there has none. The error is a
/// sentence.
tl::expected<void, std::string> remove_files(
    const std::filesystem::path& folder,
    const std::function<bool(const std::string& name, std::string_view head)>& is_one);

}  // namespace gsim::batch
