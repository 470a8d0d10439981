#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <tl/expected.hpp>

#include "base/os/files.h"
#include "runtime/script/lua/compiled_library.h"

namespace gsim::script {

/// Where the files of the library in Lua come from: built in, or a folder that a user has changed.
class Library {
  public:
    /// The files that are built in.
    Library() = default;
    /// The same, compiled once for all that share it.
    explicit Library(std::shared_ptr<CompiledLibrary> compiled) : compiled_(std::move(compiled)) {}
    /// Those of a folder of `files`, which outlive this.
    explicit Library(std::filesystem::path folder, const os::Files& files = os::disk())
        : folder_(std::move(folder)), folder_files_(&files) {}

    /// The text of one file, such as "init.lua"; the error is a sentence for the user.
    tl::expected<std::string, std::string> read(std::string_view file_name) const;

    /// Null: each file is compiled where it is needed.
    CompiledLibrary* compiled() const { return compiled_.get(); }

  private:
    std::shared_ptr<CompiledLibrary> compiled_ = nullptr;
    std::optional<std::filesystem::path> folder_;
    const os::Files* folder_files_ = nullptr;
};

}  // namespace gsim::script
