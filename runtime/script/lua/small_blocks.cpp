#include "runtime/script/lua/small_blocks.h"

#include <cstdlib>
#include <new>
#include <utility>

namespace gsim::script {

void SmallBlocks::Release::operator()(void* chunk) const {
    std::free(chunk);
}

void* SmallBlocks::take(std::size_t size) {
    const std::size_t index = size_class(size);
    if (free_[index] == nullptr && !add_chunk(index)) return nullptr;
    Free* block = free_[index];
    free_[index] = block->next;
    return block;
}

void SmallBlocks::give(void* block, std::size_t size) {
    Free*& first = free_[size_class(size)];
    first = new (block) Free{first};
}

bool SmallBlocks::add_chunk(std::size_t index) {
    std::unique_ptr<void, Release> chunk(std::malloc(kChunkBytes));
    if (chunk == nullptr) return false;
    auto* const bytes = static_cast<std::byte*>(chunk.get());
    try {
        chunks_.push_back(std::move(chunk));
    } catch (const std::bad_alloc&) {
        return false;
    }
    const std::size_t block_bytes = (index + 1) * kGrain;
    Free* first = nullptr;
    for (std::size_t at = kChunkBytes / block_bytes; at > 0; --at)
        first = new (bytes + (at - 1) * block_bytes) Free{first};
    free_[index] = first;
    return true;
}

}  // namespace gsim::script
