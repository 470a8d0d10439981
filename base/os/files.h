#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "base/error.h"
#include "base/os/input_file.h"

namespace gsim::os {

/// Files that are read by name: those of the system, or those that a program supplies instead. Readers get
/// the files next to a file from its source.
class Files {
  public:
    virtual ~Files() = default;

    /// Returns all bytes of a file of up to `max_bytes`, a multiple of 1 MiB. The error is a message with its
    /// name.
    virtual Result<std::string> read(const std::filesystem::path& path, NameSource name_source,
                                     std::size_t max_bytes) const = 0;
    /// Returns an error if a file cannot exist for reading ("No such file or directory"), without reading it.
    virtual std::optional<Error> find_error(const std::filesystem::path& path) const = 0;
    /// True if a regular file of this name exists.
    virtual bool has(const std::filesystem::path& path) const = 0;
    /// True if no file of this name exists. A file that cannot be checked may exist; reading it reports the
    /// error.
    virtual bool is_absent(const std::filesystem::path& path) const = 0;
    /// True if two names refer to one file.
    virtual bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) const = 0;
    /// True if a file that is named within a folder is located in it, wherever links lead.
    virtual bool is_within(const std::filesystem::path& folder, const std::filesystem::path& name) const = 0;
    /// True if they are the system's files, which may be read in parts.
    virtual bool are_system_files() const { return false; }

    /// Returns the bytes of a small file written by hand (at most 4 MiB). The error is a message that names
    /// the file.
    Result<std::string> read_text(const std::filesystem::path& path,
                                  NameSource name_source = NameSource::in_file) const;
};

/// Returns the files of the system.
const Files& disk();

/// Files supplied by a function from name to bytes, which returns nothing for an unknown name. The names are
/// those that files use for each other, normalized ("cell/table.toml", not "cell/./table.toml").
class CallbackFiles final : public Files {
  public:
    using FileProvider = std::function<std::optional<std::string>(const std::string& name)>;

    explicit CallbackFiles(FileProvider provider) : provider_(std::move(provider)) {}

    Result<std::string> read(const std::filesystem::path& path, NameSource name_source,
                             std::size_t max_bytes) const override;
    /// Returns nothing, because a missing file is reported when it is read.
    std::optional<Error> find_error(const std::filesystem::path& path) const override;
    bool has(const std::filesystem::path& path) const override;
    bool is_absent(const std::filesystem::path& path) const override { return !has(path); }
    bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) const override;
    bool is_within(const std::filesystem::path& folder, const std::filesystem::path& name) const override;

  private:
    FileProvider provider_;
};

}  // namespace gsim::os
