#pragma once

#include <string>

#include <tl/expected.hpp>

#include "base/text/json.h"
#include "engine/run.h"
#include "engine/translation.h"

namespace gsim::studio {

/// A run as a page asks for it (docs/studio.md has the keys), `do` left out. The error is a sentence that
/// names the key.
tl::expected<engine::Request, std::string> run_request(const nlohmann::json& asked);

/// What forms have of it: takes machine, machine data and cell out of what an object asks.
tl::expected<engine::Request, std::string> form_request(nlohmann::json& asked);

/// A translation of the same program, as far as that is asked for.
engine::TranslationRequest translation_request(const engine::Request& run);

}  // namespace gsim::studio
