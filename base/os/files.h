#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "base/os/input_file.h"

namespace gsim::os {

/// Files that are read by their names: those of the system, or what a program hands out in their place.
/// Readers take what lies beside a file from where the file came from.
class Files {
  public:
    virtual ~Files() = default;

    /// All bytes of a file of up to `max_bytes`, whole MiB. The error is a sentence with its name.
    virtual tl::expected<std::string, std::string> read(const std::filesystem::path& path, NamedBy named_by,
                                                        std::size_t max_bytes) const = 0;
    /// Why a file cannot be there to read ("No such file or directory"), without reading it; nothing where it
    /// may be.
    virtual std::optional<std::string> find_fault(const std::filesystem::path& path) const = 0;
    /// Whether there is a regular file of this name.
    virtual bool has(const std::filesystem::path& path) const = 0;
    /// Whether there is nothing of this name. What cannot be looked at may be there: reading it tells why.
    virtual bool is_absent(const std::filesystem::path& path) const = 0;
    /// Whether two names are one file.
    virtual bool are_one(const std::filesystem::path& a, const std::filesystem::path& b) const = 0;
    /// Whether a file that is named within a folder lies within it, wherever links lead.
    virtual bool is_within(const std::filesystem::path& folder, const std::filesystem::path& name) const = 0;
    /// Whether they are the system's, which may be read piece by piece.
    virtual bool are_of_system() const { return false; }

    /// The bytes of a small file written by hand (at most 4 MiB). The error is a sentence that names the
    /// file.
    tl::expected<std::string, std::string> read_text(const std::filesystem::path& path,
                                                     NamedBy named_by = NamedBy::a_file) const;
};

/// The files of the system.
const Files& disk();

/// Files by a function from name to bytes; nothing where it knows no such file. Names are those that files
/// give of each other, normal ("cell/table.toml", not "cell/./table.toml").
class GivenFiles final : public Files {
  public:
    using Give = std::function<std::optional<std::string>(const std::string& name)>;

    explicit GivenFiles(Give give) : give_(std::move(give)) {}

    tl::expected<std::string, std::string> read(const std::filesystem::path& path, NamedBy named_by,
                                                std::size_t max_bytes) const override;
    /// Nothing: what is not there is told where it is read.
    std::optional<std::string> find_fault(const std::filesystem::path& path) const override;
    bool has(const std::filesystem::path& path) const override;
    bool is_absent(const std::filesystem::path& path) const override { return !has(path); }
    bool are_one(const std::filesystem::path& a, const std::filesystem::path& b) const override;
    bool is_within(const std::filesystem::path& folder, const std::filesystem::path& name) const override;

  private:
    Give give_;
};

}  // namespace gsim::os
