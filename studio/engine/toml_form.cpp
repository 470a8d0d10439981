// Machines, cells and controllers in forms: hand-written TOML files, and changes of them.

#include <string>

#include "base/text/json.h"
#include "engine/toml_edit.h"
#include "studio/engine/answer.h"
#include "studio/engine/keys.h"
#include "studio/engine/message.h"

namespace gsim::studio {

Done answer_toml(const nlohmann::json& own, const engine::Request& request, const Post& post) {
    std::string file;
    Keys keys(own, "toml");
    keys.needed_text("file", file);
    const nlohmann::json* changes = keys.list("changes");
    if (auto read = end_of(keys); !read) return read;
    const auto edited = engine::edited_toml(request.host, file, changes == nullptr ? "[]" : changes->dump(),
                                            [&](const engine::Diagnostic& told) { post_told(told, post); });
    if (!edited) return tl::unexpected(edited.error());
    Message message("toml");
    message.header()["value"] = text::parse_json<nlohmann::ordered_json>(edited->json);
    message.add("text", edited->text);
    post(message.bytes());
    return {};
}

}  // namespace gsim::studio
