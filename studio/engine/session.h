#pragma once

#include <string_view>

#include "engine/host.h"
#include "studio/engine/run_messages.h"

namespace gsim::studio {

/// Processes a page's request, in JSON: `do` is "run", "check", "translate" and so on (docs/studio.md). Posts
/// all results, "done" or "failed" last. Throws exceptions of `post`, and if the last message does not fit
/// into memory.
void serve(std::string_view asked, const engine::Host& host, const Post& post);

}  // namespace gsim::studio
