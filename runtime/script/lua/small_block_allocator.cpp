#include "runtime/script/lua/small_block_allocator.h"

#include <cstdlib>
#include <new>
#include <utility>

namespace gsim::script {

void SmallBlockAllocator::ChunkDeleter::operator()(void* chunk) const {
    std::free(chunk);
}

void* SmallBlockAllocator::allocate_block(std::size_t size) {
    const std::size_t index = size_class(size);
    if (free_blocks_[index] == nullptr && !add_chunk(index)) return nullptr;
    FreeBlock* block = free_blocks_[index];
    free_blocks_[index] = block->next;
    return block;
}

void SmallBlockAllocator::deallocate_block(void* block, std::size_t size) {
    FreeBlock*& first = free_blocks_[size_class(size)];
    first = new (block) FreeBlock{first};
}

bool SmallBlockAllocator::add_chunk(std::size_t index) {
    std::unique_ptr<void, ChunkDeleter> chunk(std::malloc(kChunkBytes));
    if (chunk == nullptr) return false;
    auto* const bytes = static_cast<std::byte*>(chunk.get());
    try {
        chunks_.push_back(std::move(chunk));
    } catch (const std::bad_alloc&) {
        return false;
    }
    const std::size_t block_bytes = (index + 1) * kAlignment;
    FreeBlock* first = nullptr;
    for (std::size_t at = kChunkBytes / block_bytes; at > 0; --at)
        first = new (bytes + (at - 1) * block_bytes) FreeBlock{first};
    free_blocks_[index] = first;
    return true;
}

}  // namespace gsim::script
