#include "base/os/bound_name.h"

#include <algorithm>

#include "base/text/utf8.h"

namespace gsim::os {

namespace {

constexpr std::size_t kLongestName = 1024;
constexpr std::size_t kLongestPart = 255;  // NAME_MAX

const char* fault_of(std::string_view part) {
    if (part.empty()) return "has an empty part, as names that begin or end with / have";
    if (part.front() == '.') return "has a part that begins with a dot";
    if (part.size() > kLongestPart) return "has a part that is too long";
    const auto is_strange = [](unsigned char c) { return c < 0x20 || c == 0x7f || c == '\\'; };
    if (std::any_of(part.begin(), part.end(), is_strange)) return "has a control character or a backslash";
    return nullptr;
}

}  // namespace

tl::expected<std::vector<std::string>, std::string> parts_of_bound_name(std::string_view name) {
    if (name.size() > kLongestName) return tl::unexpected(std::string("the name of the file is too long"));
    if (!text::is_utf8(name)) return tl::unexpected(std::string("the name of the file is no UTF-8"));
    std::vector<std::string> parts;
    for (;;) {
        const std::size_t end = std::min(name.find('/'), name.size());
        const std::string_view part = name.substr(0, end);
        if (const char* fault = fault_of(part))
            return tl::unexpected(std::string("the name of the file ") + fault);
        parts.emplace_back(part);
        if (end == name.size()) return parts;
        name.remove_prefix(end + 1);
    }
}

}  // namespace gsim::os
