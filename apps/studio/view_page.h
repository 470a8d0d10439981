#pragma once

#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "engine/run.h"

namespace gsim::apps {

/// A page with a finished run in it, to look at in a browser (gsim-run --view; docs/studio.md).
class ViewPage {
  public:
    /// Reads the page into which the run goes; before the program gives up its rights to read. The error is a
    /// sentence: this build has no page.
    static tl::expected<std::unique_ptr<ViewPage>, std::string> open(const std::string& file);
    ViewPage(const ViewPage&) = delete;
    ViewPage& operator=(const ViewPage&) = delete;
    ~ViewPage();

    /// Before run.go(); the run goes to a temporary file as it is made. The error is a sentence.
    tl::expected<void, std::string> attach(engine::Run& run);
    /// Behind it: the rest, with those sources of the run that can be read again. The error is a sentence,
    /// such as that of a full disk.
    tl::expected<void, std::string> finish(const engine::Run& run, const engine::Report& report);
    /// Gives the file its name. The error is a sentence.
    tl::expected<void, std::string> commit();

  private:
    class State;
    explicit ViewPage(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace gsim::apps
