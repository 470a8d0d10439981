#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "runtime/script/lua/small_block_allocator.h"

namespace gsim::script {

/// Memory of a script: that of its Lua state, and memory outside of Lua that is kept for it. It has a limit.
class ScriptMemory {
  public:
    explicit ScriptMemory(std::size_t limit_bytes) : limit_bytes_(limit_bytes) {}

    /// Returns false if the block must not grow from one size to the other. The request, for `what`, is then
    /// the error.
    bool permits(std::size_t old_size, std::size_t new_size, const char* what) {
        if (new_size <= old_size || bytes_ + (new_size - old_size) <= limit_bytes_) return true;
        reject(what, new_size - old_size, false);
        return false;
    }
    /// Resizes a block like realloc(), with sizes above 0; a null block has the size 0. Null: the system has
    /// no memory, and the request, for `what`, is the error.
    void* resize(void* block, std::size_t old_size, std::size_t new_size, const char* what) {
        void* const resized = resize_block(block, old_size, new_size);
        if (resized == nullptr) {
            reject(what, new_size - old_size, true);
            return nullptr;
        }
        is_rejected_ = false;
        bytes_ += new_size - old_size;
        return resized;
    }
    void release(void* block, std::size_t size) {
        release_block(block, size);
        bytes_ -= size;
    }

    /// Returns true if there is space for so many bytes outside of Lua.
    bool has_space_for(std::size_t bytes) const {
        return bytes <= limit_bytes_ && bytes_ <= limit_bytes_ - bytes;
    }
    /// Counts memory outside of Lua. `what` is stored and names the consumer: "the text of the script".
    void add_external(std::size_t bytes, const char* what);
    /// Releases memory that is no longer kept; `what` as in add_external().
    void release_external(std::size_t bytes, const char* what);
    /// Makes a request for memory outside of Lua the error.
    void reject_external(std::size_t bytes, const char* what) { reject(what, bytes, false); }

    /// Returns true if the last request for more memory was rejected.
    bool is_rejected() const { return is_rejected_; }
    /// Returns the message about what needs more memory than available: the largest holder, or the consumer
    /// that requested it.
    std::string error() const;

  private:
    /// Request for memory that was not fulfilled.
    struct Error {
        const char* what = "the script";
        std::size_t requested_bytes = 0;
        std::size_t retained_bytes = 0;
        bool is_system_failure = false;
    };
    /// Memory outside of Lua, by its purpose.
    struct External {
        const char* what;
        std::size_t bytes;
    };

    void* resize_block(void* block, std::size_t old_size, std::size_t new_size) {
        if (old_size > SmallBlockAllocator::kMaxBlockSize && new_size > SmallBlockAllocator::kMaxBlockSize)
            return std::realloc(block, new_size);
        if (SmallBlockAllocator::is_same_size_class(old_size, new_size)) return block;
        const bool is_small_block = new_size <= SmallBlockAllocator::kMaxBlockSize;
        void* const resized = is_small_block ? small_blocks_.allocate_block(new_size) : std::malloc(new_size);
        if (resized == nullptr || block == nullptr) return resized;
        std::memcpy(resized, block, std::min(old_size, new_size));
        release_block(block, old_size);
        return resized;
    }
    void release_block(void* block, std::size_t size) {
        if (block == nullptr) return;
        if (size <= SmallBlockAllocator::kMaxBlockSize) {
            small_blocks_.deallocate_block(block, size);
        } else {
            std::free(block);
        }
    }
    void reject(const char* what, std::size_t requested_bytes, bool is_system_failure);
    std::size_t& external_bytes(const char* what);
    const char* largest_memory_user() const;

    std::size_t limit_bytes_;
    std::size_t bytes_ = 0;
    SmallBlockAllocator small_blocks_;
    std::vector<External> external_;  ///< A part of bytes_.
    bool is_rejected_ = false;
    Error error_;
};

}  // namespace gsim::script
