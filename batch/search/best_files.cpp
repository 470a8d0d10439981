#include "batch/search/best_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/os/input_file.h"
#include "base/os/output_file.h"
#include "base/toml/toml_editor.h"
#include "batch/work/edits.h"
#include "batch/work/run_job.h"
#include "batch/work/run_options.h"

namespace gsim::batch {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char *kProgramExtension = ".nc", *kMachineExtension = ".machine.toml",
                     *kCellExtension = ".cell.toml", *kRobotsExtension = ".robots.toml",
                     *kDataExtension = ".data.txt";
constexpr std::array kFileExtensions{kProgramExtension, kMachineExtension, kCellExtension, kRobotsExtension,
                                     kDataExtension};

/// Keys with file names in machine files, cells and files of robots.
constexpr std::array kFileKeys{"machine", "machine_data", "mesh", "cell"};

/// Finds the positions of all file names in a document that are relative to `folder`.
void find_file_names(const json& value, const fs::path& folder, const base::TomlPath& path,
                     std::vector<std::pair<base::TomlPath, std::string>>& found) {
    const auto descend = [&](const auto& key, const json& inner) {
        base::TomlPath below = path;
        below.emplace_back(key);
        find_file_names(inner, folder, below, found);
    };
    for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) descend(i, value[i]);
    if (!value.is_object()) return;
    for (const auto& [key, inner] : value.items()) {
        const auto* name = inner.get_ptr<const std::string*>();
        const bool is_file = std::find(kFileKeys.begin(), kFileKeys.end(), key) != kFileKeys.end();
        if (name == nullptr) {
            descend(key, inner);
        } else if (is_file && !fs::path(*name).is_absolute()) {
            base::TomlPath below = path;
            below.emplace_back(key);
            found.emplace_back(below, fs::absolute(folder / *name).lexically_normal().string());
        }
    }
}

/// Returns a TOML file with absolute names, so that it may lie elsewhere.
Result<std::string> with_absolute_names(std::string text, const fs::path& file) {
    auto edit = base::TomlEditor::read(std::move(text), file.string());
    if (!edit) return Unexpected(edit.error());
    std::vector<std::pair<base::TomlPath, std::string>> names;
    find_file_names(edit->value(), file.parent_path(), {}, names);
    for (const auto& [path, name] : names) {
        if (const auto set = edit->set(path, name); !set) return Unexpected(set.error());
    }
    return edit->text();
}

class VariantWriter {
  public:
    VariantWriter(const fs::path& folder, std::string stem) : folder_(folder), stem_(std::move(stem)) {}

    Result<Job> write(Job job, const JobTexts& texts) {
        for (const SettingValue& setting : settings_with_prefix(job.settings, kOptionPrefix))
            job.options[setting.key] = setting.value;
        job.settings.clear();
        for (const char* of_paths : {"post", "path_frame", "rotary_as_given"}) job.options.erase(of_paths);
        if (texts.program) write_new_file(job.program, kProgramExtension, *texts.program);
        write_changed_file(job.machine, texts.machine, kMachineExtension, texts);
        json& options = job.options;
        for (const auto& [option, name, file_suffix] :
             {std::tuple{"cell", &texts.cell, kCellExtension},
              std::tuple{"robots", &texts.robots, kRobotsExtension},
              std::tuple{"machine_data", &texts.machine_data, kDataExtension}}) {
            std::string file = options.value(option, std::string());
            write_changed_file(file, *name, file_suffix, texts);
            if (!file.empty()) options[option] = file;
        }
        if (!error_.empty()) return Unexpected(error_);
        return job;
    }

  private:
    void write_new_file(std::string& name, const char* file_suffix, const std::string& text) {
        name = (folder_ / (stem_ + file_suffix)).string();
        if (const auto done = os::write_file(name, text); !done && error_.empty())
            error_ = done.error().message;
    }

