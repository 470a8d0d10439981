#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/os/files.h"

namespace gsim::import {

/// A line KEY = VALUE of an INI file.
struct IniEntry {
    std::string file;
    std::string section;
    std::string key;
    std::string value;
    std::size_t line = 1;
    bool is_used = false;  ///< Somebody has asked for it.
};

/// An INI file as LinuxCNC writes it: [SECTION], KEY = VALUE, remarks on separate lines, `\` at the end of a
/// line that continues. Sections and keys are found whatever their case. It records the queried entries.
class IniFile {
  public:
    /// Reads a file. `path` is for errors, and for files that `#INCLUDE NAME` inserts, which are searched in
    /// its folder. The error is "file:line: message".
    static Result<IniFile> read(std::string_view text, const std::filesystem::path& path,
                                const os::Files& files);

    const std::string& file_name() const { return file_name_; }
    bool has_section(std::string_view section) const;
    /// Returns the first entry of that name, which counts as taken from now on; null if it does not exist.
    const IniEntry* find(std::string_view section, std::string_view key);
    std::optional<std::string> text(std::string_view section, std::string_view key);
    /// Returns a number, or nothing if the entry does not exist. A value that is not a number is an error,
    /// "file:line: message".
    Result<std::optional<double>> number(std::string_view section, std::string_view key);
    /// Returns "file:line: message".
    std::string at(const IniEntry& entry, std::string_view message) const;
    const std::vector<IniEntry>& entries() const { return entries_; }

  private:
    /// Position of an included file.
    struct IncludeContext {
        const os::Files& files;
        std::string& section;
        int depth;
    };
    Result<void> add(std::string_view text, const std::filesystem::path& path, const IncludeContext& in);
    Result<void> add_included(std::string_view name, const std::filesystem::path& folder,
                              const IncludeContext& in);

    std::string file_name_;
    std::vector<IniEntry> entries_;
    std::size_t include_count_ = 0;  ///< Files, counted as often as they are.
};

/// Returns a number of such a file if it is the complete `text`, else nothing.
std::optional<double> parse_number_text(std::string_view text);

/// Returns the value rounded to 1e-9: 3 inches are 76.2 mm, not 76.19999999999999.
double remove_rounding_noise(double value);

/// Returns the text without blanks at both ends.
std::string_view trimmed_text(std::string_view text);

}  // namespace gsim::import
