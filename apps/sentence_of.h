#pragma once

#include <string>

#include "engine/diagnostic.h"

namespace gsim::apps {

/// What is told of a failure where all that counts is its sentence.
inline std::string sentence_of(const engine::Failure& failure) {
    return failure.message;
}

}  // namespace gsim::apps
