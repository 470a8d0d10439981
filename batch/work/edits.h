#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "batch/work/job.h"

namespace gsim::batch {

/// Prefix of the keys of settings.
inline constexpr std::string_view kMachinePrefix = "machine.";
inline constexpr std::string_view kCellPrefix = "cell.";
inline constexpr std::string_view kRobotsPrefix = "robots.";
inline constexpr std::string_view kDataPrefix = "data.";
inline constexpr std::string_view kPathPrefix = "path.";
inline constexpr std::string_view kOptionPrefix = "option.";

/// Returns the settings with keys that have this prefix, and removes the prefix.
std::vector<SettingValue> settings_with_prefix(std::span<const SettingValue> settings,
                                               std::string_view prefix);

/// Returns an error if a setting must not have this key.
std::optional<Error> find_key_name_error(const std::string& key);

/// Returns the text of a machine file, a cell or a file of robots (TOML) with changed values. Keys are names
/// and indices separated by dots: "axis.X.max_mm".
Result<std::string> edit_toml(std::string text, const std::string& file,
                              std::span<const SettingValue> settings);

/// Returns the text of machine data with changed values. Keys are a section, an entry and a field:
/// "OFFSET.54.X", in the unit of the entry.
Result<std::string> edit_data(std::string_view text, const std::string& file,
                              std::span<const SettingValue> settings);

}  // namespace gsim::batch
