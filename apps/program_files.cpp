#include "apps/program_files.h"

#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "base/os/file_identity.h"

namespace gsim::apps {

namespace fs = std::filesystem;

namespace {

std::optional<Error> find_subprogram_file_error(const fs::path& path, const std::vector<UsedFile>& used_files,
                                                bool overwrite) {
    const std::string name = path.string();
    const auto identity = os::file_identity(path);
    for (const UsedFile& file : used_files) {
        if (file.path.empty() || !identity || identity != os::file_identity(file.path)) continue;
        return fmt::format(
            "the subprogram file '{}' of the post is also {}; choose another name or folder for the output",
            name, file.what);
    }
    std::error_code ignored;
    const fs::file_status status = fs::symlink_status(path, ignored);
    if (!fs::exists(status)) return std::nullopt;
    if (!fs::is_regular_file(status)) {
        return fmt::format("the subprogram file '{}' of the post exists and is not a regular file", name);
    }
    if (overwrite) return std::nullopt;
    return fmt::format("the subprogram file '{}' of the post already exists; --overwrite replaces it", name);
}

}  // namespace

Result<ProgramFiles> ProgramFiles::open(const fs::path& main,
                                        const std::vector<std::string>& subprogram_files,
                                        const std::vector<UsedFile>& used_files, bool overwrite) {
    for (const std::string& name : subprogram_files) {
        if (auto message = find_subprogram_file_error(main.parent_path() / name, used_files, overwrite))
            return tl::unexpected(*std::move(message));
    }
    ProgramFiles files;
    if (auto opened = files.add("", main, os::ExistingFilePolicy::replace); !opened)
        return tl::unexpected(opened.error());
    for (const std::string& name : subprogram_files) {
        const os::ExistingFilePolicy existing =
            overwrite ? os::ExistingFilePolicy::replace : os::ExistingFilePolicy::keep;
        if (auto opened = files.add(name, main.parent_path() / name, existing); !opened)
            return tl::unexpected(opened.error());
    }
    return files;
}

Result<void> ProgramFiles::add(const std::string& name, const fs::path& path,
                               os::ExistingFilePolicy existing) {
    auto file = os::OutputFile::open(path, existing);
    if (!file) return tl::unexpected(file.error());
    files_.emplace(name, std::move(*file));
    return {};
}

Result<void> ProgramFiles::commit() {
    for (auto& [name, file] : files_) {
        if (auto flushed = file.prepare_commit(); !flushed) return flushed;
    }
    for (auto file = files_.rbegin(); file != files_.rend(); ++file) {  // "" comes last
        if (auto committed = file->second.commit(); !committed) return committed;
    }
    return {};
}

}  // namespace gsim::apps
