// Machines, cells and controllers in forms: hand-written TOML files, and changes of them.

#include <string>

#include "base/text/json.h"
#include "engine/toml_edit.h"
#include "studio/engine/key_reader.h"
#include "studio/engine/message.h"
#include "studio/engine/request_handlers.h"

namespace gsim::studio {

VoidResult handle_toml(const nlohmann::json& parameters, const engine::Request& request, const Post& post) {
    std::string file;
    KeyReader keys(parameters, "toml");
    keys.required_text("file", file);
    const nlohmann::json* changes = keys.list("changes");
    if (auto read = finish_keys(keys); !read) return read;
    const auto edit_result =
        engine::edited_toml(request.host, file, changes == nullptr ? "[]" : changes->dump(),
                            [&](const engine::Diagnostic& reported) { send_diagnostic(reported, post); });
    if (!edit_result) return tl::unexpected(edit_result.error());
    Message message("toml");
    message.header()["value"] = text::parse_json<nlohmann::ordered_json>(edit_result->json);
    message.add("text", edit_result->text);
    post(message.bytes());
    return {};
}

}  // namespace gsim::studio
