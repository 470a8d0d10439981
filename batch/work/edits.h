#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "batch/work/job.h"

namespace gsim::batch {

/// What the keys of settings begin with.
inline constexpr std::string_view kOfMachine = "machine.";
inline constexpr std::string_view kOfCell = "cell.";
inline constexpr std::string_view kOfRobots = "robots.";
inline constexpr std::string_view kOfData = "data.";
inline constexpr std::string_view kOfPath = "path.";
inline constexpr std::string_view kOfRun = "option.";

/// The settings whose keys begin so, with keys that lack it.
std::vector<SettingValue> settings_of(std::span<const SettingValue> settings, std::string_view kind);

/// Why a key is none that a setting may have; nothing where it is one.
std::string fault_of_key(const std::string& key);

/// The text of a machine file, a cell or a file of robots (TOML) with other values. Keys are names and places
/// with dots between: "axis.X.max_mm". The error is a sentence.
tl::expected<std::string, std::string> edited_toml(std::string text, const std::string& file,
                                                   std::span<const SettingValue> settings);

/// The text of machine data with other values. Keys are a section, an entry and a field: "OFFSET.54.X", in
/// the unit of the entry. The error is a sentence.
tl::expected<std::string, std::string> edited_data(std::string_view text, const std::string& file,
                                                   std::span<const SettingValue> settings);

}  // namespace gsim::batch
