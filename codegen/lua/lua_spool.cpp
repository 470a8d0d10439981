#include "codegen/lua/lua_spool.h"

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "base/os/memory_file.h"

namespace gsim::codegen {

namespace {

constexpr std::size_t kBufferBytes = 1U << 16U;
constexpr std::string_view kFromMark = "-- from ";
constexpr std::string_view kNameEnd = "; line n there is line n+1 here";
constexpr std::string_view kHashMark = "; hash ";
constexpr std::size_t kHashDigits = 16;

std::string spool_error(std::string_view done, int error) {
    return fmt::format("the temporary file for the Lua cannot be {}: {}", done,
                       std::generic_category().message(error));
}

}  // namespace

void LuaSpool::write_head(std::string_view head) {
    buffer_.reserve(kBufferBytes + 4096);
    buffer_.append(head);
    buffer_.append(kHashMark);
    header_size_ = buffer_.size();
    buffer_.append(kHashDigits, '0');
    buffer_ += '\n';
    size_ = hashed_ = buffer_.size();
}

void LuaSpool::write(std::string_view text) {
    buffer_.append(text);
    size_ += text.size();
    if (buffer_.size() >= kBufferBytes) flush();
}

void LuaSpool::reserve_file() {
    reserved_file_.reset(std::tmpfile());
}

/// Moves the buffer to the file; finish() reports write errors.
void LuaSpool::flush() {
    hash_.update(std::string_view(buffer_).substr(hashed_));
    hashed_ = 0;
    if (error_ == 0) error_ = write_buffer();
    buffer_.clear();
}

/// Returns an errno.
int LuaSpool::write_buffer() {
    if (!file_) file_ = std::move(reserved_file_);
    if (!file_) file_.reset(std::tmpfile());
    // A run that calls another program may have no access to a folder for temporary files.
    if (!file_) file_ = os::open_memory_file("spool");
    if (!file_) return errno;
    return std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) == buffer_.size() ? 0 : errno;
}

/// Overwrites the digits that reserve its position. Returns an errno.
int LuaSpool::write_hash(std::string_view digits) {
    if (std::fflush(file_.get()) != 0 ||
        std::fseek(file_.get(), static_cast<long>(header_size_), SEEK_SET) != 0 ||
        std::fwrite(digits.data(), 1, digits.size(), file_.get()) != digits.size())
        return errno;
    return std::fflush(file_.get()) == 0 ? 0 : errno;
}

Result<void> LuaSpool::finish() {
    if (file_ || error_ != 0) flush();
    hash_.update(std::string_view(buffer_).substr(hashed_));
    const std::string digits = to_hex(hash_.value());
    if (file_ && error_ == 0) error_ = write_hash(digits);
    if (error_ != 0) return tl::unexpected(spool_error("written", error_));
    if (!file_) buffer_.replace(header_size_, kHashDigits, digits);
    return {};
}

Result<std::string> LuaSpool::read(std::uint64_t begin, std::uint64_t end) const {
    if (!file_) return buffer_.substr(begin, end - begin);
    std::string text(end - begin, '\0');
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t count = ::pread(::fileno(file_.get()), text.data() + done, text.size() - done,
                                      static_cast<off_t>(begin + done));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return tl::unexpected(spool_error("read", count < 0 ? errno : EIO));
        done += static_cast<std::size_t>(count);
    }
    return text;
}

Result<void> LuaSpool::copy_to(const std::function<void(std::string_view)>& sink) const {
    for (std::uint64_t done = 0; done < size_; done += kBufferBytes) {
        const auto part = read(done, std::min(size_, done + kBufferBytes));
        if (!part) return tl::unexpected(part.error());
        sink(*part);
    }
    return {};
}

ScriptOrigin script_origin(std::string_view lua) {
    ScriptOrigin origin;
    const std::string_view head = lua.substr(0, lua.find('\n'));
    const std::size_t from = head.find(kFromMark);
    const std::size_t hash = head.rfind(kHashMark);
    if (from == std::string_view::npos || head.size() == lua.size()) return origin;
    const std::size_t name_end = head.rfind(kNameEnd);
    if (name_end == std::string_view::npos || name_end < from + kFromMark.size()) return origin;
    origin.source_name = head.substr(from + kFromMark.size(), name_end - from - kFromMark.size());
    if (hash == std::string_view::npos) return origin;
    TextHash text_hash;
    text_hash.update(lua.substr(head.size() + 1));
    origin.unedited = head.substr(hash + kHashMark.size()) == to_hex(text_hash.value());
    return origin;
}

}  // namespace gsim::codegen
