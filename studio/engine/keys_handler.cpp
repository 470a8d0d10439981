// Lists the keys of files from which forms are made.

#include <array>
#include <optional>

#include "base/text/json.h"
#include "engine/file_keys.h"
#include "studio/engine/key_reader.h"
#include "studio/engine/message.h"
#include "studio/engine/request_handlers.h"

namespace gsim::studio {

namespace {

constexpr std::array kFiles{"machine", "cell", "controller"};  // in the order of ConfigFileKind

}  // namespace

VoidResult handle_keys(const nlohmann::json& parameters, const engine::Request& /*request*/,
                       const Post& post) {
    std::optional<std::size_t> of;
    KeyReader keys(parameters, "keys");
    keys.require("of");
    keys.word("of", kFiles, of);
    if (auto read = finish_keys(keys); !read) return read;
    Message message("keys");
    message.header()["of"] = kFiles.at(*of);
    message.header()["tables"] = text::parse_json<nlohmann::ordered_json>(
        engine::file_keys_json(static_cast<engine::ConfigFileKind>(*of)));
    post(message.bytes());
    return {};
}

}  // namespace gsim::studio
