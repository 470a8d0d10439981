// Lists the keys of files from which forms are made.

#include <array>
#include <optional>

#include "base/text/json.h"
#include "engine/file_keys.h"
#include "studio/engine/answer.h"
#include "studio/engine/keys.h"
#include "studio/engine/message.h"

namespace gsim::studio {

namespace {

constexpr std::array kFiles{"machine", "cell", "controller"};  // in the order of KeyedFile

}  // namespace

Done answer_keys(const nlohmann::json& own, const engine::Request& /*request*/, const Post& post) {
    std::optional<std::size_t> of;
    Keys keys(own, "keys");
    keys.need("of");
    keys.word("of", kFiles, of);
    if (auto read = end_of(keys); !read) return read;
    Message message("keys");
    message.header()["of"] = kFiles.at(*of);
    message.header()["tables"] =
        text::parse_json<nlohmann::ordered_json>(engine::file_keys_json(static_cast<engine::KeyedFile>(*of)));
    post(message.bytes());
    return {};
}

}  // namespace gsim::studio
