#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace gsim::script {

/// Where the files of the library in Lua come from: built in, or a folder that a user has changed.
class Library {
  public:
    /// The files that are built in.
    Library() = default;
    explicit Library(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The text of one file, such as "init.lua"; the error is a sentence for the user.
    tl::expected<std::string, std::string> read(std::string_view file_name) const;

  private:
    std::optional<std::filesystem::path> folder_;
};

}  // namespace gsim::script
