#include "batch/plan/plan.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>
#include <fnmatch.h>

#include "base/text/format.h"
#include "base/text/letter_case.h"
#include "base/text/printable.h"
#include "base/text/utf8.h"
#include "batch/work/path_job.h"

namespace gsim::batch {

namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

constexpr std::array<std::string_view, 15> kProgramExtensions{".nc",    ".ngc", ".ncd", ".tap", ".cnc",
                                                              ".gcode", ".gco", ".g",   ".iso", ".eia",
                                                              ".mpf",   ".min", ".din", ".pim", ".lua"};

bool is_program_file(const fs::path& file) {
    const std::string file_suffix = text::lower(file.extension().string());
    return std::find(kProgramExtensions.begin(), kProgramExtensions.end(), file_suffix) !=
               kProgramExtensions.end() ||
           is_path_file(file.string());
}

bool is_pattern(const std::string& name) {
    return name.find_first_of("*?[") != std::string::npos;
}

/// Returns the files below a folder for which `accepts` is true. Hidden folders and files are skipped, as are
/// unreadable ones.
Result<Names> find_files(const fs::path& folder, const auto& accepts) {
    std::error_code error;
    Names found;
    auto entry =
        fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        const bool is_hidden = entry->path().filename().string().starts_with('.');
        if (is_hidden && entry->is_directory()) entry.disable_recursion_pending();
        if (!is_hidden && entry->is_regular_file() && accepts(entry->path()))
            found.push_back(entry->path().lexically_normal().string());
    }
    if (error) return Unexpected(fmt::format("cannot read '{}': {}", folder.string(), error.message()));
    std::sort(found.begin(), found.end());
    return found;
}

/// Returns true if a name matches a pattern: `**/` matches any folders, `*` matches text without a slash.
bool matches_pattern(const std::string& name, const std::string& pattern) {
    const std::size_t any = pattern.find("**/");
    if (any == std::string::npos) return ::fnmatch(pattern.c_str(), name.c_str(), FNM_PATHNAME) == 0;
    const std::string prefix = pattern.substr(0, any), suffix = pattern.substr(any + 3);
    bool prefix_matches = prefix.empty();
    for (std::size_t at = 0; at != std::string::npos;) {
        prefix_matches =
            prefix_matches || ::fnmatch(prefix.c_str(), name.substr(0, at).c_str(), FNM_PATHNAME) == 0;
        if (prefix_matches && matches_pattern(name.substr(at), suffix)) return true;
        const std::size_t slash = name.find('/', at);
        at = slash == std::string::npos ? slash : slash + 1;
    }
    return false;
}

Result<Names> find_matches(const std::string& pattern, const fs::path& folder) {
    const std::size_t slash = pattern.rfind('/', pattern.find_first_of("*?["));
    const fs::path below = slash == std::string::npos ? "." : pattern.substr(0, slash + 1);
    return find_files(folder / below,
                      [&, normalized = fs::path(pattern).lexically_normal().string()](const fs::path& file) {
                          const fs::path name = folder.empty() || fs::path(pattern).is_absolute()
                                                    ? file
                                                    : file.lexically_relative(folder);
                          return matches_pattern(name.lexically_normal().string(), normalized);
                      });
}

/// Program names are passed on as text, so they must be UTF-8.
Result<Names> check_utf8(Names names) {
    for (const std::string& name : names) {
        if (!text::is_utf8(name))
            return Unexpected(fmt::format("the name of '{}' is not UTF-8", text::printable(name)));
    }
    return names;
}

}  // namespace

Result<Names> find_programs(const std::string& name, const fs::path& folder) {
    std::error_code ignored;
    const std::string plain = (folder / name).lexically_normal().string();
    if (fs::is_regular_file(plain, ignored)) return check_utf8({plain});
    const bool is_folder = fs::is_directory(plain, ignored);
    if (!is_folder && !is_pattern(name))
        return Unexpected(fmt::format("cannot read '{}': file or folder not found", text::printable(plain)));
    auto found = is_folder ? find_files(plain, is_program_file) : find_matches(name, folder);
    if (found && found->empty())
        return Unexpected(is_folder ? fmt::format("'{}' contains no part programs ({})", plain,
                                                  text::joined(kProgramExtensions, ", "))
                                    : fmt::format("no file matches '{}'", plain));
    return found.and_then(check_utf8);
}

void add_programs(Plan& plan, const Names& files) {
    std::unordered_set<std::string> known(plan.programs.begin(), plan.programs.end());
    for (const std::string& file : files) {
        if (known.insert(file).second) plan.programs.push_back(file);
    }
}

Plan with_variants(Plan plan, std::vector<std::vector<SettingValue>> variants) {
    plan.settings.clear();
    plan.design = {.sampling = Sampling::listed, .listed = std::move(variants)};
    return plan;
}

Jobs::Jobs(const Plan& plan) : plan_(plan), design_(plan.settings, plan.design) {}

// Order: all variants of a program on one machine, then on the next one; then the next program.
Job Jobs::job(std::uint64_t number) const {
    const std::uint64_t variant = number % design_.size();
    const std::uint64_t program_machine_index = number / design_.size();
    return {.number = number,
            .program = plan_.programs[program_machine_index / plan_.machines.size()],
            .machine = plan_.machines[program_machine_index % plan_.machines.size()],
            .options = plan_.options,
            .settings = design_.variant(variant),
            .stored_documents = plan_.stored_documents};
}

}  // namespace gsim::batch
