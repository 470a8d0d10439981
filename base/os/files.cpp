#include "base/os/files.h"

#include <algorithm>
#include <system_error>

namespace gsim::os {

namespace fs = std::filesystem;

namespace {

class DiskFiles final : public Files {
  public:
    Result<std::string> read(const std::filesystem::path& path, NameSource name_source,
                             std::size_t max_bytes) const override {
        return read_input(path, name_source, max_bytes);
    }

    std::optional<Error> find_error(const std::filesystem::path& path) const override {
        std::error_code error;
        static_cast<void>(std::filesystem::file_size(path, error));
        return error ? std::optional(error.message()) : std::nullopt;
    }

    bool has(const fs::path& path) const override {
        std::error_code ignored;
        return fs::is_regular_file(path, ignored);
    }

    bool is_absent(const fs::path& path) const override {
        std::error_code error;
        return !fs::exists(path, error) && !error;
    }

    bool is_same_file(const fs::path& a, const fs::path& b) const override {
        std::error_code ignored;
        return fs::equivalent(a, b, ignored);
    }

    bool is_within(const fs::path& folder, const fs::path& name) const override {
        std::error_code no_folder;
        std::error_code no_file;
        const fs::path inside = fs::canonical(folder, no_folder);
        const fs::path file = fs::canonical(folder / name, no_file);
        const auto [end, unused] = std::mismatch(inside.begin(), inside.end(), file.begin(), file.end());
        return !no_folder && !no_file && end == inside.end();
    }

    bool are_system_files() const override { return true; }
};

}  // namespace

Result<std::string> Files::read_text(const std::filesystem::path& path, NameSource name_source) const {
    return read(path, name_source, kMaxTextFileBytes);
}

const Files& disk() {
    static const DiskFiles files;
    return files;
}

Result<std::string> CallbackFiles::read(const std::filesystem::path& path, NameSource /*name_source*/,
                                        std::size_t max_bytes) const {
    std::optional<std::string> bytes = provider_(path.lexically_normal().string());
    if (!bytes) return Unexpected("cannot read '" + path.string() + "': file not found");
    if (bytes->size() > max_bytes) return tl::unexpected(too_large(path, max_bytes));
    return *std::move(bytes);
}

std::optional<Error> CallbackFiles::find_error(const std::filesystem::path& /*path*/) const {
    return std::nullopt;
}

bool CallbackFiles::has(const std::filesystem::path& path) const {
    return provider_(path.lexically_normal().string()).has_value();
}

bool CallbackFiles::is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) const {
    return a.lexically_normal() == b.lexically_normal();
}

bool CallbackFiles::is_within(const std::filesystem::path& /*folder*/,
                              const std::filesystem::path& name) const {
    const fs::path plain = name.lexically_normal();
    return plain.is_relative() && (plain.empty() || *plain.begin() != "..");
}

}  // namespace gsim::os
