#include "base/os/file_identity.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>

namespace gsim::os {

namespace {

// Flags of a descriptor that reads and writes nothing, for which a file needs no permission.
#ifdef O_PATH
constexpr int kPathOnlyFlags = O_PATH | O_CLOEXEC;
#else
constexpr int kPathOnlyFlags = O_RDONLY | O_NONBLOCK | O_CLOEXEC;
#endif

struct OpenedFile {
    struct stat status {};
    std::shared_ptr<const Descriptor> descriptor;
};

// Returns nothing if no such file exists; errno gives the reason.
std::optional<OpenedFile> open_existing(const std::filesystem::path& path) {
    OpenedFile opened;
    opened.descriptor = std::make_shared<const Descriptor>(::open(path.c_str(), kPathOnlyFlags));
    if (opened.descriptor->number() < 0 || ::fstat(opened.descriptor->number(), &opened.status) != 0)
        return std::nullopt;
    return opened;
}

// Returns an empty path if it is unknown.
std::filesystem::path canonical_path(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::path resolved_path =
        std::filesystem::weakly_canonical(std::filesystem::absolute(path), error);
    return error ? std::filesystem::path() : resolved_path;
}

}  // namespace

std::optional<FileIdentity> file_identity(const std::filesystem::path& path) {
    const bool may_be_new = path.has_filename();
    if (auto opened = open_existing(path)) {
        if (!S_ISREG(opened->status.st_mode)) return std::nullopt;
        return FileIdentity{opened->status.st_dev,
                            opened->status.st_ino,
                            {},
                            std::move(opened->descriptor),
                            canonical_path(path)};
    }
    if (errno != ENOENT || !may_be_new) return std::nullopt;
    auto folder = open_existing(path.has_parent_path() ? path.parent_path() : ".");
    if (!folder) return std::nullopt;
    return FileIdentity{folder->status.st_dev, folder->status.st_ino, path.filename().string(),
                        std::move(folder->descriptor), canonical_path(path)};
}

std::optional<FileIdentity> open_file_identity(int descriptor) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) return std::nullopt;
    if (!S_ISREG(status.st_mode)) return std::nullopt;
    return FileIdentity{status.st_dev, status.st_ino, {}};
}

}  // namespace gsim::os
