#pragma once

#include <string>

#include "engine/diagnostic.h"

namespace gsim::apps {

/// Returns the message of an error for callers that need only the message.
inline std::string sentence_of(const engine::Failure& failure) {
    return failure.message;
}

}  // namespace gsim::apps
