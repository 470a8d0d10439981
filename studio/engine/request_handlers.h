#pragma once

#include <string>

#include <tl/expected.hpp>

#include "base/text/json.h"
#include "engine/request.h"
#include "studio/engine/key_reader.h"
#include "studio/engine/run_messages.h"

namespace gsim::studio {

/// End of a response: "done", or "failed" with the error.
using VoidResult = tl::expected<void, engine::Error>;

/// Function that responds to a request by messages, all but the last. `parameters`: the keys that are not
/// those of `request`; unknown ones are rejected by name (keys.h).
using RequestHandler = VoidResult (*)(const nlohmann::json& parameters, const engine::Request& request,
                                      const Post& post);

/// Returns the error of an invalid request, with a message.
engine::Error usage_error(std::string message);
/// Checks that all keys were allowed.
VoidResult finish_keys(KeyReader& keys);

// Requests for a program.
VoidResult handle_run(const nlohmann::json& parameters, const engine::Request& request, const Post& post);
VoidResult handle_check(const nlohmann::json& parameters, const engine::Request& request, const Post& post);
VoidResult handle_translate(const nlohmann::json& parameters, const engine::Request& request,
                            const Post& post);
VoidResult handle_envelope(const nlohmann::json& parameters, const engine::Request& request,
                           const Post& post);
VoidResult handle_languages(const nlohmann::json& parameters, const engine::Request& request,
                            const Post& post);

// Requests for forms.
VoidResult handle_data(const nlohmann::json& parameters, const engine::Request& request, const Post& post);
VoidResult handle_contours(const nlohmann::json& parameters, const engine::Request& request,
                           const Post& post);
VoidResult handle_drawing(const nlohmann::json& parameters, const engine::Request& request, const Post& post);
VoidResult handle_materials(const nlohmann::json& parameters, const engine::Request& request,
                            const Post& post);
VoidResult handle_toml(const nlohmann::json& parameters, const engine::Request& request, const Post& post);
VoidResult handle_keys(const nlohmann::json& parameters, const engine::Request& request, const Post& post);
VoidResult handle_machine(const nlohmann::json& parameters, const engine::Request& request, const Post& post);
VoidResult handle_pose(const nlohmann::json& parameters, const engine::Request& request, const Post& post);
VoidResult handle_write(const nlohmann::json& parameters, const engine::Request& request, const Post& post);
VoidResult handle_posts(const nlohmann::json& parameters, const engine::Request& request, const Post& post);

}  // namespace gsim::studio
