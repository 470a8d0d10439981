#include "batch/work/run_commands.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/text/json.h"
#include "batch/work/edits.h"
#include "batch/work/path_job.h"

namespace gsim::batch {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Option of a run in the spelling of gsim-run.
struct Spelling {
    std::string_view option, word;
    bool is_of_studio = false;
    bool is_file = false;  ///< That the studio serves.
};

// Permanent variables are excluded because gsim-run would write them.
constexpr std::array kSpellings{
    Spelling{"dialect", "--dialect", true},
    Spelling{"unknown", "--unknown"},
    Spelling{"machine_data", "--machine-data", true, true},
    Spelling{"cell", "--cell", true, true},
    Spelling{"setup", "--setup"},
    Spelling{"robots", "--robots", true, true},
    Spelling{"library", "--lua-lib"},
    Spelling{"module", "--rcs", true},
    Spelling{"probe", "--probe"},
    Spelling{"overrides", "--overrides"},
    Spelling{"feed_override_percent", "--feed-override"},
    Spelling{"rapid_override_percent", "--rapid-override"},
    Spelling{"spindle_override_percent", "--spindle-override"},
    Spelling{"block_delete", "--block-delete"},
    Spelling{"optional_stop", "--optional-stop"},
    Spelling{"stop_at_first", "--stop-at-first"},
    Spelling{"passes", "--passes"},
    Spelling{"max_time_s", "--max-time"},
    Spelling{"max_cpu_s", "--max-cpu-seconds"},
    Spelling{"max_blocks", "--max-blocks"},
    Spelling{"max_steps", "--max-steps"},
    Spelling{"lower_bound", "--explain"},
};

/// Adds "./" so that a file name is not parsed as an option.
std::string file_word(const std::string& file) {
    return file.starts_with('-') ? "./" + file : file;
}

/// Returns false for a machine that is looked up in the folder of installed machines.
bool is_file_name(const std::string& machine) {
    return machine.find_first_of("./") != std::string::npos;
}

/// Words and files that a command takes from a run.
struct CommandParts {
    std::vector<std::string> words;
    std::vector<std::string> files;
    std::vector<std::string> left_out;
};

void gather(CommandParts& parts, std::string_view option, const json& value, bool for_studio) {
    const auto* found = std::find_if(kSpellings.begin(), kSpellings.end(),
                                     [&](const Spelling& each) { return each.option == option; });
    if (option == "joint_speeds") return;  // which changes no run
    const bool is_of_collisions = option == "collisions" && value.is_boolean();
    if (is_of_collisions && value == json(true)) return;  // as it is without a word
    if (is_of_collisions && !for_studio) {
        parts.words.emplace_back("--no-collisions");
    } else if (found == kSpellings.end() || (for_studio && !found->is_of_studio)) {
        parts.left_out.emplace_back(option);
    } else if (value.is_boolean()) {
        if (value.get<bool>()) parts.words.emplace_back(found->word);
    } else {
        const std::string word = value.is_string() ? value.get<std::string>() : value.dump();
        parts.words.emplace_back(found->word);
        parts.words.push_back(found->is_file ? file_word(word) : word);
        if (found->is_file) parts.files.push_back(word);
    }
}

CommandParts command_parts(const RunTold& run, bool for_studio) {
    CommandParts parts;
    if (!run.machine.empty()) {
        parts.words.insert(parts.words.end(), {"--machine", file_word(run.machine)});
        if (is_file_name(run.machine)) parts.files.push_back(run.machine);
    }
    json options = text::try_parse_json<json>(run.options);
    if (!options.is_object()) options = json::object();
    const json settings = text::try_parse_json<json>(run.settings);
    for (const auto& [key, value] : settings.items()) {
        if (key.starts_with(kOfRun)) {
            options[key.substr(kOfRun.size())] = value;
        } else {
            parts.left_out.push_back(key);
        }
    }
    for (const auto& [option, value] : options.items()) gather(parts, option, value, for_studio);
    parts.files.push_back(run.program);
    return parts;
}

OpenCommand command_of(std::vector<std::string> head, CommandParts parts, std::vector<std::string> tail) {
    head.insert(head.end(), parts.words.begin(), parts.words.end());
    head.insert(head.end(), tail.begin(), tail.end());
    return {.words = std::move(head), .left_out = std::move(parts.left_out)};
}

/// Returns a folder that contains all files; empty: their names do not determine one.
std::string folder_of_all(const std::vector<std::string>& files) {
    const auto is_inner = [](const std::string& file) {
        return fs::path(file).is_relative() && *fs::path(file).lexically_normal().begin() != "..";
    };
    if (std::all_of(files.begin(), files.end(), is_inner)) return ".";
    fs::path folder = fs::path(files.front()).lexically_normal().parent_path();
    for (const std::string& file : files) {
        if (!fs::path(file).is_absolute()) return {};
        while (*fs::path(file).lexically_relative(folder).begin() == "..") folder = folder.parent_path();
    }
    return folder == folder.root_path() ? std::string() : folder.string();
}

}  // namespace

OpenCommand studio_command(const RunTold& run) {
    if (is_path(run.program)) return {};
    CommandParts parts = command_parts(run, true);
    const std::string folder = folder_of_all(parts.files);
    if (folder.empty()) return {};
    return command_of({"gsim", "studio"}, std::move(parts), {file_word(folder), file_word(run.program)});
}

OpenCommand view_command(const RunTold& run) {
    if (is_path(run.program)) return {};
    return command_of({"gsim", "run", "--view", std::string(kViewFile)}, command_parts(run, false),
                      {file_word(run.program)});
}

OpenCommand run_command(const RunTold& run) {
    if (is_path(run.program)) return {};
    return command_of({"gsim", "run"}, command_parts(run, false), {file_word(run.program)});
}

RunTold told_of(const Job& job) {
    return {job.program, job.machine, job.options.dump(), settings_json(job.settings).dump()};
}

std::string shell_word(std::string_view word) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:=+,@%-";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos) return std::string(word);
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + '\'';
}

std::string shell_line(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : " ") + shell_word(word);
    return line;
}

}  // namespace gsim::batch
