#include "studio/server/serve.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pthread.h>

#include "base/os/input_file.h"
#include "base/text/json.h"
#include "studio/server/browser_page.h"
#include "studio/server/studio_server.h"

namespace gsim::studio {

namespace {

constexpr int kUsageText = 2;
constexpr std::size_t kMaxPageBytes = std::size_t{64} << 20U;

void print_error(const std::string& line) {
    std::fprintf(stderr, "gsim-studio: %s\n", line.c_str());
}

int reject(const std::string& reason) {
    print_error(reason);
    return kUsageText;
}

sigset_t termination_signals() {
    sigset_t signals;
    ::sigemptyset(&signals);
    for (const int each : {SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&signals, each);
    return signals;
}

void serve_until_signal(StudioServer& server) {
    const sigset_t signals = termination_signals();
    std::thread signal_thread([&] {
        int signal_number = 0;
        ::sigwait(&signals, &signal_number);
        server.stop_serving();
    });
    server.serve();
    // If the server ended without a signal, the thread still waits for one. This one ends no process.
    ::pthread_kill(signal_thread.native_handle(), SIGTERM);  // NOLINT(bugprone-bad-signal-to-kill-thread)
    signal_thread.join();
}

Result<ServerContent> read_server_content(const nlohmann::ordered_json& page_data) {
    auto folder = os::RootedDirectory::open(page_data.at("folder").get<std::string>());
    if (!folder) return tl::unexpected(folder.error());
    auto page =
        os::read_input(page_data.at("page").get<std::string>(), os::NameSource::in_file, kMaxPageBytes);
    if (!page) return tl::unexpected(page.error());
    return ServerContent{.folder = *std::move(folder),
                         .page = *std::move(page),
                         .page_data = page_data.at("page_data"),
                         .engine = page_data.at("engine").get<std::vector<std::string>>(),
                         .log = print_error};
}

int run(const std::string& argument) {
    const auto page_data = text::try_parse_json<nlohmann::ordered_json>(argument);
    if (!page_data.is_object()) return reject("gsim-serve cannot be run directly; gsim studio starts it");
    auto server_content = read_server_content(page_data);
    if (!server_content) return reject(server_content.error().message);
    const sigset_t signals = termination_signals();
    ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // in all threads, so that one waits for them
    std::signal(SIGPIPE, SIG_IGN);
    StudioServer server(*std::move(server_content));
    const int port = page_data.at("port").get<int>();
    if (server.bind(port) < 0)
        return reject(fmt::format("port {} of this machine is in use; --port 0 selects a free port", port));
    std::printf("%s\n", server.address().c_str());
    std::fflush(stdout);
    const std::optional<BrowserPage> page =
        page_data.at("browser").get<bool>() ? BrowserPage::open(server.address()) : std::nullopt;
    serve_until_signal(server);
    return 0;
}

}  // namespace

int serve_page(const std::string& argument) {
    try {
        return run(argument);
    } catch (const std::exception& error) {
        return reject(error.what());
    }
}

}  // namespace gsim::studio
