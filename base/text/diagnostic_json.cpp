#include "base/text/diagnostic_json.h"

namespace gsim::text {

namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(std::uint32_t number) {
    return number > 0 ? Json(number) : Json();
}

Json text_or_null(const std::string& text) {
    return text.empty() ? Json() : Json(text);
}

}  // namespace

Json to_json(std::span<const Diagnostic> diagnostics) {
    Json list = Json::array();
    for (const Diagnostic& each : diagnostics) {
        list.push_back({{"file", text_or_null(each.file)},
                        {"line", number_or_null(each.line)},
                        {"column", number_or_null(each.column)},
                        {"end_column", number_or_null(each.end_column)},
                        {"severity", name(each.severity)},
                        {"code", diagnostic_code(each.kind)},
                        {"text", each.text},
                        {"hint", text_or_null(each.hint)}});
    }
    return list;
}

}  // namespace gsim::text
