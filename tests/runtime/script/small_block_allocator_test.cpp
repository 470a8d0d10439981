// Blocks of a pool: each is complete, aligned, and exclusive to its user.

#include "runtime/script/lua/small_block_allocator.h"

#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace gsim::script::small_blocks_test {
namespace {

struct Held {
    void* block;
    std::size_t size;
    unsigned char mark;
};

bool holds_its_mark(const Held& allocated) {
    const auto* bytes = static_cast<const unsigned char*>(allocated.block);
    for (std::size_t i = 0; i < allocated.size; ++i) {
        if (bytes[i] != allocated.mark) return false;
    }
    return true;
}

TEST(SmallBlockAllocator, AllocatesDisjointAlignedBlocks) {
    SmallBlockAllocator blocks;
    std::vector<Held> allocated;
    std::mt19937 random(3);
    for (int i = 0; i < 50'000; ++i) {
        const bool deallocate_block = !allocated.empty() && random() % 2 == 0;
        if (deallocate_block) {
            std::swap(allocated[random() % allocated.size()], allocated.back());
            ASSERT_TRUE(holds_its_mark(allocated.back()));
            blocks.deallocate_block(allocated.back().block, allocated.back().size);
            allocated.pop_back();
            continue;
        }
        const std::size_t size = 1 + random() % SmallBlockAllocator::kMaxBlockSize;
        Held next{blocks.allocate_block(size), size, static_cast<unsigned char>(i)};
        ASSERT_NE(next.block, nullptr);
        ASSERT_EQ(reinterpret_cast<std::uintptr_t>(next.block) % alignof(std::max_align_t), 0U);
        std::memset(next.block, next.mark, size);
        allocated.push_back(next);
    }
    for (const Held& one : allocated) EXPECT_TRUE(holds_its_mark(one));
}

TEST(SmallBlockAllocator, ReusesBlockOfSameSizeClass) {
    SmallBlockAllocator blocks;
    void* const first = blocks.allocate_block(40);
    blocks.deallocate_block(first, 40);
    EXPECT_EQ(blocks.allocate_block(48), first);
    EXPECT_TRUE(SmallBlockAllocator::is_same_size_class(33, 48));
    EXPECT_FALSE(SmallBlockAllocator::is_same_size_class(48, 49));
    EXPECT_FALSE(SmallBlockAllocator::is_same_size_class(0, 1));
    EXPECT_FALSE(SmallBlockAllocator::is_same_size_class(SmallBlockAllocator::kMaxBlockSize,
                                                         SmallBlockAllocator::kMaxBlockSize + 1));
}

}  // namespace
}  // namespace gsim::script::small_blocks_test
