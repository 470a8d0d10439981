#pragma once

#include <string_view>

#include "engine/host.h"
#include "studio/engine/run_messages.h"

namespace gsim::studio {

/// Processes a page's request, in JSON: `do` is "run", "check", "translate" and so on (docs/studio.md). Posts
/// all results, "done" or "failed" last. Throws exceptions of `post`, and if the last message does not fit
/// into memory.
void handle_request(std::string_view request_json, const engine::Host& host, const Post& post);

}  // namespace gsim::studio
