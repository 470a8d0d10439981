#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "base/os/files.h"

namespace gsim::import {

/// A line KEY = VALUE of an INI file.
struct IniEntry {
    std::string file;
    std::string section;
    std::string key;
    std::string value;
    std::size_t line = 1;
    bool taken = false;  ///< Somebody has asked for it.
};

/// An INI file as LinuxCNC writes it: [SECTION], KEY = VALUE, remarks in lines of their own, `\` at the end
/// of a line that goes on. Sections and keys are found whatever their case. It remembers what was asked for.
class IniFile {
  public:
    /// `path` is for errors, and for files that `#INCLUDE NAME` puts in its place, which are looked for in
    /// its folder. The error is "file:line: sentence".
    static tl::expected<IniFile, std::string> read(std::string_view text, const std::filesystem::path& path,
                                                   const os::Files& files);

    const std::string& file_name() const { return file_name_; }
    bool has_section(std::string_view section) const;
    /// The first entry of that name, which counts as taken from now on; null where there is none.
    const IniEntry* find(std::string_view section, std::string_view key);
    std::optional<std::string> text(std::string_view section, std::string_view key);
    /// A number; nothing where there is none. What is no number is an error, "file:line: sentence".
    tl::expected<std::optional<double>, std::string> number(std::string_view section, std::string_view key);
    /// "file:line: sentence".
    std::string at(const IniEntry& entry, std::string_view sentence) const;
    const std::vector<IniEntry>& entries() const { return entries_; }

  private:
    using Done = tl::expected<void, std::string>;
    /// Where an included file stands.
    struct Inclusion {
        const os::Files& files;
        std::string& section;
        int depth;
    };
    Done add(std::string_view text, const std::filesystem::path& path, const Inclusion& in);
    Done add_included(std::string_view name, const std::filesystem::path& folder, const Inclusion& in);

    std::string file_name_;
    std::vector<IniEntry> entries_;
    std::size_t included_ = 0;  ///< Files, counted as often as they are.
};

/// A number of such a file, whole: nothing where `text` is none.
std::optional<double> plain_number(std::string_view text);

/// To 1e-9: 3 inches are 76.2 mm, not 76.19999999999999.
double without_noise(double value);

/// Without blanks at both ends.
std::string_view trimmed_text(std::string_view text);

}  // namespace gsim::import
