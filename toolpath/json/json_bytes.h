#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <iterator>

#include "toolpath/model/place.h"

namespace gsim::path {

/// The bytes of a JSON text on their way to a parser, piece by piece, with the place of the token at hand: a
/// SAX parser tells values, but not where they stand.
class JsonBytes {
  public:
    /// Fills the buffer and returns how many bytes it wrote; 0 at the end.
    using Read = std::function<std::size_t(char* buffer, std::size_t size)>;

    explicit JsonBytes(Read read) : read_(std::move(read)) { fill(); }
    JsonBytes(const JsonBytes&) = delete;
    JsonBytes& operator=(const JsonBytes&) = delete;

    bool at_end() const { return next_ == end_; }
    char current() const { return buffer_[next_]; }
    void advance() {
        note(buffer_[next_]);
        if (++next_ == end_) fill();
    }

    /// Where the last string, number, word or opening bracket began.
    const Place& token() const { return token_; }
    /// Behind the last byte that was read.
    const Place& here() const { return here_; }

    /// What a parser reads by.
    class Iterator {
      public:
        using iterator_category = std::input_iterator_tag;
        using value_type = char;
        using difference_type = std::ptrdiff_t;
        using pointer = const char*;
        using reference = char;

        Iterator() = default;
        explicit Iterator(JsonBytes& bytes) : bytes_(&bytes) {}
        char operator*() const { return bytes_->current(); }
        Iterator& operator++() {
            bytes_->advance();
            return *this;
        }
        /// Against the end alone.
        bool operator==(const Iterator&) const { return bytes_->at_end(); }

      private:
        JsonBytes* bytes_ = nullptr;
    };

  private:
    void fill() {
        next_ = 0;
        end_ = read_(buffer_.data(), buffer_.size());
    }
    void note(char c);
    void note_outside(char c);

    static constexpr std::size_t kBuffer = std::size_t{1} << 16;

    Read read_;
    std::array<char, kBuffer> buffer_;
    std::size_t next_ = 0, end_ = 0;
    Place here_{1, 1}, token_{1, 1};
    bool in_string_ = false, escaped_ = false, in_word_ = false;
};

inline void JsonBytes::note(char c) {
    if (!in_string_) {
        note_outside(c);
    } else if (escaped_) {
        escaped_ = false;
    } else if (c == '\\') {
        escaped_ = true;
    } else {
        in_string_ = c != '"';
    }
    ++here_.column;
    if (c == '\n') here_ = {here_.line + 1, 1};
}

// A parser reads one byte beyond a number to see that it ends: what may stand there is no token of its own.
inline void JsonBytes::note_outside(char c) {
    switch (c) {
        case '"':
        case '{':
        case '[':
            token_ = here_;
            in_string_ = c == '"';
            in_word_ = false;
            break;
        case ' ':
        case '\t':
        case '\r':
        case '\n':
        case ',':
        case ':':
        case ']':
        case '}': in_word_ = false; break;
        default:
            if (!in_word_) token_ = here_;
            in_word_ = true;
    }
}

}  // namespace gsim::path
