#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/os/file_handle.h"
#include "codegen/lua/text_hash.h"

namespace gsim::codegen {

/// Lua of one translation until it is known to be complete. It is in memory while it is short, then in an
/// anonymous temporary file, so that memory stays flat. Its first line ends in the hash of the text that
/// follows.
class LuaSpool {
  public:
    /// Makes the temporary file now, because later the process may have no access to a folder for it.
    void reserve_file();
    /// Writes the first line, to which finish() appends the hash.
    void write_head(std::string_view head);
    void write(std::string_view text);
    /// Completes the file. The error is a message with the reason, such as a full disk.
    Result<void> finish();

    std::uint64_t size() const { return size_; }
    /// Returns the bytes of memory.
    std::size_t retained_bytes() const { return buffer_.capacity(); }
    /// Returns bytes [begin, end) of the finished text, all of them. The error is a message with the reason.
    Result<std::string> read(std::uint64_t begin, std::uint64_t end) const;
    /// Passes the finished text to `sink`, in parts. The error is that of read().
    Result<void> copy_to(const std::function<void(std::string_view)>& sink) const;

  private:
    void flush();
    int write_buffer();
    int write_hash(std::string_view digits);

    os::FileHandle reserved_file_;  ///< Becomes file_; null: it is made then.
    os::FileHandle file_;           ///< Null while all is in buffer_.
    std::string buffer_;
    std::size_t hashed_ = 0;  ///< Bytes of buffer_ that are in the hash, the head among them.
    TextHash hash_;
    std::uint64_t header_size_ = 0;  ///< Start of the hash.
    std::uint64_t size_ = 0;
    int error_ = 0;  ///< errno of the first failure to write.
};

/// Origin of a script according to its first line.
struct ScriptOrigin {
    std::string source_name;  ///< Name of the G-code file; empty if gcode2lua did not write the script.
    bool unedited = false;    ///< The remaining text is unchanged: Lua line n+1 is G-code line n.
};

/// Reads the first line of `lua` and compares the hash in it with the text.
ScriptOrigin script_origin(std::string_view lua);

}  // namespace gsim::codegen
