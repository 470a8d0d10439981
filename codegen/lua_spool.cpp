#include "codegen/lua_spool.h"

#include <algorithm>
#include <string>

#include <unistd.h>

#include "os/memory_file.h"

namespace gsim::codegen {

namespace {

constexpr std::size_t kBufferBytes = 1U << 16U;
constexpr std::string_view kFromMark = "-- from ";
constexpr std::string_view kNameEnd = "; line n there is line n+1 here";
constexpr std::string_view kHashMark = "; hash ";
constexpr std::size_t kHashDigits = 16;

}  // namespace

void LuaSpool::write_head(std::string_view head) {
    buffer_.reserve(kBufferBytes + 4096);
    buffer_.append(head);
    buffer_.append(kHashMark);
    head_size_ = buffer_.size();
    buffer_.append(kHashDigits, '0');
    buffer_ += '\n';
    size_ = hashed_ = buffer_.size();
}

void LuaSpool::write(std::string_view text) {
    buffer_.append(text);
    size_ += text.size();
    if (buffer_.size() >= kBufferBytes) flush();
}

/// Moves the buffer to the file; what the file cannot take shows in finish().
void LuaSpool::reserve_file() {
    reserve_.reset(std::tmpfile());
}

void LuaSpool::flush() {
    hash_.update(std::string_view(buffer_).substr(hashed_));
    hashed_ = 0;
    if (!file_ && !failed_) file_ = reserve_ ? std::move(reserve_) : os::FileHandle(std::tmpfile());
    // A run that calls another program may reach no folder for temporary files.
    if (!file_ && !failed_) file_ = os::file_in_memory("spool");
    failed_ |= !file_ || std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) != buffer_.size();
    buffer_.clear();
}

bool LuaSpool::finish() {
    if (file_ || failed_) flush();
    hash_.update(std::string_view(buffer_).substr(hashed_));
    const std::string digits = to_hex(hash_.value());
    if (!file_) {
        if (!failed_) buffer_.replace(head_size_, kHashDigits, digits);
        return !failed_;
    }
    failed_ |= std::fflush(file_.get()) != 0;
    failed_ |= ::pwrite(::fileno(file_.get()), digits.data(), digits.size(),
                        static_cast<off_t>(head_size_)) != static_cast<ssize_t>(digits.size());
    return !failed_;
}

std::string LuaSpool::read(std::uint64_t begin, std::uint64_t end) const {
    if (!file_) return buffer_.substr(begin, end - begin);
    std::string text(end - begin, '\0');
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t count = ::pread(::fileno(file_.get()), text.data() + done, text.size() - done,
                                      static_cast<off_t>(begin + done));
        if (count <= 0) break;
        done += static_cast<std::size_t>(count);
    }
    text.resize(done);
    return text;
}

bool LuaSpool::copy_to(const std::function<void(std::string_view)>& sink) const {
    for (std::uint64_t done = 0; done < size_;) {
        const std::string part = read(done, std::min(size_, done + kBufferBytes));
        if (part.empty()) return false;
        sink(part);
        done += part.size();
    }
    return true;
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
