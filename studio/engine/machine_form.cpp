// Checks a machine and its cell, or lists all errors of their files.

#include <utility>

#include "base/text/json.h"
#include "engine/machine.h"
#include "engine/machine_faults.h"
#include "studio/engine/answer.h"
#include "studio/engine/keys.h"
#include "studio/engine/message.h"

namespace gsim::studio {

Done answer_machine(const nlohmann::json& own, const engine::Request& request, const Post& post) {
    Keys keys(own, "machine");
    if (auto read = end_of(keys); !read) return read;
    const auto check = engine::Machine::read(request).and_then(
        [](const engine::Machine& machine) { return machine.check(); });
    if (!check) {
        for (const engine::Diagnostic& fault : engine::find_machine_faults(request)) post_told(fault, post);
        return tl::unexpected(check.error());
    }
    Message message("machine");
    message.header()["check"] = text::parse_json<nlohmann::ordered_json>(check->json);
    message.header()["text"] = check->text;
    post(message.bytes());
    return {};
}

}  // namespace gsim::studio
