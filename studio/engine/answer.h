#pragma once

#include <string>

#include <tl/expected.hpp>

#include "base/text/json.h"
#include "engine/request.h"
#include "studio/engine/keys.h"
#include "studio/engine/run_messages.h"

namespace gsim::studio {

/// End of a response: "done", or "failed" with the error.
using Done = tl::expected<void, engine::Failure>;

/// Function that responds to a request by messages, all but the last. `own`: the keys that are not those of
/// `request`; unknown ones are rejected by name (keys.h).
using Answer = Done (*)(const nlohmann::json& own, const engine::Request& request, const Post& post);

/// Returns the error of an invalid request, with a message.
engine::Failure usage_failure(std::string sentence);
/// Checks that all keys were allowed.
Done end_of(Keys& keys);

// Requests for a program.
Done answer_run(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_check(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_translate(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_envelope(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_languages(const nlohmann::json& own, const engine::Request& request, const Post& post);

// Requests for forms.
Done answer_data(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_contours(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_drawing(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_materials(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_toml(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_keys(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_machine(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_pose(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_write(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_posts(const nlohmann::json& own, const engine::Request& request, const Post& post);

}  // namespace gsim::studio
