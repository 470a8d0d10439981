#pragma once

#include <string_view>

#include "engine/host.h"
#include "studio/engine/run_messages.h"

namespace gsim::studio {

/// Does what a page asks for, in JSON: `do` is "run", "check", "translate" and so on (docs/studio.md). All
/// that there is to tell is posted, "done" or "failed" the last. Throws what `post` throws, and where there
/// is no memory for the last message.
void serve(std::string_view asked, const engine::Host& host, const Post& post);

}  // namespace gsim::studio
