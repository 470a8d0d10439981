#include "lexer/block_text.h"

namespace gsim::lexer {

std::string address_name(Address address) {
    switch (address) {
        case kArcAngle: return "AR=";
        case kViaX: return "I1=";
        case kViaY: return "J1=";
        case kViaZ: return "K1=";
        case kIntermediatePoint: return "CIP";
        case kChamfer: return ",C";
        case kCornerRadius: return ",R";
        case kLineAngle: return ",A";
        default: return std::string(1, static_cast<char>(address));
    }
}

Slice BlockText::add(std::string_view fragment) {
    const Slice slice{static_cast<std::uint32_t>(text.size()), static_cast<std::uint32_t>(fragment.size())};
    text.append(fragment);
    return slice;
}

void BlockText::clear() {
    words.clear();
    numbers.clear();
    comments.clear();
    text.clear();
    raw.clear();
    program = {};
    print = {};
    end = BlockEnd::line;
    has_line_comment = false;
    structural = false;
    bad = false;
}

}  // namespace gsim::lexer
