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
using Fault = tl::unexpected<std::string>;
using Names = std::vector<std::string>;

constexpr std::array<std::string_view, 15> kEndings{".nc",    ".ngc", ".ncd", ".tap", ".cnc",
                                                    ".gcode", ".gco", ".g",   ".iso", ".eia",
                                                    ".mpf",   ".min", ".din", ".pim", ".lua"};

bool is_program(const fs::path& file) {
    const std::string ending = text::lower(file.extension().string());
    return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end() || is_path(file.string());
}

bool is_pattern(const std::string& name) {
    return name.find_first_of("*?[") != std::string::npos;
}

/// Returns the files below a folder for which `wanted` is true. Hidden folders and files are skipped, as are
/// unreadable ones.
tl::expected<Names, std::string> files_below(const fs::path& folder, const auto& wanted) {
    std::error_code error;
    Names found;
    auto entry =
        fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        const bool hidden = entry->path().filename().string().starts_with('.');
        if (hidden && entry->is_directory()) entry.disable_recursion_pending();
        if (!hidden && entry->is_regular_file() && wanted(entry->path()))
            found.push_back(entry->path().lexically_normal().string());
    }
    if (error) return Fault(fmt::format("cannot read '{}': {}", folder.string(), error.message()));
    std::sort(found.begin(), found.end());
    return found;
}

/// Returns true if a name matches a pattern: `**/` matches any folders, `*` matches text without a slash.
bool is_meant(const std::string& name, const std::string& pattern) {
    const std::size_t any = pattern.find("**/");
    if (any == std::string::npos) return ::fnmatch(pattern.c_str(), name.c_str(), FNM_PATHNAME) == 0;
    const std::string head = pattern.substr(0, any), tail = pattern.substr(any + 3);
    bool begins = head.empty();
    for (std::size_t at = 0; at != std::string::npos;) {
        begins = begins || ::fnmatch(head.c_str(), name.substr(0, at).c_str(), FNM_PATHNAME) == 0;
        if (begins && is_meant(name.substr(at), tail)) return true;
        const std::size_t slash = name.find('/', at);
        at = slash == std::string::npos ? slash : slash + 1;
    }
    return false;
}

tl::expected<Names, std::string> matches(const std::string& pattern, const fs::path& folder) {
    const std::size_t slash = pattern.rfind('/', pattern.find_first_of("*?["));
    const fs::path below = slash == std::string::npos ? "." : pattern.substr(0, slash + 1);
    return files_below(
        folder / below, [&, whole = fs::path(pattern).lexically_normal().string()](const fs::path& file) {
            const fs::path name =
                folder.empty() || fs::path(pattern).is_absolute() ? file : file.lexically_relative(folder);
            return is_meant(name.lexically_normal().string(), whole);
        });
}

/// Program names are passed on as text, so they must be UTF-8.
tl::expected<Names, std::string> all_of_utf8(Names names) {
    for (const std::string& name : names) {
        if (!text::is_utf8(name))
            return Fault(fmt::format("'{}' has a name that is not UTF-8", text::printable(name)));
    }
    return names;
}

}  // namespace

tl::expected<Names, std::string> find_programs(const std::string& name, const fs::path& folder) {
    std::error_code ignored;
    const std::string plain = (folder / name).lexically_normal().string();
    if (fs::is_regular_file(plain, ignored)) return all_of_utf8({plain});
    const bool is_folder = fs::is_directory(plain, ignored);
    if (!is_folder && !is_pattern(name))
        return Fault(
            fmt::format("cannot read '{}': there is no such file or folder", text::printable(plain)));
    auto found = is_folder ? files_below(plain, is_program) : matches(name, folder);
    if (found && found->empty())
        return Fault(is_folder
                         ? fmt::format("'{}' has no part programs ({})", plain, text::joined(kEndings, ", "))
                         : fmt::format("nothing is called '{}'", plain));
    return found.and_then(all_of_utf8);
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
    const std::uint64_t rest = number / design_.size();
    return {.number = number,
            .program = plan_.programs[rest / plan_.machines.size()],
            .machine = plan_.machines[rest % plan_.machines.size()],
            .options = plan_.options,
            .settings = design_.variant(variant),
            .keeps = plan_.keeps};
}

}  // namespace gsim::batch
