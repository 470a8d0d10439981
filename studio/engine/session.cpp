#include "studio/engine/session.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "base/text/json.h"
#include "studio/engine/message.h"
#include "studio/engine/request.h"
#include "studio/engine/request_handlers.h"

namespace gsim::studio {

namespace {

using nlohmann::json;

/// Common keys of a request in addition to its specific ones: all of a run, or those that forms need.
enum class CommonKeys : std::uint8_t { run_keys, form_keys };

/// Kind of request that a page can send.
struct RequestType {
    const char* word;
    CommonKeys common_keys;
    RequestHandler handle;
};

constexpr std::array kRequestTypes = {
    RequestType{"run", CommonKeys::run_keys, handle_run},
    RequestType{"check", CommonKeys::run_keys, handle_check},
    RequestType{"translate", CommonKeys::run_keys, handle_translate},
    RequestType{"envelope", CommonKeys::run_keys, handle_envelope},
    RequestType{"languages", CommonKeys::run_keys, handle_languages},
    RequestType{"data", CommonKeys::form_keys, handle_data},
    RequestType{"contours", CommonKeys::form_keys, handle_contours},
    RequestType{"drawing", CommonKeys::form_keys, handle_drawing},
    RequestType{"materials", CommonKeys::form_keys, handle_materials},
    RequestType{"toml", CommonKeys::form_keys, handle_toml},
    RequestType{"keys", CommonKeys::form_keys, handle_keys},
    RequestType{"machine", CommonKeys::form_keys, handle_machine},
    RequestType{"pose", CommonKeys::form_keys, handle_pose},
    RequestType{"write", CommonKeys::form_keys, handle_write},
    RequestType{"posts", CommonKeys::form_keys, handle_posts},
};

engine::Error check_word(const json& word) {
    if (word.is_string()) return usage_error(fmt::format("unknown request '{}'", word.get<std::string>()));
    std::string words;
    for (const RequestType& row : kRequestTypes)
        words += fmt::format("{}{}", words.empty() ? "" : ", ", row.word);
    return usage_error(fmt::format("'do' must be a string, one of {}", words));
}

VoidResult handle(json request_json, const engine::Host& host, const Post& post) {
    if (!request_json.is_object()) return tl::unexpected(usage_error("a request must be an object"));
    const json word = request_json.value("do", json());
    const auto* const row = std::find_if(kRequestTypes.begin(), kRequestTypes.end(),
                                         [&](const RequestType& each) { return word == each.word; });
    if (row == kRequestTypes.end()) return tl::unexpected(check_word(word));
    request_json.erase("do");
    auto request =
        row->common_keys == CommonKeys::run_keys ? run_request(request_json) : form_request(request_json);
    if (!request) return tl::unexpected(usage_error(request.error().message));
    request->host = host;
    return row->handle(request_json, *request, post);
}

/// Keeps a message on one line, because names in it may contain any characters.
std::string one_line(const std::string& message) {
    std::string line;
    for (const char c : message) {
        const auto byte = static_cast<unsigned char>(c);
        const bool is_control = byte < 0x20 || byte == 0x7f;
        line += is_control ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
    }
    return line;
}

/// Sends the last message.
void end(const VoidResult& done, const Post& post) {
    Message message(done ? "done" : "failed");
    if (!done) {
        message.header().update({{"code", done.error().code},
                                 {"message", one_line(done.error().message)},
                                 {"file", done.error().file},
                                 {"in_program", done.error().in_program}});
    }
    post(message.bytes());
}

/// Converts an exception of a handler, such as a lack of memory, to an error.
template <typename Work>
VoidResult guard_exceptions(const Work& work) {
    try {
        return work();
    } catch (const std::exception& error) {
        return tl::unexpected(engine::Error{.code = "internal", .message = error.what()});
    }
}

}  // namespace

engine::Error usage_error(std::string message) {
    return {.code = "usage", .message = std::move(message)};
}

VoidResult finish_keys(KeyReader& keys) {
    return keys.end().map_error([](const gsim::Error& error) { return usage_error(error.message); });
}

void handle_request(std::string_view request_json, const engine::Host& host, const Post& post) {
    end(guard_exceptions([&]() -> VoidResult {
            auto read = text::try_parse_json<json>(request_json);
            if (read.is_discarded()) return tl::unexpected(usage_error("a request must be JSON"));
            return handle(std::move(read), host, post);
        }),
        post);
}

}  // namespace gsim::studio
