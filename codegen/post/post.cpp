#include "codegen/post/post.h"

namespace gsim::codegen {

std::string fill_template(std::string_view line, const PlaceholderValues& placeholders) {
    std::string out;
    while (!line.empty()) {
        const std::size_t open = line.find('{');
        const std::size_t close = open == std::string_view::npos ? open : line.find('}', open);
        if (close == std::string_view::npos) break;
        out += line.substr(0, open);
        const auto found = placeholders.find(line.substr(open + 1, close - open - 1));
        out += found == placeholders.end() ? line.substr(open, close - open + 1)
                                           : std::string_view(found->second);
        line.remove_prefix(close + 1);
    }
    out += line;
    return out;
}

}  // namespace gsim::codegen