    /// Writes the file if the job has another text for it.
    void write_changed_file(std::string& name, const std::string& file, const char* file_suffix,
                            const JobTexts& texts) {
        const auto changed = texts.changed.find(fs::path(file).lexically_normal().string());
        if (file.empty() || changed == texts.changed.end()) return;
        const bool is_toml = std::string_view(file_suffix).ends_with(".toml");
        auto text =
            is_toml ? with_absolute_names(changed->second, file) : Result<std::string>(changed->second);
        if (text) return write_new_file(name, file_suffix, *text);
        if (error_.empty()) error_ = text.error().message;
    }

    fs::path folder_;
    std::string stem_;
    std::string error_;
};

/// Returns the start of the file names of one job: the program's name, with a number if the plan has several
/// jobs.
std::string job_stem(const Job& job, std::uint64_t count) {
    std::string stem = fs::path(job.program).filename().string();
    for (const char* file_suffix : {".path.json", ".path.lua"}) {
        if (stem.ends_with(file_suffix)) stem.erase(stem.rfind(file_suffix));
    }
    return count > 1 ? fmt::format("{}-{}", stem, job.number + 1) : stem;
}

/// Returns the files that a plan names, and those that its machines and its cell name.
std::vector<std::string> input_files(const Plan& plan) {
    std::vector<std::string> files = plan.programs;
    files.push_back(plan.name);
    files.insert(files.end(), plan.machines.begin(), plan.machines.end());
    for (const auto& [name, value] : plan.options.items()) {
        if (find_option(name)->kind == RunOption::Kind::file) files.push_back(value.get<std::string>());
    }
    const std::size_t name_count = files.size();
    for (std::size_t i = 0; i < name_count; ++i) {
        if (!files[i].ends_with(".toml")) continue;
        const auto text = os::read_text_file(files[i], os::NameSource::command_line);
        auto edit = text ? base::TomlEditor::read(*text, files[i]) : tl::unexpected(text.error());
        if (!edit) continue;
        std::vector<std::pair<base::TomlPath, std::string>> names;
        find_file_names(edit->value(), fs::path(files[i]).parent_path(), {}, names);
        for (auto& [path, name] : names) files.push_back(std::move(name));
    }
    return files;
}

/// Returns all files that write_variant() may write.
std::vector<std::string> output_files(const Plan& plan, const std::string& folder) {
    const Plan one = with_variants(plan, {{}});
    const Jobs jobs(one);
    std::vector<std::string> files;
    for (std::uint64_t i = 0; i < jobs.size(); ++i) {
        const std::string stem = job_stem(jobs.job(i), jobs.size());
        for (const char* file_suffix : kFileExtensions)
            files.push_back((fs::path(folder) / (stem + file_suffix)).string());
    }
    return files;
}

}  // namespace

Result<std::vector<Job>> write_variant(const Plan& plan, const std::vector<SettingValue>& settings,
                                       const std::string& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return Unexpected(fmt::format("'{}': {}", folder, error.message()));
    const Plan one = with_variants(plan, {settings});
    const Jobs jobs(one);
    JobRunner runner;
    std::vector<Job> written;
    for (std::uint64_t i = 0; i < jobs.size(); ++i) {
        const Job job = jobs.job(i);
        const auto texts = runner.job_texts(job);
        if (!texts) return Unexpected(texts.error().message);
        auto job_files = VariantWriter(folder, job_stem(job, jobs.size())).write(job, *texts);
        if (!job_files) return Unexpected(job_files.error());
        written.push_back(*std::move(job_files));
    }
    return written;
}

std::optional<Error> find_output_folder_error(const Plan& plan, const std::string& folder, bool overwrite) {
    const std::vector<std::string> inputs = input_files(plan);
    for (const std::string& file : output_files(plan, folder)) {
        std::error_code error;
        if (!fs::exists(fs::symlink_status(file, error))) continue;
        if (!overwrite)
            return fmt::format("'{}' already exists; use another folder for --best, or --overwrite", file);
        const bool is_input = std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
            std::error_code other;
            return fs::equivalent(file, input, other);
        });
        if (is_input)
            return fmt::format("'{}' is an input of the search; use another folder for --best", file);
    }
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return fmt::format("'{}': {}", folder, error.message());
    const auto writable = os::OutputFile::check(fs::path(folder) / "x.nc");
    if (!writable) return writable.error();
    return std::nullopt;
}

}  // namespace gsim::batch
