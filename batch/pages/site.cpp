#include "batch/pages/site.h"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "base/os/output_file.h"
#include "batch/pages/page_text.h"

namespace gsim::batch {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHeadBytes = 1024;  // bytes, in which a page of ours says so

Unexpected folder_error(std::string_view what, const fs::path& file, const std::error_code& error) {
    return Unexpected(fmt::format("cannot {} '{}': {}", what, file.string(), error.message()));
}

bool is_generated_page(const std::string& name, std::string_view content) {
    return content.substr(0, kHeadBytes).find(page_marker(name)) != std::string_view::npos;
}

std::string page_head(const fs::path& file) {
    std::string head(kHeadBytes, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    return head;
}

}  // namespace

Result<Site> Site::open(const std::string& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return folder_error("create the folder", folder, error);
    return Site(folder);
}

Result<void> Site::save(const std::string& name, std::string_view page) {
    names_.insert(name);
    const fs::path file = folder_ / name;
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::is_regular_file(status)) {
        std::ifstream stream(file, std::ios::binary);
        const std::string content{std::istreambuf_iterator<char>(stream), {}};
        if (content == page) return {};
        if (!is_generated_page(name, content)) {
            return Unexpected(
                fmt::format("'{}' is not a page written by --pages; choose another folder", file.string()));
        }
    } else if (fs::exists(status)) {
        return folder_error("write", file, std::make_error_code(std::errc::file_exists));
    }
    return os::write_file(file, page);
}

Result<void> Site::remove_stale_pages() {
    return remove_files(folder_, [&](const std::string& name, std::string_view head) {
        return !names_.contains(name) && is_generated_page(name, head);
    });
}

Result<void> remove_files(
    const fs::path& folder,
    const std::function<bool(const std::string& name, std::string_view head)>& should_remove) {
    std::vector<fs::path> files;
    std::error_code error;
    if (!fs::exists(folder, error)) return {};
    auto entry = fs::directory_iterator(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        const fs::path file = entry->path();
        std::error_code ignored;
        const bool is_page =
            file.extension() == ".html" && fs::is_regular_file(entry->symlink_status(ignored));
        if (is_page && should_remove(file.filename().string(), page_head(file))) files.push_back(file);
    }
    if (error) return folder_error("read the folder", folder, error);
    for (const fs::path& file : files) {
        fs::remove(file, error);
        if (error) return folder_error("remove", file, error);
    }
    return {};
}

}  // namespace gsim::batch
