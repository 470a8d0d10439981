#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

namespace gsim::batch {

/// One value of a setting. Its key says of what: `machine.axis.X.max_speed_mm_s` of the machine file (an
/// element of a list by its place, its letter or its name), `cell.object.post.frame.x_mm` of the cell file,
/// `data.OFFSET.54.X` of the machine data, `option.feed_override_percent` of the run.
struct SettingValue {
    std::string key;
    nlohmann::json value;
    bool is_factor = false;  ///< Of what the file has there.

    bool operator==(const SettingValue&) const = default;
};

/// One run: a program on a machine, with all that it is told.
struct Job {
    std::size_t number = 0;  ///< Within its batch, from 0.
    std::string program;     ///< File.
    std::string machine;     ///< File or name; empty: the one of the cell, or the one built in.
    nlohmann::json options;  ///< Object, by the names of run_options().
    std::vector<SettingValue> settings;
    bool keeps_report = false;  ///< Its whole report is wanted.
};

/// As a line of JSON, without a line feed.
std::string print_job(const Job& job);
/// Such a line. The error is a sentence.
tl::expected<Job, std::string> read_job(std::string_view line);

/// The settings as JSON: {"machine.axis.X.max_speed_mm_s": 500, ...}; a factor as "x 1.1".
nlohmann::ordered_json settings_json(const std::vector<SettingValue>& settings);

}  // namespace gsim::batch
