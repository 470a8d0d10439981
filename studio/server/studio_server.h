#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include <httplib.h>

#include "base/os/bound_folder.h"
#include "base/text/json.h"
#include "studio/server/connections.h"
#include "studio/server/folder_answers.h"
#include "studio/server/guard.h"
#include "studio/server/kept_run.h"
#include "studio/server/refusal_log.h"

namespace gsim::studio {

/// Content that is served.
struct ServedStudio {
    os::BoundFolder folder;
    std::string page;                  ///< served.html, with a placeholder for the page's data.
    nlohmann::ordered_json told = {};  ///< Data for the page.
    std::vector<std::string> engine;   ///< Command that processes a page's requests to the engine.
    RefusalLog::Sink log;              ///< Receives a line for each rejected request.
};

/// Server of the studio page for this computer alone, with its folder and its engine (docs/studio.md).
/// Clients without the token get no content; requests are limited in size and time, each connection serves
/// one.
class StudioServer final : private httplib::Server {
  public:
    explicit StudioServer(ServedStudio served);
    ~StudioServer() override;

    /// Binds to a port, 0: any; returns the port, or -1: it is already used.
    int bind(int port);
    /// Returns the address of the page, after bind().
    std::string address() const;
    /// Serves requests until stop() is called, from any thread.
    void serve();
    void stop_serving();

    /// Serves the request on a stream, as serve() does with each connection: for tests.
    void answer(httplib::Stream& stream, const std::function<void()>& admitted);

  private:
    bool process_and_close_socket(socket_t socket) override;
    void answer_on(socket_t socket);
    void ask(const httplib::Request& request, httplib::Response& response,
             const httplib::ContentReader& content);
    void read_laws(const std::string& run, const std::string& index, httplib::Response& response);
    void add_routes();
    void tell(const std::string& told);
    void refuse(const httplib::Request& request, httplib::Response& response, const Refusal& refusal);

    ServedStudio served_;
    FolderAnswers folder_;
    KeptRuns kept_;
    RefusalLog log_;
    Connections connections_;
    std::unique_ptr<Guard> guard_;
    std::string page_;
    std::string address_;
    std::atomic<bool> stopping_ = false;
    std::atomic<int> asks_ = 0;
};

}  // namespace gsim::studio
