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
struct CommandOption {
    std::string_view option, word;
    bool is_for_studio = false;
    bool is_file = false;  ///< That the studio serves.
};

// Permanent variables are excluded because gsim-run would write them.
constexpr std::array kCommandOptions{
    CommandOption{"dialect", "--dialect", true},
    CommandOption{"unknown", "--unknown"},
    CommandOption{"machine_data", "--machine-data", true, true},
    CommandOption{"cell", "--cell", true, true},
    CommandOption{"setup", "--setup"},
    CommandOption{"robots", "--robots", true, true},
    CommandOption{"library", "--lua-lib"},
    CommandOption{"module", "--rcs", true},
    CommandOption{"probe", "--probe"},
    CommandOption{"overrides", "--overrides"},
    CommandOption{"feed_override_percent", "--feed-override"},
    CommandOption{"rapid_override_percent", "--rapid-override"},
    CommandOption{"spindle_override_percent", "--spindle-override"},
    CommandOption{"block_delete", "--block-delete"},
    CommandOption{"optional_stop", "--optional-stop"},
    CommandOption{"stop_at_first", "--stop-at-first"},
    CommandOption{"passes", "--passes"},
    CommandOption{"max_time_s", "--max-time"},
    CommandOption{"max_cpu_s", "--max-cpu-seconds"},
    CommandOption{"max_blocks", "--max-blocks"},
    CommandOption{"max_steps", "--max-steps"},
    CommandOption{"lower_bound", "--explain"},
};

/// Adds "./" so that a file name is not parsed as an option.
std::string file_argument(const std::string& file) {
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

void collect_option(CommandParts& parts, std::string_view option, const json& value, bool for_studio) {
    const auto* found = std::find_if(kCommandOptions.begin(), kCommandOptions.end(),
                                     [&](const CommandOption& each) { return each.option == option; });
    if (option == "joint_speeds") return;  // which changes no run
    const bool is_collision_option = option == "collisions" && value.is_boolean();
    if (is_collision_option && value == json(true)) return;  // as it is without a word
    if (is_collision_option && !for_studio) {
        parts.words.emplace_back("--no-collisions");
    } else if (found == kCommandOptions.end() || (for_studio && !found->is_for_studio)) {
        parts.left_out.emplace_back(option);
    } else if (value.is_boolean()) {
        if (value.get<bool>()) parts.words.emplace_back(found->word);
    } else {
        const std::string word = value.is_string() ? value.get<std::string>() : value.dump();
        parts.words.emplace_back(found->word);
        parts.words.push_back(found->is_file ? file_argument(word) : word);
        if (found->is_file) parts.files.push_back(word);
    }
}

CommandParts command_parts(const RunInputs& run, bool for_studio) {
    CommandParts parts;
    if (!run.machine.empty()) {
        parts.words.insert(parts.words.end(), {"--machine", file_argument(run.machine)});
        if (is_file_name(run.machine)) parts.files.push_back(run.machine);
    }
    json options = text::try_parse_json<json>(run.options);
    if (!options.is_object()) options = json::object();
    const json settings = text::try_parse_json<json>(run.settings);
    for (const auto& [key, value] : settings.items()) {
        if (key.starts_with(kOptionPrefix)) {
            options[key.substr(kOptionPrefix.size())] = value;
        } else {
            parts.left_out.push_back(key);
        }
    }
    for (const auto& [option, value] : options.items()) collect_option(parts, option, value, for_studio);
    parts.files.push_back(run.program);
    return parts;
}

ViewCommand make_command(std::vector<std::string> head, CommandParts parts, std::vector<std::string> tail) {
    head.insert(head.end(), parts.words.begin(), parts.words.end());
    head.insert(head.end(), tail.begin(), tail.end());
    return {.words = std::move(head), .left_out = std::move(parts.left_out)};
}

/// Returns a folder that contains all files; empty: their names do not determine one.
std::string common_folder(const std::vector<std::string>& files) {
    const auto is_inside = [](const std::string& file) {
        return fs::path(file).is_relative() && *fs::path(file).lexically_normal().begin() != "..";
    };
    if (std::all_of(files.begin(), files.end(), is_inside)) return ".";
    fs::path folder = fs::path(files.front()).lexically_normal().parent_path();
    for (const std::string& file : files) {
        if (!fs::path(file).is_absolute()) return {};
        while (*fs::path(file).lexically_relative(folder).begin() == "..") folder = folder.parent_path();
    }
    return folder == folder.root_path() ? std::string() : folder.string();
}

}  // namespace

ViewCommand studio_command(const RunInputs& run) {
    if (is_path_file(run.program)) return {};
    CommandParts parts = command_parts(run, true);
    const std::string folder = common_folder(parts.files);
    if (folder.empty()) return {};
    return make_command({"gsim", "studio"}, std::move(parts),
                        {file_argument(folder), file_argument(run.program)});
}

ViewCommand view_command(const RunInputs& run) {
    if (is_path_file(run.program)) return {};
    return make_command({"gsim", "run", "--view", std::string(kViewFile)}, command_parts(run, false),
                        {file_argument(run.program)});
}

ViewCommand run_command(const RunInputs& run) {
    if (is_path_file(run.program)) return {};
    return make_command({"gsim", "run"}, command_parts(run, false), {file_argument(run.program)});
}

RunInputs run_inputs(const Job& job) {
    return {job.program, job.machine, job.options.dump(), settings_json(job.settings).dump()};
}

std::string shell_word(std::string_view word) {
    constexpr std::string_view kSafeCharacters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:=+,@%-";
    if (!word.empty() && word.find_first_not_of(kSafeCharacters) == std::string_view::npos)
        return std::string(word);
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
