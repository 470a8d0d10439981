#include "studio/server/studio_server.h"

#include <chrono>
#include <exception>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include "base/text/printable.h"
#include "studio/engine/message.h"
#include "studio/server/engine_process.h"
#include "studio/server/gentle_close.h"
#include "studio/server/guarded_stream.h"
#include "studio/server/json_answer.h"
#include "studio/server/whole_body_stream.h"

namespace gsim::studio {

namespace {

constexpr const char* kHost = "127.0.0.1";
constexpr std::size_t kMostConnections = 200;
constexpr int kMostAsks = 8;
constexpr int kLook_ms = 200;
constexpr std::string_view kPlace = "<!-- server -->";
/// Limits for a sender without a complete head.
constexpr ClosingBounds kHeadless{.bytes = std::size_t{256} << 10U,
                                  .time = std::chrono::milliseconds(200),
                                  .pause = std::chrono::milliseconds(200)};

/// Returns headers that make browsers protect this page from other sites, and other sites from it. Sources:
/// CSP 3, Fetch, HTML (COOP).
const httplib::Headers& protection() {
    static const httplib::Headers headers{
        {"Cache-Control", "no-store"},
        {"Content-Security-Policy", "frame-ancestors 'none'"},
        {"Cross-Origin-Opener-Policy", "same-origin"},
        {"Cross-Origin-Resource-Policy", "same-origin"},
        {"Referrer-Policy", "no-referrer"},
        {"X-Content-Type-Options", "nosniff"},
        {"X-Frame-Options", "DENY"},
    };
    return headers;
}

/// Returns JSON for a script element: no text in it may look like the element's end.
std::string inline_json(const nlohmann::ordered_json& value) {
    std::string text = value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) text.replace(at, 1, "\\u003c");
    return text;
}

void keep_from_children(int socket) {
    ::fcntl(socket, F_SETFD, FD_CLOEXEC);
}

/// Returns the last message if the engine could not write it.
std::string failed_message(const std::string& sentence) {
    Message message("failed");
    message.header().update(
        {{"code", "internal"}, {"message", sentence}, {"file", ""}, {"in_program", false}});
    return message.bytes();
}

/// Scoped counter of active work.
class Counted {
  public:
    explicit Counted(std::atomic<int>& count) : count_(count), number_(++count) {}
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;
    ~Counted() { --count_; }
    int number() const { return number_; }

  private:
    std::atomic<int>& count_;
    int number_;
};

}  // namespace

StudioServer::StudioServer(ServedStudio served)
    : served_(std::move(served)), folder_(served_.folder), log_(served_.log), connections_(kMostConnections) {
    const std::size_t place = served_.page.find(kPlace);
    if (place == std::string::npos) throw std::invalid_argument("the page has no place for its server");
    page_ = served_.page.replace(place, kPlace.size(), inline_json(served_.told));
    set_keep_alive_max_count(1);
    set_default_headers(protection());
    set_socket_options([](int socket) {
        const int on = 1;
        ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
        keep_from_children(socket);
    });
    new_task_queue = [this] { return new ConnectionThreads(connections_); };  // cpp-httplib deletes it
}

StudioServer::~StudioServer() = default;

int StudioServer::bind(int port) {
    int taken = port;
    if (port == 0) {
        taken = bind_to_any_port(kHost);
    } else if (!bind_to_port(kHost, port)) {
        return -1;
    }
    if (taken < 0) return -1;
    ::listen(svr_sock_, SOMAXCONN);  // cpp-httplib lets five wait: a sixth would try again after a second
    guard_ = std::make_unique<Guard>(taken, random_token());
    address_ = fmt::format("http://{}:{}/{}/", kHost, taken, guard_->token());
    add_routes();
    return taken;
}

std::string StudioServer::address() const {
    return address_;
}

void StudioServer::serve() {
    listen_after_bind();
}

void StudioServer::stop_serving() {
    stopping_ = true;
    ::shutdown(svr_sock_, SHUT_RDWR);  // stop() has no effect before serve() has begun
    stop();
}

void StudioServer::add_routes() {
    const std::string ours = "/" + guard_->token();
    set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
        const auto refusal = guard_->refuse(request);
        if (!refusal) return HandlerResponse::Unhandled;
        refuse(request, response, *refusal);
        return HandlerResponse::Handled;
    });
    Get(ours + "/", [this](const httplib::Request&, httplib::Response& response) {
        response.set_content(page_, "text/html; charset=utf-8");
    });
    Get(ours + "/files",
        [this](const httplib::Request&, httplib::Response& response) { folder_.list(response); });
    Get(ours + "/changes", [this](const httplib::Request& request, httplib::Response& response) {
        folder_.changes(request, response);
    });
    const std::string files = ours + "/file/";
    Get(files + "([^]*)", [this, files](const httplib::Request& request, httplib::Response& response) {
        folder_.read(request.path.substr(files.size()), response);
    });
    Put(files + "([^]*)", [this, files](const httplib::Request& request, httplib::Response& response,
                                        const httplib::ContentReader& content) {
        folder_.write(request.path.substr(files.size()), request, response, content);
    });
    Post(ours + "/ask", [this](const httplib::Request& request, httplib::Response& response,
                               const httplib::ContentReader& content) { ask(request, response, content); });
    Get(ours + "/laws/([0-9a-f]{16})/([0-9]{1,9})",
        [this](const httplib::Request& request, httplib::Response& response) {
            read_laws(request.matches[1], request.matches[2], response);
        });
    // Without a handler cpp-httplib would store data of any size.
    const auto nothing = [](const httplib::Request&, httplib::Response& response,
                            const httplib::ContentReader&) { response.status = 404; };
    Post("[^]*", nothing);
    Put("[^]*", nothing);
    set_error_handler([this](const httplib::Request& request, httplib::Response& response) {
        if (response.body.empty()) answer_error(response, response.status, "there is nothing of this name");
        const bool is_usual =
            response.status == 404 || response.status == 412;  // a page requests a removed file
        if (is_usual || guard_->refuse(request)) return;       // the latter is already logged
        tell(fmt::format("refused {} ({}): {}", request.method, response.status, response.body));
    });
    set_exception_handler(
        [this](const httplib::Request&, httplib::Response& response, const std::exception_ptr&) {
            answer_error(response, 500, "the server could not do it");
            tell("could not answer a request");
        });
}

