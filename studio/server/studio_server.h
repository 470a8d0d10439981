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

/// What is served.
struct ServedStudio {
    os::BoundFolder folder;
    std::string page;                  ///< served.html, with the place for what the page is told.
    nlohmann::ordered_json told = {};  ///< What it is told.
    std::vector<std::string> engine;   ///< The command that answers what a page asks of the engine.
    RefusalLog::Sink log;              ///< Takes a line for each thing that is refused.
};

/// The page of the studio on this machine alone, with its folder and its engine (docs/studio.md). Whoever has
/// not the token gets nothing; requests are bounded in size and time, each connection serves one.
class StudioServer final : private httplib::Server {
  public:
    explicit StudioServer(ServedStudio served);
    ~StudioServer() override;

    /// Takes a port, 0: any; the port, or -1: it is taken already.
    int bind(int port);
    /// Of the page, behind bind().
    std::string address() const;
    /// Answers until stop() is called, from whichever thread.
    void serve();
    void stop_serving();

    /// Answers what stands on a stream, as serve() does with each connection: for tests.
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
