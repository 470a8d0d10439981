#include "base/os/safe_name.h"

#include <algorithm>

#include "base/text/utf8.h"

namespace gsim::os {

namespace {

constexpr std::size_t kMaxNameLength = 1024;
constexpr std::size_t kMaxPartLength = 255;  // NAME_MAX

const char* name_error(std::string_view part) {
    if (part.empty()) return "has an empty part, such as a name that begins or ends with /";
    if (part.front() == '.') return "has a part that begins with a dot";
    if (part.size() > kMaxPartLength) return "has a part that is too long";
    const auto is_forbidden = [](unsigned char c) { return c < 0x20 || c == 0x7f || c == '\\'; };
    if (std::any_of(part.begin(), part.end(), is_forbidden)) return "has a control character or a backslash";
    return nullptr;
}

}  // namespace

Result<std::vector<std::string>> safe_name_parts(std::string_view name) {
    if (name.size() > kMaxNameLength) return Unexpected("the name of the file is too long");
    if (!text::is_utf8(name)) return Unexpected("the name of the file is not UTF-8");
    std::vector<std::string> parts;
    for (;;) {
        const std::size_t end = std::min(name.find('/'), name.size());
        const std::string_view part = name.substr(0, end);
        if (const char* error = name_error(part))
            return tl::unexpected(std::string("the name of the file ") + error);
        parts.emplace_back(part);
        if (end == name.size()) return parts;
        name.remove_prefix(end + 1);
    }
}

}  // namespace gsim::os
