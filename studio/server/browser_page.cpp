#include "studio/server/browser_page.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "base/os/descriptor.h"
#include "base/os/spawn.h"

namespace gsim::studio {

namespace {

void print_system_error(const std::string& what, int error) {
    std::fprintf(stderr, "gsim-studio: %s: %s; open the address above in a browser\n", what.c_str(),
                 std::generic_category().message(error).c_str());
}

/// Returns a file in the user's own folder if it exists, else in the shared one; there only the file belongs
/// to the user.
std::string redirect_file_name() {
    const char* const separate = std::getenv("XDG_RUNTIME_DIR");
    std::error_code ignored;
    const auto folder = separate != nullptr && std::filesystem::is_directory(separate, ignored)
                            ? std::filesystem::path(separate)
                            : std::filesystem::temp_directory_path(ignored);
    return (folder / fmt::format("gsim-studio-{}.html", ::getpid())).string();
}

bool write_redirect(int file, const std::string& address) {
    const std::string page = fmt::format(
        "<!doctype html><meta charset=utf-8><meta http-equiv=refresh content='0;url={0}'><a href='{0}'>gsim "
        "studio</a>\n",
        address);
    return ::write(file, page.data(), page.size()) == static_cast<ssize_t>(page.size());
}

}  // namespace

std::optional<BrowserPage> BrowserPage::open(const std::string& address) {
    const std::string name = redirect_file_name();
    const os::SignalBlocker blocked_signals;
    auto temporary_path = os::TemporaryName::temporary_path(name);
    const os::Descriptor file(
        ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
    if (file.number() < 0) {
        print_system_error("the page for the browser cannot be created", errno);
        return std::nullopt;
    }
    os::TemporaryName page(std::move(temporary_path));
    if (!write_redirect(file.number(), address)) {
        print_system_error("the page for the browser cannot be created", errno);
        return std::nullopt;
    }
    os::SpawnActions actions;
    actions.redirect_from_null(STDIN_FILENO);
    actions.redirect(STDERR_FILENO, STDOUT_FILENO);  // standard output has the address alone
    // A separate process group: Ctrl+C in the terminal ends this server, but not the user's browser.
    if (const auto begun = os::spawn({"xdg-open", name}, actions, os::ProcessGroup::separate); !begun) {
        print_system_error("xdg-open cannot be started", begun.error());
        return std::nullopt;
    }
    return BrowserPage(std::move(page));
}

}  // namespace gsim::studio
