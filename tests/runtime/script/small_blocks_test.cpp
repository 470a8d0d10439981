// Blocks of a pool: each is complete, aligned, and exclusive to its user.

#include "runtime/script/lua/small_blocks.h"

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

bool holds_its_mark(const Held& held) {
    const auto* bytes = static_cast<const unsigned char*>(held.block);
    for (std::size_t i = 0; i < held.size; ++i) {
        if (bytes[i] != held.mark) return false;
    }
    return true;
}

TEST(SmallBlocks, AreEachForOne) {
    SmallBlocks blocks;
    std::vector<Held> held;
    std::mt19937 random(3);
    for (int i = 0; i < 50'000; ++i) {
        const bool give = !held.empty() && random() % 2 == 0;
        if (give) {
            std::swap(held[random() % held.size()], held.back());
            ASSERT_TRUE(holds_its_mark(held.back()));
            blocks.give(held.back().block, held.back().size);
            held.pop_back();
            continue;
        }
        const std::size_t size = 1 + random() % SmallBlocks::kLargest;
        Held next{blocks.take(size), size, static_cast<unsigned char>(i)};
        ASSERT_NE(next.block, nullptr);
        ASSERT_EQ(reinterpret_cast<std::uintptr_t>(next.block) % alignof(std::max_align_t), 0U);
        std::memset(next.block, next.mark, size);
        held.push_back(next);
    }
    for (const Held& one : held) EXPECT_TRUE(holds_its_mark(one));
}

TEST(SmallBlocks, GoToTheNextOfTheirSize) {
    SmallBlocks blocks;
    void* const first = blocks.take(40);
    blocks.give(first, 40);
    EXPECT_EQ(blocks.take(48), first);
    EXPECT_TRUE(SmallBlocks::same_class(33, 48));
    EXPECT_FALSE(SmallBlocks::same_class(48, 49));
    EXPECT_FALSE(SmallBlocks::same_class(0, 1));
    EXPECT_FALSE(SmallBlocks::same_class(SmallBlocks::kLargest, SmallBlocks::kLargest + 1));
}

}  // namespace
}  // namespace gsim::script::small_blocks_test
