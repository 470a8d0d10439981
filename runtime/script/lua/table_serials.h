#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "runtime/script/lua/small_block_allocator.h"

namespace gsim::script {

/// Ordinal numbers of the tables of a Lua state. Lua orders tables as keys by their addresses, which differ
/// from run to run. The number is stored past the object, if a small block has the space.
class TableSerials {
  public:
    /// Gives a number to a table that was allocated with so many bytes.
    void assign(void* table, std::size_t size) {
        if (SmallBlockAllocator::spare_bytes(size) < sizeof count_) return;
        ++count_;
        table_bytes_ = size;
        std::memcpy(static_cast<std::byte*>(table) + size, &count_, sizeof count_);
    }
    /// Returns the number of a table of the state; 0 if it is not known.
    std::uint64_t of(const void* table) const {
        std::uint64_t serial = 0;
        if (table_bytes_ > 0)
            std::memcpy(&serial, static_cast<const std::byte*>(table) + table_bytes_, sizeof serial);
        return serial;
    }

  private:
    std::uint64_t count_ = 0;
    std::size_t table_bytes_ = 0;
};

}  // namespace gsim::script
