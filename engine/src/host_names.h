#pragma once

#include <string>

#include "base/error.h"
#include "engine/host.h"

namespace gsim::engine {

/// Returns the file that a name means: Host::find, or the name itself. An empty name stays empty.
Result<std::string> resolve_name(const Host& host, NameKind kind, const std::string& name);

}  // namespace gsim::engine