// A client may send the token anywhere, even in parts that form it only in the printed line.
void StudioServer::tell(const std::string& told) {
    const std::string& token = guard_->token();
    std::string line = text::printable(told);
    for (std::size_t at = 0; (at = line.find(token, at)) != std::string::npos;)
        line.replace(at, token.size(), "TOKEN");
    log_.add(line);
}

void StudioServer::refuse(const httplib::Request& request, httplib::Response& response,
                          const Refusal& refusal) {
    answer_error(response, refusal.status, refusal.sentence);
    tell(fmt::format("refused {} from {}:{}: {}", request.method, request.remote_addr, request.remote_port,
                     refusal.sentence));
}

void StudioServer::ask(const httplib::Request& request, httplib::Response& response,
                       const httplib::ContentReader& content) {
    const auto counted = std::make_shared<Counted>(asks_);
    if (counted->number() > kMostAsks)
        return answer_error(response, 503, "the engine is at work on too much already");
    std::string asked;
    const bool whole = content([&](const char* bytes, std::size_t count) {
        asked.append(bytes, count);
        return asked.size() <= kLargestBody;
    });
    if (asked.size() > kLargestBody) {
        const Refusal refusal = too_large();
        return answer_error(response, refusal.status, refusal.sentence);
    }
    if (!whole) return answer_error(response, 400, "the request ended too soon");
    if (!nlohmann::json::accept(asked)) return answer_error(response, 400, "a request should be JSON");
    std::vector<std::string> command = served_.engine;
    std::shared_ptr<KeptRun> kept;
    if (const std::string name = request.get_header_value("Run"); !name.empty()) {
        auto made = kept_.add(name);
        if (!made) return answer_error(response, 507, made.error());
        kept = *made;
        command.insert(command.end(), {"--keep-behind", request.get_header_value("Whole")});
    }
    auto begun = EngineProcess::begin(command, asked, kept ? kept->number() : -1);
    if (!begun) return answer_error(response, 500, begun.error());
    const auto process = std::make_shared<EngineProcess>(*std::move(begun));
    const auto is_whole = std::make_shared<bool>(false);
    response.set_chunked_content_provider(
        "application/octet-stream",
        [this, process, counted, is_whole](std::size_t, httplib::DataSink& sink) {
            const auto piece = process->read(kLook_ms);
            if (piece && piece->empty()) return !stopping_ && sink.is_writable();
            if (piece) return sink.write(piece->data(), piece->size());
            if (const std::string fault = process->fault(); !fault.empty()) {
                tell(fault);
                const std::string message = failed_message(fault);
                sink.write(message.data(), message.size());
            }
            sink.done();
            *is_whole = true;
            return true;
        },
        [this, kept, is_whole](bool) {
            if (kept && !*is_whole) kept_.drop(kept);  // no page shows a cancelled run
        });
}

void StudioServer::read_laws(const std::string& run, const std::string& index, httplib::Response& response) {
    const auto kept = kept_.find(run);
    const auto message = kept ? kept->message(std::stoul(index)) : std::nullopt;
    if (!message) return answer_error(response, 404, "the run is kept no more, or has no such part");
    response.set_content(*message, "application/octet-stream");
}

void StudioServer::answer(httplib::Stream& stream, const std::function<void()>& admitted) {
    bool closed = false;
    WholeBodyStream whole(stream);
    process_request(whole, true, closed, [&](httplib::Request& request) {
        request.ranges.clear();  // thousands of them would be answered with thousands of copies
        const bool waits = request.get_header_value("Expect") == "100-continue";
        request.headers.erase("Expect");  // what is refused is so before it is sent
        if (guard_->refuse(request)) return;
        admitted();
        if (waits) stream.write("HTTP/1.1 100 Continue\r\n\r\n");
        whole.expect_body(announced_bytes(request));
    });
}

bool StudioServer::process_and_close_socket(socket_t socket) {
    keep_from_children(socket);
    try {
        answer_on(socket);
    } catch (const std::exception& fault) {
        tell(fmt::format("could not answer a request: {}", fault.what()));
    }
    ::close(socket);
    return true;
}

void StudioServer::answer_on(socket_t socket) {
    Connections::Entry entry(connections_, socket);
    GuardedStream stream(socket);
    answer(stream, [&entry] { entry.admit(); });
    entry.finish();
    if (stream.has_head()) return end_gently(socket);
    tell("ended a connection without a whole request");
    end_gently(socket, kHeadless);
}

}  // namespace gsim::studio
