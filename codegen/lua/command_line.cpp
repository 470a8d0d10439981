#include "codegen/lua/command_line.h"

#include <algorithm>

#include "base/text/letter_case.h"
#include "base/text/trimmed.h"

namespace gsim::codegen {

namespace {

constexpr std::size_t kReadBytes = std::size_t{64} << 10U;

bool is_key(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

std::uint32_t text_column(std::size_t index) {
    return static_cast<std::uint32_t>(index) + 1;
}

/// Splits runs of letters, or an asterisk, each with the text before the next one.
std::vector<Parameter> parse_parameters(std::string_view line, std::size_t from) {
    std::vector<Parameter> parameters;
    while (from < line.size()) {
        std::size_t end = from + 1;
        if (line[from] != '*') {
            while (end < line.size() && is_key(line[end])) ++end;
        }
        std::size_t next = end;
        while (next < line.size() && !is_key(line[next]) && line[next] != '*') ++next;
        parameters.push_back({text::upper(line.substr(from, end - from)),
                              std::string(text::trimmed(line.substr(end, next - end), kLineBlanks)),
                              text_column(from)});
        from = next;
    }
    return parameters;
}

std::size_t first_key(std::string_view line) {
    const auto* const key =
        std::find_if(line.begin(), line.end(), [](char c) { return is_key(c) || c == '*'; });
    return static_cast<std::size_t>(key - line.begin());
}

}  // namespace

CommandLine command_line(std::string_view line) {
    CommandLine read;
    const std::size_t remark = std::min(line.find(';'), line.size());
    if (remark < line.size()) read.remark = text::trimmed(line.substr(remark + 1), kLineBlanks);
    line = line.substr(0, remark);
    const std::size_t begin = std::min(line.find_first_not_of(kLineBlanks), line.size());
    const std::size_t key = first_key(line);
    read.column = text_column(begin);
    if (key == line.size()) {
        read.command = text::trimmed(line, kLineBlanks);
        return read;
    }
    read.parameters = parse_parameters(line, key);
    std::size_t first = 0;
    const bool numbered = key == begin && read.parameters[0].key == "N" && read.parameters.size() > 1;
    if (numbered) first = 1;  // a line number is passed over
    const Parameter& command_word = read.parameters[first];
    read.command = command_word.key + command_word.value;
    if (!numbered) read.command.insert(0, text::upper(text::trimmed(line.substr(0, key), kLineBlanks)));
    if (numbered) read.column = command_word.column;
    const std::size_t after = command_word.column - 1 + command_word.key.size();
    read.tail = line.substr(after);
    read.parameters.erase(read.parameters.begin(),
                          read.parameters.begin() + static_cast<std::ptrdiff_t>(first) + 1);
    return read;
}

bool named_parameters(const CommandLine& line, std::vector<Parameter>& parameters) {
    std::string_view remainder = line.tail.substr(0, line.tail.find('#'));
    while (!(remainder = text::trimmed(remainder, kLineBlanks)).empty()) {
        const std::string_view one = remainder.substr(0, remainder.find_first_of(kLineBlanks));
        remainder.remove_prefix(one.size());
        const std::size_t equals = one.find('=');
        if (equals == std::string_view::npos) return false;
        parameters.push_back({text::upper(one.substr(0, equals)),
                              std::string(text::trimmed(one.substr(equals + 1), "\"'")), line.column});
    }
    return true;
}

bool SourceLines::fill() {
    buffer_.erase(0, at_);
    at_ = 0;
    const std::size_t buffered = buffer_.size();
    buffer_.resize(buffered + kReadBytes);
    const std::size_t count = source_.read(buffer_.data() + buffered, kReadBytes);
    buffer_.resize(buffered + count);
    return count > 0;
}

bool SourceLines::next() {
    begin_ = next_begin_;
    line_.clear();
    too_long_ = false;
    bool any = false;
    while (true) {
        const std::size_t end = std::min(buffer_.find('\n', at_), buffer_.size());
        const std::string_view fragment = std::string_view(buffer_).substr(at_, end - at_);
        const std::size_t space_left = lexer::kMaxLineBytes - line_.size();
        too_long_ = too_long_ || fragment.size() > space_left;
        line_ += fragment.substr(0, space_left);
        any = any || !fragment.empty();
        next_begin_ += fragment.size();
        at_ = end;
        if (at_ < buffer_.size()) break;
        if (!fill()) {
            if (any) ++number_;
            return any;
        }
    }
    ++at_;
    ++next_begin_;
    ++number_;
    return true;
}

}  // namespace gsim::codegen
