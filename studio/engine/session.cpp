#include "studio/engine/session.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "base/text/json.h"
#include "studio/engine/answer.h"
#include "studio/engine/message.h"
#include "studio/engine/request.h"

namespace gsim::studio {

namespace {

using engine::Failure;
using nlohmann::json;

/// Common keys of a request in addition to its specific ones: all of a run, or those that forms need.
enum class Common : std::uint8_t { of_run, of_form };

/// Kind of request that a page can send.
struct Row {
    const char* word;
    Common common;
    Answer answer;
};

constexpr std::array kRows = {
    Row{"run", Common::of_run, answer_run},
    Row{"check", Common::of_run, answer_check},
    Row{"translate", Common::of_run, answer_translate},
    Row{"envelope", Common::of_run, answer_envelope},
    Row{"languages", Common::of_run, answer_languages},
    Row{"data", Common::of_form, answer_data},
    Row{"contours", Common::of_form, answer_contours},
    Row{"drawing", Common::of_form, answer_drawing},
    Row{"materials", Common::of_form, answer_materials},
    Row{"toml", Common::of_form, answer_toml},
    Row{"keys", Common::of_form, answer_keys},
    Row{"machine", Common::of_form, answer_machine},
    Row{"pose", Common::of_form, answer_pose},
    Row{"write", Common::of_form, answer_write},
    Row{"posts", Common::of_form, answer_posts},
};

Failure fault_of_word(const json& word) {
    if (word.is_string())
        return usage_failure(fmt::format("nothing is known of how to do '{}'", word.get<std::string>()));
    std::string words;
    for (const Row& row : kRows) words += fmt::format("{}{}", words.empty() ? "" : ", ", row.word);
    return usage_failure(fmt::format("'do' should be a text, one of {}", words));
}

Done answer(json asked, const engine::Host& host, const Post& post) {
    if (!asked.is_object()) return tl::unexpected(usage_failure("a request should be an object"));
    const json word = asked.value("do", json());
    const auto* const row =
        std::find_if(kRows.begin(), kRows.end(), [&](const Row& each) { return word == each.word; });
    if (row == kRows.end()) return tl::unexpected(fault_of_word(word));
    asked.erase("do");
    auto request = row->common == Common::of_run ? run_request(asked) : form_request(asked);
    if (!request) return tl::unexpected(usage_failure(request.error()));
    request->host = host;
    return row->answer(asked, *request, post);
}

/// Keeps a message on one line, because names in it may contain any characters.
std::string one_line(const std::string& sentence) {
    std::string line;
    for (const char c : sentence) {
        const auto byte = static_cast<unsigned char>(c);
        const bool is_control = byte < 0x20 || byte == 0x7f;
        line += is_control ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
    }
    return line;
}

/// Sends the last message.
void end(const Done& done, const Post& post) {
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
Done guarded(const Work& work) {
    try {
        return work();
    } catch (const std::exception& fault) {
        return tl::unexpected(Failure{.code = "internal", .message = fault.what()});
    }
}

}  // namespace

Failure usage_failure(std::string sentence) {
    return {.code = "usage", .message = std::move(sentence)};
}

Done end_of(Keys& keys) {
    return keys.end().map_error(usage_failure);
}

void serve(std::string_view asked, const engine::Host& host, const Post& post) {
    end(guarded([&]() -> Done {
            auto read = text::try_parse_json<json>(asked);
            if (read.is_discarded()) return tl::unexpected(usage_failure("a request should be JSON"));
            return answer(std::move(read), host, post);
        }),
        post);
}

}  // namespace gsim::studio
