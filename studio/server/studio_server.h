#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include <httplib.h>

#include "base/os/rooted_directory.h"
#include "base/text/json.h"
#include "studio/server/access_check.h"
#include "studio/server/connections.h"
#include "studio/server/folder_request_handler.h"
#include "studio/server/rejection_log.h"
#include "studio/server/stored_run.h"

namespace gsim::studio {

/// Content that is served.
struct ServerContent {
    os::RootedDirectory folder;
    std::string page;                       ///< served.html, with a placeholder for the page's data.
    nlohmann::ordered_json page_data = {};  ///< Data for the page.
    std::vector<std::string> engine;        ///< Command that processes a page's requests to the engine.
    RejectionLog::Sink log;                 ///< Receives a line for each rejected request.
};

/// Server of the studio page for this computer alone, with its folder and its engine (docs/studio.md).
/// Clients without the token get no content; requests are limited in size and time, each connection serves
/// one.
class StudioServer final : private httplib::Server {
  public:
    explicit StudioServer(ServerContent server_content);
    ~StudioServer() override;

    /// Binds to a port, 0: any; returns the port, or -1: it is already used.
    int bind(int port);
    /// Returns the address of the page, after bind().
    std::string address() const;
    /// Serves requests until stop() is called, from any thread.
    void serve();
    void stop_serving();

    /// Serves the request on a stream, as serve() does with each connection: for tests.
    void handle_stream(httplib::Stream& stream, const std::function<void()>& on_accepted);

  private:
    bool process_and_close_socket(socket_t socket) override;
    void handle_connection(socket_t socket);
    void ask(const httplib::Request& request, httplib::Response& response,
             const httplib::ContentReader& content);
    void read_stored_message(const std::string& run, const std::string& index, httplib::Response& response);
    void add_routes();
    void write_log(const std::string& page_data);
    void reject(const httplib::Request& request, httplib::Response& response, const RequestError& rejection);

    ServerContent server_content_;
    FolderRequestHandler folder_;
    StoredRuns kept_;
    RejectionLog rejection_log_;
    Connections connections_;
    std::unique_ptr<AccessCheck> access_check_;
    std::string page_;
    std::string address_;
    std::atomic<bool> stopping_ = false;
    std::atomic<int> requests_ = 0;
};

}  // namespace gsim::studio
