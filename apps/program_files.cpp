#include "apps/program_files.h"

#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "base/os/file_identity.h"

namespace gsim::apps {

namespace fs = std::filesystem;

namespace {

std::optional<std::string> fault_of_subprogram_file(const fs::path& path, const std::vector<TakenFile>& taken,
                                                    bool overwrite) {
    const std::string name = path.string();
    const auto identity = os::identity_of(path);
    for (const TakenFile& file : taken) {
        if (file.path.empty() || !identity || identity != os::identity_of(file.path)) continue;
        return fmt::format(
            "the post calls the file of a subprogram '{}', which is {}; give the output another name or "
            "another folder",
            name, file.what);
    }
    std::error_code ignored;
    const fs::file_status status = fs::symlink_status(path, ignored);
    if (!fs::exists(status)) return std::nullopt;
    if (!fs::is_regular_file(status)) {
        return fmt::format("the post calls the file of a subprogram '{}', which is there and no regular file",
                           name);
    }
    if (overwrite) return std::nullopt;
    return fmt::format(
        "the post calls the file of a subprogram '{}', which is there already; --overwrite replaces it",
        name);
}

}  // namespace

tl::expected<ProgramFiles, std::string> ProgramFiles::open(const fs::path& main,
                                                           const std::vector<std::string>& beside,
                                                           const std::vector<TakenFile>& taken,
                                                           bool overwrite) {
    for (const std::string& name : beside) {
        if (auto fault = fault_of_subprogram_file(main.parent_path() / name, taken, overwrite))
            return tl::unexpected(*std::move(fault));
    }
    ProgramFiles files;
    if (auto opened = files.add("", main, os::Existing::replace); !opened)
        return tl::unexpected(opened.error());
    for (const std::string& name : beside) {
        const os::Existing existing = overwrite ? os::Existing::replace : os::Existing::keep;
        if (auto opened = files.add(name, main.parent_path() / name, existing); !opened)
            return tl::unexpected(opened.error());
    }
    return files;
}

tl::expected<void, std::string> ProgramFiles::add(const std::string& name, const fs::path& path,
                                                  os::Existing existing) {
    auto file = os::OutputFile::open(path, existing);
    if (!file) return tl::unexpected(file.error());
    files_.emplace(name, std::move(*file));
    return {};
}

tl::expected<void, std::string> ProgramFiles::commit() {
    for (auto& [name, file] : files_) {
        if (auto settled = file.settle(); !settled) return settled;
    }
    for (auto file = files_.rbegin(); file != files_.rend(); ++file) {  // "" comes last
        if (auto committed = file->second.commit(); !committed) return committed;
    }
    return {};
}

}  // namespace gsim::apps
