#pragma once

#include <string>

#include "base/error.h"
#include "base/text/json.h"
#include "engine/run.h"
#include "engine/translation.h"

namespace gsim::studio {

/// Reads a page's request for a run (docs/studio.md has the keys), without `do`. The error is a message that
/// names the key.
Result<engine::Request> run_request(const nlohmann::json& request_json);

/// Reads the part that forms use: takes machine, machine data and cell out of the object's keys.
Result<engine::Request> form_request(nlohmann::json& request_json);

/// Returns a translation request for the same program, as far as it contains one.
engine::TranslationRequest translation_request(const engine::Request& run);

}  // namespace gsim::studio
