// Stub for WebAssembly, which runs in the page itself and has no zlib, and for gsim-first, which has no
// engine of the page.

#include "apps/studio/view_page.h"

namespace gsim::apps {

class ViewPage::State {};

ViewPage::ViewPage(std::unique_ptr<State> state) : state_(std::move(state)) {}
ViewPage::~ViewPage() = default;

tl::expected<std::unique_ptr<ViewPage>, std::string> ViewPage::open(const std::string& /*file*/) {
    return tl::unexpected(
        std::string("this build makes no pages (--view); make build builds the program that does"));
}

tl::expected<void, std::string> ViewPage::attach(engine::Run& /*run*/) {
    return {};
}

tl::expected<void, std::string> ViewPage::finish(const engine::Run& /*run*/,
                                                 const engine::Report& /*report*/) {
    return {};
}

tl::expected<void, std::string> ViewPage::commit() {
    return {};
}

}  // namespace gsim::apps
