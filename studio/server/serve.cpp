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

constexpr int kUsage = 2;
constexpr std::size_t kLargestPage = std::size_t{64} << 20U;

void print_error(const std::string& line) {
    std::fprintf(stderr, "gsim-studio: %s\n", line.c_str());
}

int refuse(const std::string& why) {
    print_error(why);
    return kUsage;
}

sigset_t ending_signals() {
    sigset_t signals;
    ::sigemptyset(&signals);
    for (const int each : {SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&signals, each);
    return signals;
}

void serve_until_signal(StudioServer& server) {
    const sigset_t signals = ending_signals();
    std::thread ending([&] {
        int which = 0;
        ::sigwait(&signals, &which);
        server.stop_serving();
    });
    server.serve();
    // If the server ended without a signal, the thread still waits for one. This one ends no process.
    ::pthread_kill(ending.native_handle(), SIGTERM);  // NOLINT(bugprone-bad-signal-to-kill-thread)
    ending.join();
}

tl::expected<ServedStudio, std::string> served_of(const nlohmann::ordered_json& told) {
    auto folder = os::BoundFolder::open(told.at("folder").get<std::string>());
    if (!folder) return tl::unexpected(folder.error());
    auto page = os::read_input(told.at("page").get<std::string>(), os::NamedBy::a_file, kLargestPage);
    if (!page) return tl::unexpected(page.error());
    return ServedStudio{.folder = *std::move(folder),
                        .page = *std::move(page),
                        .told = told.at("told"),
                        .engine = told.at("engine").get<std::vector<std::string>>(),
                        .log = print_error};
}

int run(const std::string& argument) {
    const auto told = text::try_parse_json<nlohmann::ordered_json>(argument);
    if (!told.is_object()) return refuse("gsim-serve is not made to be called; gsim studio calls it");
    auto served = served_of(told);
    if (!served) return refuse(served.error());
    const sigset_t signals = ending_signals();
    ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // in all threads, so that one waits for them
    std::signal(SIGPIPE, SIG_IGN);
    StudioServer server(*std::move(served));
    const int port = told.at("port").get<int>();
    if (server.bind(port) < 0)
        return refuse(fmt::format("port {} of this machine is taken; --port 0 takes one that is free", port));
    std::printf("%s\n", server.address().c_str());
    std::fflush(stdout);
    const std::optional<BrowserPage> page =
        told.at("browser").get<bool>() ? BrowserPage::open(server.address()) : std::nullopt;
    serve_until_signal(server);
    return 0;
}

}  // namespace

int serve_page(const std::string& argument) {
    try {
        return run(argument);
    } catch (const std::exception& error) {
        return refuse(error.what());
    }
}

}  // namespace gsim::studio
