// Stub for WebAssembly, which runs in the page itself and has no zlib, and for gsim-first, which has no
// engine of the page.

#include "apps/studio/view_page.h"

namespace gsim::apps {

class ViewPage::State {};

ViewPage::ViewPage(std::unique_ptr<State> state) : state_(std::move(state)) {}
ViewPage::~ViewPage() = default;

Result<std::unique_ptr<ViewPage>> ViewPage::open(const std::string& /*file*/) {
    return Unexpected("this build does not create pages (--view); make build builds the program that does");
}

Result<void> ViewPage::attach(engine::Run& /*run*/) {
    return {};
}

Result<void> ViewPage::finish(const engine::Run& /*run*/, const engine::Report& /*report*/) {
    return {};
}

Result<void> ViewPage::commit() {
    return {};
}

}  // namespace gsim::apps
