#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "base/text/json.h"

namespace gsim::batch {

/// What becomes of the value that a file has.
enum class SettingUse : std::uint8_t {
    set,     ///< The setting's value takes its place,
    factor,  ///< is multiplied with it,
    shift,   ///< or added to it.
};

/// One value of a setting. Its key says of what: `machine.axis.X.max_speed_mm_s` of the machine file (an
/// element of a list by its place, its letter or its name), `cell.object.post.frame.x_mm` of the cell file,
/// `robots.robot.left.base.x_mm` of the file of robots, `data.OFFSET.54.X` of the machine data,
/// `path.place.x_mm` of a path, `option.feed_override_percent` of the run.
struct SettingValue {
    std::string key;
    nlohmann::json value;
    SettingUse use = SettingUse::set;

    bool operator==(const SettingValue&) const = default;
};

/// What is kept of a run besides its row, where that is wanted.
struct Kept {
    bool report = false;   ///< All of it, as JSON.
    bool picture = false;  ///< Path, speed and acceleration, as SVG.

    bool operator==(const Kept&) const = default;
};

/// One run: a program on a machine, with all that it is told.
struct Job {
    std::size_t number = 0;  ///< Within its batch, from 0.
    std::string program;     ///< File.
    std::string machine;     ///< File or name; empty: the one of the cell, or the one built in.
    nlohmann::json options;  ///< Object, by the names of run_options().
    std::vector<SettingValue> settings;
    Kept keeps = {};
};

/// As a line of JSON, without a line feed.
std::string print_job(const Job& job);
/// Such a line. The error is a sentence.
tl::expected<Job, std::string> read_job(std::string_view line);

/// The settings as JSON: {"machine.axis.X.max_speed_mm_s": 500, ...}; a factor as "x 1.1", what is added as
/// "+ 1.1".
nlohmann::ordered_json settings_json(const std::vector<SettingValue>& settings);

}  // namespace gsim::batch
