#include "batch/pages/open_commands.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include <nlohmann/json.hpp>

namespace gsim::batch {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::string_view kOptionKey = "option.";

/// An option of a run as gsim-run spells it.
struct Spelling {
    std::string_view option, word;
    bool is_of_studio = false;
    bool is_file = false;  ///< That the studio serves.
};

// Permanent variables are not among them: gsim-run would write them.
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
};

std::string quoted_for_shell(std::string_view word) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:=+,@%-";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos) return std::string(word);
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + '\'';
}

std::string file_word(const std::string& file) {
    return quoted_for_shell(file.starts_with('-') ? "./" + file : file);
}

/// A machine that is no file is looked up where machines are installed.
bool is_file_name(const std::string& machine) {
    return machine.find_first_of("./") != std::string::npos;
}

/// The words of a command, as they are gathered.
struct Words {
    std::string text;
    std::vector<std::string> files;
    std::vector<std::string> left_out;

    void add(std::string_view option, const json& value, bool for_studio) {
        const auto* found = std::find_if(kSpellings.begin(), kSpellings.end(),
                                         [&](const Spelling& each) { return each.option == option; });
        const bool is_off = option == "collisions" && value == json(false) && !for_studio;
        if (is_off) {
            text += " --no-collisions";
        } else if (found == kSpellings.end() || (for_studio && !found->is_of_studio)) {
            left_out.emplace_back(option);
        } else if (value.is_boolean()) {
            if (value.get<bool>()) text += option_word(found->word);
        } else {
            const std::string word = value.is_string() ? value.get<std::string>() : value.dump();
            text += option_word(found->word) + ' ' + quoted_for_shell(word);
            if (found->is_file) files.push_back(word);
        }
    }

  private:
    static std::string option_word(std::string_view word) { return " " + std::string(word); }
};

Words words_of(const WholeRun& run, bool for_studio) {
    Words words;
    if (!run.machine.empty()) {
        words.text += " --machine " + file_word(run.machine);
        if (is_file_name(run.machine)) words.files.push_back(run.machine);
    }
    json options = json::parse(run.options, nullptr, false);
    if (!options.is_object()) options = json::object();
    const json settings = json::parse(run.settings, nullptr, false);
    for (const auto& [key, value] : settings.items()) {
        if (key.starts_with(kOptionKey)) {
            options[key.substr(kOptionKey.size())] = value;
        } else {
            words.left_out.push_back(key);
        }
    }
    for (const auto& [option, value] : options.items()) words.add(option, value, for_studio);
    words.files.push_back(run.program);
    return words;
}

/// A folder that has all of the files; empty: none that their names tell.
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

OpenCommand studio_command(const WholeRun& run) {
    const Words words = words_of(run, true);
    const std::string folder = folder_of_all(words.files);
    if (folder.empty()) return {};
    return {.line = "gsim studio" + words.text + ' ' + file_word(folder) + ' ' + file_word(run.program),
            .left_out = words.left_out};
}

OpenCommand view_command(const WholeRun& run) {
    const Words words = words_of(run, false);
    return {.line = "gsim run --view run.html" + words.text + ' ' + file_word(run.program),
            .left_out = words.left_out};
}

}  // namespace gsim::batch
