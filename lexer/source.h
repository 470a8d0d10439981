#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "base/os/files.h"
#include "base/os/input_file.h"

namespace gsim::lexer {

/// Maximum length of a line, in bytes; a longer line is cut and reported. It limits the scanner's memory.
inline constexpr std::size_t kMaxLineBytes = 65536;

/// Text of one part program: read in sequence, read again from the start, and looked up by offset for
/// messages. A file is never completely in memory, so its length does not matter.
class Source {
  public:
    /// Name of a source that is standard input.
    static constexpr std::string_view kStandardInput = "stdin";

    /// Opens a regular file, or copies the data of a pipe like spool(). The error is a message for the user.
    static tl::expected<Source, std::string> open(const std::string& path,
                                                  os::NameSource name_source = os::NameSource::in_file);
    /// Does the same for files that may be those of a program.
    static tl::expected<Source, std::string> open(const os::Files& files, const std::string& path,
                                                  os::NameSource name_source = os::NameSource::in_file);
    /// Copies a stream that cannot be read twice (standard input) to an anonymous temporary file.
    static tl::expected<Source, std::string> spool(std::FILE* stream, std::string name);
    /// Makes a source from a text in memory.
    static Source from_text(std::string text, std::string name);

    const std::string& name() const { return name_; }
    void set_name(std::string name) { name_ = std::move(name); }
    std::uint64_t size() const { return size_; }

    /// Sets a condition that ends reading in sequence early: `should_stop` is called at each read, and true
    /// holds from then on.
    void set_end_condition(std::function<bool()> should_stop) { ends_ = std::move(should_stop); }
    /// Returns true if that has happened: the file was not read completely.
    bool ended_early() const { return ended_early_; }
    /// Reads up to `capacity` bytes into `buffer`, in sequence; 0 at the end, and from then on. So a reader
    /// of a file that grows, or is readable again after an error, finds no more past the supposed end.
    std::size_t read(char* buffer, std::size_t capacity);
    /// Starts again.
    void rewind();
    /// Returns the line that starts at byte `line_begin`, without its end, at most `max_bytes` of it.
    std::string line_at(std::uint64_t line_begin, std::size_t max_bytes = kMaxLineBytes) const;
    /// Returns errno of the first read that failed, else 0; the part read before counts as the complete file
    /// then.
    int error() const { return error_; }
    /// Returns the same as a message with the name; no value without an error.
    std::optional<std::string> error_message() const;

  private:
    std::size_t read_at(std::uint64_t offset, char* buffer, std::size_t capacity) const;

    std::string name_;
    os::InputFile file_;  // null: text_ holds it all
    std::string text_;
    std::uint64_t size_ = 0;
    std::uint64_t position_ = 0;
    mutable int error_ = 0;
    std::function<bool()> ends_;
    bool ended_early_ = false;
    bool at_end_ = false;
};

/// Returns the message for any file: `path` in the form for errors, with the reason of errno.
std::string file_error(const std::string& path, int error_number);

}  // namespace gsim::lexer
