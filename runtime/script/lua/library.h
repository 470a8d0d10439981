#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/os/files.h"
#include "runtime/script/lua/compiled_library_cache.h"

namespace gsim::script {

/// Source of the files of the Lua library: built in, or a folder that a user has changed.
class Library {
  public:
    /// Uses the built-in files.
    Library() = default;
    /// Uses the built-in files, compiled once for all that share it.
    explicit Library(std::shared_ptr<CompiledLibraryCache> compiled) : compiled_(std::move(compiled)) {}
    /// Uses the files of a folder of `files`, which must outlive this object.
    explicit Library(std::filesystem::path folder, const os::Files& files = os::disk())
        : folder_(std::move(folder)), folder_files_(&files) {}

    /// Returns the text of one file, such as "init.lua"; the error is a message for the user.
    Result<std::string> read(std::string_view file_name) const;

    /// Returns null if each file is compiled when it is needed.
    CompiledLibraryCache* compiled() const { return compiled_.get(); }

  private:
    std::shared_ptr<CompiledLibraryCache> compiled_ = nullptr;
    std::optional<std::filesystem::path> folder_;
    const os::Files* folder_files_ = nullptr;
};

}  // namespace gsim::script
