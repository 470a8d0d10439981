#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <iterator>

#include "toolpath/model/source_location.h"

namespace gsim::path {

/// Bytes of a JSON text that are passed to a parser part by part, with the source location of the current
/// token. A SAX parser reports values, but not their positions.
class JsonBytes {
  public:
    /// Function that fills the buffer and returns how many bytes it wrote; 0 at the end.
    using ReadFunction = std::function<std::size_t(char* buffer, std::size_t size)>;

    explicit JsonBytes(ReadFunction read) : read_(std::move(read)) { fill(); }
    JsonBytes(const JsonBytes&) = delete;
    JsonBytes& operator=(const JsonBytes&) = delete;

    bool at_end() const { return next_ == end_; }
    char current() const { return buffer_[next_]; }
    void advance() {
        note(buffer_[next_]);
        if (++next_ == end_) fill();
    }

    /// Returns the start position of the last string, number, word or opening bracket.
    const SourceLocation& token() const { return token_; }
    /// Returns the position of the next byte to be read.
    const SourceLocation& location() const { return location_; }

    /// Iterator with which a parser reads.
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
        /// Compares with the end only.
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
    void note_outside_string(char c);

    static constexpr std::size_t kBufferSize = std::size_t{1} << 16;

    ReadFunction read_;
    std::array<char, kBufferSize> buffer_;
    std::size_t next_ = 0, end_ = 0;
    SourceLocation location_{1, 1}, token_{1, 1};
    bool in_string_ = false, escaped_ = false, in_word_ = false;
};

inline void JsonBytes::note(char c) {
    if (!in_string_) {
        note_outside_string(c);
    } else if (escaped_) {
        escaped_ = false;
    } else if (c == '\\') {
        escaped_ = true;
    } else {
        in_string_ = c != '"';
    }
    ++location_.column;
    if (c == '\n') location_ = {location_.line + 1, 1};
}

// Handles the one byte that a parser reads beyond a number to detect its end: such a byte is no token of its
// own.
inline void JsonBytes::note_outside_string(char c) {
    switch (c) {
        case '"':
        case '{':
        case '[':
            token_ = location_;
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
            if (!in_word_) token_ = location_;
            in_word_ = true;
    }
}

}  // namespace gsim::path
