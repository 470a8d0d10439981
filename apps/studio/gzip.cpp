#include "apps/studio/gzip.h"

#include <algorithm>
#include <array>
#include <limits>
#include <new>

#include <zlib.h>

namespace gsim::apps {

struct Gzip::State {
    z_stream stream{};
    std::array<char, 1U << 16U> buffer;
};

Gzip::Gzip() : state_(std::make_unique<State>()) {
    constexpr int kGzipFormat = 16;
    constexpr int kMemoryLevel = 8;
    if (deflateInit2(&state_->stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, MAX_WBITS + kGzipFormat,
                     kMemoryLevel, Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::bad_alloc();
}

Gzip::~Gzip() {
    deflateEnd(&state_->stream);
}

void Gzip::add(std::string_view bytes, std::string& compressed) {
    constexpr std::size_t kMaxChunk = std::numeric_limits<uInt>::max();
    while (!bytes.empty()) {
        const std::string_view part = bytes.substr(0, std::min(bytes.size(), kMaxChunk));
        // zlib does not change what it reads, so the cast is safe.
        state_->stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(part.data()));
        state_->stream.avail_in = static_cast<uInt>(part.size());
        run(Z_NO_FLUSH, compressed);
        bytes.remove_prefix(part.size());
    }
}

void Gzip::end(std::string& compressed) {
    state_->stream.avail_in = 0;
    run(Z_FINISH, compressed);
}

// The loop runs until zlib has no more output: then it has consumed all input.
void Gzip::run(int flush, std::string& compressed) {
    z_stream& stream = state_->stream;
    do {
        stream.next_out = reinterpret_cast<Bytef*>(state_->buffer.data());
        stream.avail_out = static_cast<uInt>(state_->buffer.size());
        deflate(&stream, flush);
        compressed.append(state_->buffer.data(), state_->buffer.size() - stream.avail_out);
    } while (stream.avail_out == 0);
}

}  // namespace gsim::apps
