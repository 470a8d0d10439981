#include "runtime/script/lua/plain_calls.h"

#include <charconv>

#include "base/text/digits.h"
#include "base/text/read_number.h"

namespace gsim::script {

namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Reader of one line, which stops at anything unknown.
class LineReader {
  public:
    explicit LineReader(std::string_view line) : at_(line.data()), end_(line.data() + line.size()) {}

    /// Returns true at the end of the line, or at a comment that runs to it.
    bool at_end() {
        skip_blanks();
        if (at_ == end_) return true;
        const std::string_view remainder(at_, static_cast<std::size_t>(end_ - at_));
        return remainder.starts_with("--") && !remainder.starts_with("--[");
    }

    bool read(PlainCall& call) {
        call.argument.reset();
        call.field_count = 0;
        call.word = name();
        if (call.word.empty() || at_ == end_) return false;
        call.has_table = *at_ == '{';
        if (consume('{')) return fields(call);
        return consume('(') && argument(call);
    }

  private:
    void skip_blanks() {
        while (at_ != end_ && *at_ == ' ') ++at_;
    }

    bool consume(char c) {
        if (at_ == end_ || *at_ != c) return false;
        ++at_;
        return true;
    }

    std::string_view name() {
        const char* const begin = at_;
        if (at_ == end_ || !is_letter(*at_)) return {};
        while (at_ != end_ && (is_letter(*at_) || text::is_digit(*at_))) ++at_;
        return {begin, static_cast<std::size_t>(at_ - begin)};
    }

    /// Reads a decimal number with an optional sign. A number that Lua reads as an integer becomes one.
    bool number(PlainCall::Number& value) {
        const char* const begin = at_;
        consume('-');
        const char* const digits = at_;
        bool point = false;
        for (; at_ != end_ && (text::is_digit(*at_) || (*at_ == '.' && !point)); ++at_) point |= *at_ == '.';
        const bool more = at_ != end_ && (is_letter(*at_) || *at_ == '.');
        if (more || at_ - digits == (point ? 1 : 0)) return false;
        return point ? parse_as<lua_Number>(begin, value) : parse_as<lua_Integer>(begin, value);
    }

    template <typename Kind>
    bool parse_as(const char* begin, PlainCall::Number& value) {
        Kind read = 0;
        std::from_chars_result result;
        if constexpr (std::is_floating_point_v<Kind>)
            result = text::read_number(begin, at_, read);
        else
            result = std::from_chars(begin, at_, read);
        value = read;
        return result.ec == std::errc() && result.ptr == at_;
    }

    bool argument(PlainCall& call) {
        if (consume(')')) return true;
        return number(call.argument.emplace()) && consume(')');
    }

    bool fields(PlainCall& call) {
        skip_blanks();
        if (consume('}')) return true;
        while (call.field_count < PlainCall::kMaxFields) {
            PlainCall::Field& field = call.all_fields[call.field_count++];
            skip_blanks();
            field.key = name();
            if (field.key.empty() || !consume('=') || !number(field.value)) return false;
            if (consume('}')) return true;
            if (!consume(',')) return false;
        }
        return false;
    }

    const char* at_;
    const char* end_;
};

}  // namespace

bool PlainLine::read(std::string_view line) {
    count_ = 0;
    std::size_t read = 0;
    for (LineReader reader(line); !reader.at_end(); ++read) {
        if (read == calls_.size()) calls_.emplace_back();
        if (!reader.read(calls_[read])) return false;
    }
    count_ = read;
    return true;
}

}  // namespace gsim::script
