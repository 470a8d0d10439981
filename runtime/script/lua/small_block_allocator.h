#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace gsim::script {

/// Memory for the many small and short-lived objects of a Lua state. Its collector frees hundreds of one size
/// at a time, more than the C library's allocator caches. Freed memory is kept for the next block of that
/// size, until the end.
class SmallBlockAllocator {
  public:
    static constexpr std::size_t kMaxBlockSize = 256;  ///< Bytes; larger blocks are for malloc.

    /// Returns a block of `size` bytes, 1 to kMaxBlockSize, aligned like malloc's; null if no memory is left.
    void* allocate_block(std::size_t size);
    /// Frees a block that allocate_block(size) returned.
    void deallocate_block(void* block, std::size_t size);
    /// Returns true if a block of one size can also hold the other.
    static bool is_same_size_class(std::size_t one, std::size_t other) {
        return one > 0 && one <= kMaxBlockSize && other <= kMaxBlockSize &&
               size_class(one) == size_class(other);
    }
    /// Returns the number of usable bytes that follow a block of `size`; 0 if it is not one of these blocks.
    static std::size_t spare_bytes(std::size_t size) {
        return size > 0 && size <= kMaxBlockSize ? (size_class(size) + 1) * kAlignment - size : 0;
    }

  private:
    static constexpr std::size_t kAlignment = alignof(std::max_align_t);
    static constexpr std::size_t kChunkBytes = std::size_t{32} << 10U;

    struct FreeBlock {
        FreeBlock* next;
    };
    struct ChunkDeleter {
        void operator()(void* chunk) const;
    };

    static std::size_t size_class(std::size_t size) { return (size - 1) / kAlignment; }
    bool add_chunk(std::size_t size_class);

    std::array<FreeBlock*, kMaxBlockSize / kAlignment> free_blocks_{};
    std::vector<std::unique_ptr<void, ChunkDeleter>> chunks_;
};

}  // namespace gsim::script
