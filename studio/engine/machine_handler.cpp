// Checks a machine and its cell, or lists all errors of their files.

#include <utility>

#include "base/text/json.h"
#include "engine/machine.h"
#include "engine/machine_errors.h"
#include "studio/engine/key_reader.h"
#include "studio/engine/message.h"
#include "studio/engine/request_handlers.h"

namespace gsim::studio {

VoidResult handle_machine(const nlohmann::json& parameters, const engine::Request& request,
                          const Post& post) {
    KeyReader keys(parameters, "machine");
    if (auto read = finish_keys(keys); !read) return read;
    const auto check = engine::Machine::read(request).and_then(
        [](const engine::Machine& machine) { return machine.check(); });
    if (!check) {
        for (const engine::Diagnostic& diagnostic : engine::find_machine_errors(request))
            send_diagnostic(diagnostic, post);
        return tl::unexpected(check.error());
    }
    Message message("machine");
    message.header()["check"] = text::parse_json<nlohmann::ordered_json>(check->json);
    message.header()["text"] = check->text;
    post(message.bytes());
    return {};
}

}  // namespace gsim::studio
