#pragma once

#include <memory>
#include <string>

#include "base/error.h"
#include "engine/run.h"

namespace gsim::apps {

/// Page that contains a finished run, for viewing in a browser (gsim-run --view; docs/studio.md).
class ViewPage {
  public:
    /// Reads the page that will contain the run, before the program gives up its read permissions. The error
    /// is a message: this build has no page.
    static Result<std::unique_ptr<ViewPage>> open(const std::string& file);
    ViewPage(const ViewPage&) = delete;
    ViewPage& operator=(const ViewPage&) = delete;
    ~ViewPage();

    /// Attaches to the run before run.go(), so that it is written to a temporary file as it is made.
    Result<void> attach(engine::Run& run);
    /// Writes the remainder after the run, with those sources of the run that can be read again. The error is
    /// a message, such as that of a full disk.
    Result<void> finish(const engine::Run& run, const engine::Report& report);
    /// Gives the file its name.
    Result<void> commit();

  private:
    class State;
    explicit ViewPage(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace gsim::apps
