#pragma once

#include <string>

#include "engine/diagnostic.h"

namespace gsim::apps {

/// Returns the message of an error for callers that need only the message.
inline std::string error_message(const engine::Error& error) {
    return error.message;
}

}  // namespace gsim::apps
