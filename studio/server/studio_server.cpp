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
#include "studio/server/buffered_body_stream.h"
#include "studio/server/engine_process.h"
#include "studio/server/json_response.h"
#include "studio/server/limited_stream.h"
#include "studio/server/lingering_close.h"

namespace gsim::studio {

namespace {

constexpr const char* kHost = "127.0.0.1";
constexpr std::size_t kMaxConnections = 200;
constexpr int kMaxEngineRequests = 8;
constexpr int kPollInterval_ms = 200;
constexpr std::string_view kServerPlaceholder = "<!-- server -->";
/// Limits for a sender without a complete head.
constexpr CloseLimits kCloseLimitsWithoutHead{.bytes = std::size_t{256} << 10U,
                                              .time = std::chrono::milliseconds(200),
                                              .pause = std::chrono::milliseconds(200)};

/// Returns headers that make browsers protect this page from other sites, and other sites from it. Sources:
/// CSP 3, Fetch, HTML (COOP).
const httplib::Headers& security_headers() {
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

void set_close_on_exec(int socket) {
    ::fcntl(socket, F_SETFD, FD_CLOEXEC);
}

/// Returns the last message if the engine could not write it.
std::string failed_message(const std::string& text) {
    Message message("failed");
    message.header().update({{"code", "internal"}, {"message", text}, {"file", ""}, {"in_program", false}});
    return message.bytes();
}

/// Scoped counter of active work.
class CountedRequest {
  public:
    explicit CountedRequest(std::atomic<int>& count) : count_(count), number_(++count) {}
    CountedRequest(const CountedRequest&) = delete;
    CountedRequest& operator=(const CountedRequest&) = delete;
    ~CountedRequest() { --count_; }
    int number() const { return number_; }

  private:
    std::atomic<int>& count_;
    int number_;
};

}  // namespace

StudioServer::StudioServer(ServerContent server_content)
    : server_content_(std::move(server_content)),
      folder_(server_content_.folder),
      rejection_log_(server_content_.log),
      connections_(kMaxConnections) {
    const std::size_t slot = server_content_.page.find(kServerPlaceholder);
    if (slot == std::string::npos) throw std::invalid_argument("the page has no placeholder for its server");
    page_ =
        server_content_.page.replace(slot, kServerPlaceholder.size(), inline_json(server_content_.page_data));
    set_keep_alive_max_count(1);
    set_default_headers(security_headers());
    set_socket_options([](int socket) {
        const int on = 1;
        ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
        set_close_on_exec(socket);
    });
    new_task_queue = [this] { return new ConnectionThreads(connections_); };  // cpp-httplib deletes it
}

StudioServer::~StudioServer() = default;

int StudioServer::bind(int port) {
    int bound_port = port;
    if (port == 0) {
        bound_port = bind_to_any_port(kHost);
    } else if (!bind_to_port(kHost, port)) {
        return -1;
    }
    if (bound_port < 0) return -1;
    ::listen(svr_sock_, SOMAXCONN);  // cpp-httplib lets five wait: a sixth would try again after a second
    access_check_ = std::make_unique<AccessCheck>(bound_port, random_token());
    address_ = fmt::format("http://{}:{}/{}/", kHost, bound_port, access_check_->token());
    add_routes();
    return bound_port;
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
    const std::string url_prefix = "/" + access_check_->token();
    set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
        const auto rejection = access_check_->reject(request);
        if (!rejection) return HandlerResponse::Unhandled;
        reject(request, response, *rejection);
        return HandlerResponse::Handled;
    });
    Get(url_prefix + "/", [this](const httplib::Request&, httplib::Response& response) {
        response.set_content(page_, "text/html; charset=utf-8");
    });
    Get(url_prefix + "/files",
        [this](const httplib::Request&, httplib::Response& response) { folder_.list(response); });
    Get(url_prefix + "/changes", [this](const httplib::Request& request, httplib::Response& response) {
        folder_.changes(request, response);
    });
    const std::string files = url_prefix + "/file/";
    Get(files + "([^]*)", [this, files](const httplib::Request& request, httplib::Response& response) {
        folder_.read(request.path.substr(files.size()), response);
    });
    Put(files + "([^]*)", [this, files](const httplib::Request& request, httplib::Response& response,
                                        const httplib::ContentReader& content) {
        folder_.write(request.path.substr(files.size()), request, response, content);
    });
    Post(url_prefix + "/ask",
         [this](const httplib::Request& request, httplib::Response& response,
                const httplib::ContentReader& content) { ask(request, response, content); });
    Get(url_prefix + "/laws/([0-9a-f]{16})/([0-9]{1,9})",
        [this](const httplib::Request& request, httplib::Response& response) {
            read_stored_message(request.matches[1], request.matches[2], response);
        });
    // Without a handler cpp-httplib would store data of any size.
    const auto reject_body = [](const httplib::Request&, httplib::Response& response,
                                const httplib::ContentReader&) { response.status = 404; };
    Post("[^]*", reject_body);
    Put("[^]*", reject_body);
    set_error_handler([this](const httplib::Request& request, httplib::Response& response) {
        if (response.body.empty()) respond_error(response, response.status, "not found");
        const bool is_expected_status =
            response.status == 404 || response.status == 412;              // a page requests a removed file
        if (is_expected_status || access_check_->reject(request)) return;  // the latter is already logged
        write_log(fmt::format("rejected {} ({}): {}", request.method, response.status, response.body));
    });
    set_exception_handler(
        [this](const httplib::Request&, httplib::Response& response, const std::exception_ptr&) {
            respond_error(response, 500, "internal server error");
            write_log("could not handle a request");
        });
}

