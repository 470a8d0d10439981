#pragma once

#include <string>

#include <tl/expected.hpp>

#include "base/text/json.h"
#include "engine/request.h"
#include "studio/engine/keys.h"
#include "studio/engine/run_messages.h"

namespace gsim::studio {

/// How an answer ends: "done", or "failed" with the failure.
using Done = tl::expected<void, engine::Failure>;

/// Answers a request by messages, all but the last. `own`: the keys that are not those of `request`, to be
/// refused by name where they are not known (keys.h).
using Answer = Done (*)(const nlohmann::json& own, const engine::Request& request, const Post& post);

/// What is asked for is wrong, in a sentence.
engine::Failure usage_failure(std::string sentence);
/// That all keys were such as may be.
Done end_of(Keys& keys);

// Of a program.
Done answer_run(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_check(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_translate(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_envelope(const nlohmann::json& own, const engine::Request& request, const Post& post);
Done answer_languages(const nlohmann::json& own, const engine::Request& request, const Post& post);

// Of forms.
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
