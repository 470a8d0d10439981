#pragma once

#include "base/error.h"
#include "engine/diagnostic.h"

namespace gsim::apps {

/// Returns an error of the engine for callers that need only its message.
inline Error to_error(const engine::Error& error) {
    return error.message;
}

}  // namespace gsim::apps
