#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/text/json.h"

namespace gsim::batch {

/// Effect of a setting on the value of a file.
enum class SettingUse : std::uint8_t {
    set,     ///< The setting's value replaces it,
    factor,  ///< is multiplied with it,
    shift,   ///< or added to it.
};

/// One value of a setting. Its key names its target: `machine.axis.X.max_speed_mm_s` in the machine file (an
/// element of a list by its index, its letter or its name), `cell.object.post.frame.x_mm` in the cell file,
/// `robots.robot.left.base.x_mm` in the file of robots, `data.OFFSET.54.X` in the machine data,
/// `path.place.x_mm` of a path, `option.feed_override_percent` of the run.
struct SettingValue {
    std::string key;
    nlohmann::json value;
    SettingUse use = SettingUse::set;

    bool operator==(const SettingValue&) const = default;
};

/// Optional documents of a run that are stored with its row.
struct StoredDocuments {
    bool report = false;   ///< All of it, as JSON.
    bool picture = false;  ///< Path, speed and acceleration, as SVG.

    bool operator==(const StoredDocuments&) const = default;
};

/// One run: a program on a machine, with all its inputs and options.
struct Job {
    std::size_t number = 0;  ///< Within its batch, from 0.
    std::string program;     ///< File.
    std::string machine;     ///< File or name; empty: the one of the cell, or the one built in.
    nlohmann::json options;  ///< Object, by the names of run_options().
    std::vector<SettingValue> settings;
    StoredDocuments stored_documents = {};
};

/// Returns the job as a line of JSON, without a line feed.
std::string print_job(const Job& job);
/// Reads such a line.
Result<Job> read_job(std::string_view line);

/// Returns the settings as JSON: {"machine.axis.X.max_speed_mm_s": 500, ...}; a factor as "x 1.1", an addend
/// as "+ 1.1".
nlohmann::ordered_json settings_json(const std::vector<SettingValue>& settings);

}  // namespace gsim::batch