// A client may send the token anywhere, even in parts that form it only in the printed line.
void StudioServer::write_log(const std::string& page_data) {
    const std::string& token = access_check_->token();
    std::string line = text::printable(page_data);
    for (std::size_t at = 0; (at = line.find(token, at)) != std::string::npos;)
        line.replace(at, token.size(), "TOKEN");
    rejection_log_.add(line);
}

void StudioServer::reject(const httplib::Request& request, httplib::Response& response,
                          const RequestError& rejection) {
    respond_error(response, rejection.status, rejection.message);
    write_log(fmt::format("rejected {} from {}:{}: {}", request.method, request.remote_addr,
                          request.remote_port, rejection.message));
}

void StudioServer::ask(const httplib::Request& request, httplib::Response& response,
                       const httplib::ContentReader& content) {
    const auto counted = std::make_shared<CountedRequest>(requests_);
    if (counted->number() > kMaxEngineRequests)
        return respond_error(response, 503, "the engine is busy with too many requests");
    std::string request_body;
    const bool has_full_body = content([&](const char* bytes, std::size_t count) {
        request_body.append(bytes, count);
        return request_body.size() <= kMaxBodyBytes;
    });
    if (request_body.size() > kMaxBodyBytes) {
        const RequestError rejection = too_large();
        return respond_error(response, rejection.status, rejection.message);
    }
    if (!has_full_body) return respond_error(response, 400, "the request ended prematurely");
    if (!nlohmann::json::accept(request_body)) return respond_error(response, 400, "a request must be JSON");
    std::vector<std::string> command = server_content_.engine;
    std::shared_ptr<StoredRun> kept;
    if (const std::string name = request.get_header_value("Run"); !name.empty()) {
        auto added_run = kept_.add(name);
        if (!added_run) return respond_error(response, 507, added_run.error().message);
        kept = *added_run;
        command.insert(command.end(), {"--keep-behind", request.get_header_value("Whole")});
    }
    auto begun = EngineProcess::begin(command, request_body, kept ? kept->number() : -1);
    if (!begun) return respond_error(response, 500, begun.error().message);
    const auto process = std::make_shared<EngineProcess>(*std::move(begun));
    const auto is_complete = std::make_shared<bool>(false);
    response.set_chunked_content_provider(
        "application/octet-stream",
        [this, process, counted, is_complete](std::size_t, httplib::DataSink& sink) {
            const auto chunk = process->read(kPollInterval_ms);
            if (chunk && chunk->empty()) return !stopping_ && sink.is_writable();
            if (chunk) return sink.write(chunk->data(), chunk->size());
            if (const std::string error = process->error(); !error.empty()) {
                write_log(error);
                const std::string message = failed_message(error);
                sink.write(message.data(), message.size());
            }
            sink.done();
            *is_complete = true;
            return true;
        },
        [this, kept, is_complete](bool) {
            if (kept && !*is_complete) kept_.drop(kept);  // no page shows a cancelled run
        });
}

void StudioServer::read_stored_message(const std::string& run, const std::string& index,
                                       httplib::Response& response) {
    const auto kept = kept_.find(run);
    const auto message = kept ? kept->message(std::stoul(index)) : std::nullopt;
    if (!message)
        return respond_error(response, 404, "the run is no longer stored, or does not have this part");
    response.set_content(*message, "application/octet-stream");
}

void StudioServer::handle_stream(httplib::Stream& stream, const std::function<void()>& on_accepted) {
    bool closed = false;
    BufferedBodyStream has_full_body(stream);
    process_request(has_full_body, true, closed, [&](httplib::Request& request) {
        request.ranges.clear();  // thousands of them would be answered with thousands of copies
        const bool waits = request.get_header_value("Expect") == "100-continue";
        request.headers.erase("Expect");  // what is refused is so before it is sent
        if (access_check_->reject(request)) return;
        on_accepted();
        if (waits) stream.write("HTTP/1.1 100 Continue\r\n\r\n");
        has_full_body.expect_body(declared_body_bytes(request));
    });
}

bool StudioServer::process_and_close_socket(socket_t socket) {
    set_close_on_exec(socket);
    try {
        handle_connection(socket);
    } catch (const std::exception& error) {
        write_log(fmt::format("could not handle a request: {}", error.what()));
    }
    ::close(socket);
    return true;
}

void StudioServer::handle_connection(socket_t socket) {
    Connections::Entry entry(connections_, socket);
    LimitedStream stream(socket);
    handle_stream(stream, [&entry] { entry.accept_request(); });
    entry.finish();
    if (stream.has_head()) return lingering_close(socket);
    write_log("closed a connection without a complete request");
    lingering_close(socket, kCloseLimitsWithoutHead);
}

}  // namespace gsim::studio
