#include "gl/context/arena.hpp"

#include <cstring>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace {

using spangle::gl::Arena;

struct Memory {
    explicit Memory(std::size_t bytes) : storage(new unsigned char[bytes]) {
        arena.give(storage.get(), bytes);
    }
    std::unique_ptr<unsigned char[]> storage;
    Arena arena;
};

TEST(Arena, BlocksAreAlignedAndDistinct) {
    Memory m(1 << 16);
    std::vector<unsigned char*> blocks;
    for (std::size_t size : {0, 1, 7, 8, 9, 63, 64, 65, 1000, 4097}) {
        auto* block = static_cast<unsigned char*>(m.arena.allocate(size));
        ASSERT_NE(block, nullptr);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % Arena::alignment, 0u);
        for (unsigned char* other : blocks)
            EXPECT_NE(block, other);
        blocks.push_back(block);
    }
    EXPECT_TRUE(m.arena.consistent());
    for (unsigned char* block : blocks)
        m.arena.free(block);
    EXPECT_EQ(m.arena.used(), 0u);
    EXPECT_TRUE(m.arena.consistent());
}

TEST(Arena, NeighboursJoinInEveryOrder) {
    for (unsigned order = 0; order < 6; ++order) {
        Memory m(4096);
        void* const whole = m.arena.allocate(3500);
        ASSERT_NE(whole, nullptr);
        m.arena.free(whole);
        void* const b[3] = {m.arena.allocate(1000), m.arena.allocate(1000), m.arena.allocate(1000)};
        static constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                             {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
        for (int i : orders[order])
            m.arena.free(b[i]);
        EXPECT_TRUE(m.arena.consistent());
        EXPECT_EQ(m.arena.allocate(3500), whole) << "order " << order;
    }
}

TEST(Arena, ExhaustionGivesNullAndChangesNothing) {
    Memory m(8192);
    void* const block = m.arena.allocate(5000);
    ASSERT_NE(block, nullptr);
    const std::size_t used = m.arena.used();
    EXPECT_EQ(m.arena.allocate(5000), nullptr);
    EXPECT_EQ(m.arena.allocate(~std::size_t{0}), nullptr);
    EXPECT_EQ(m.arena.allocate(~std::size_t{0} / 2), nullptr);
    EXPECT_EQ(m.arena.used(), used);
    EXPECT_TRUE(m.arena.consistent());
    EXPECT_EQ(Arena().allocate(1), nullptr);
}

TEST(Arena, ShrinkGivesTheTailBack) {
    Memory m(8192);
    void* const block = m.arena.allocate(7000);
    std::memset(block, 0x5A, 7000);
    EXPECT_EQ(m.arena.allocate(4000), nullptr);
    m.arena.shrink(block, 100);
    EXPECT_TRUE(m.arena.consistent());
    EXPECT_NE(m.arena.allocate(4000), nullptr);
    for (int i = 0; i < 100; ++i)
        EXPECT_EQ(static_cast<unsigned char*>(block)[i], 0x5A);
    const std::size_t used = m.arena.used();
    m.arena.shrink(block, 5000); // shrink() does not make a block larger
    EXPECT_EQ(m.arena.used(), used);
}

TEST(Arena, OddRegionsAreTakenOrLeft) {
    alignas(8) unsigned char memory[512];
    for (std::size_t offset = 0; offset < 8; ++offset)
        for (std::size_t bytes : {0, 1, 8, 16, 31, 47, 48, 49, 200}) {
            Arena arena;
            std::memset(memory, 0xEE, sizeof memory);
            arena.give(memory + offset, bytes);
            for (auto* p = static_cast<unsigned char*>(arena.allocate(1)); p != nullptr;
                 p = static_cast<unsigned char*>(arena.allocate(1))) {
                ASSERT_GE(p, memory + offset);
                ASSERT_LT(p, memory + offset + bytes);
            }
            for (std::size_t i = 0; i < offset; ++i)
                ASSERT_EQ(memory[i], 0xEE);
            for (std::size_t i = offset + bytes; i < sizeof memory; ++i)
                ASSERT_EQ(memory[i], 0xEE) << offset << " " << bytes;
            EXPECT_TRUE(arena.consistent());
        }
    Arena arena;
    arena.give(nullptr, 100);
    EXPECT_EQ(arena.capacity(), 0u);
}

// Does 10^6 random operations on two regions, in which every block keeps a pattern of its own.
TEST(Arena, MillionOperations) {
    struct Live {
        unsigned char* block;
        std::size_t size;
        unsigned char mark;
    };
    Memory m(200'000);
    std::vector<unsigned char> second(50'003);
    m.arena.give(second.data() + 1, second.size() - 1);
    std::mt19937 random(1);
    std::vector<Live> live;
    std::size_t failures = 0;
    const auto intact = [](const Live& l) {
        for (std::size_t i = 0; i < l.size; i += 1 + l.size / 8)
            if (l.block[i] != l.mark)
                return false;
        return l.size == 0 || l.block[l.size - 1] == l.mark;
    };
    for (int i = 0; i < 1'000'000; ++i) {
        const unsigned what = random() % 100;
        if (what < 50 || live.empty()) {
            const std::size_t size = random() % (random() % 16 == 0  ? 20'000
                                                 : random() % 4 == 0 ? 1000
                                                                     : 100);
            auto* const block = static_cast<unsigned char*>(m.arena.allocate(size));
            if (block == nullptr) {
                ++failures;
                continue;
            }
            live.push_back({block, size, static_cast<unsigned char>(random())});
            std::memset(block, live.back().mark, size);
        } else {
            Live& l = live[random() % live.size()];
            ASSERT_TRUE(intact(l)) << i;
            if (what < 55) {
                l.size = l.size == 0 ? 0 : random() % l.size;
                m.arena.shrink(l.block, l.size);
                continue;
            }
            m.arena.free(l.block);
            l = live.back();
            live.pop_back();
        }
        if (i % 1000 == 0) {
            ASSERT_TRUE(m.arena.consistent()) << i;
        }
    }
    EXPECT_GT(failures, 0u) << "the fuzz never filled the arena";
    EXPECT_GE(m.arena.peak(), m.arena.used());
    for (const Live& l : live)
        m.arena.free(l.block);
    EXPECT_EQ(m.arena.used(), 0u);
    EXPECT_TRUE(m.arena.consistent());
}

TEST(GrowingArena, HandsOutWhatThereIsOnce) {
    spangle::gl::GrowingArena arena;
    EXPECT_EQ(arena.allocate(1), nullptr);
    alignas(8) unsigned char memory[64];
    arena.give(memory + 3, sizeof memory - 3); // 56 bytes are left from the first aligned address on
    EXPECT_EQ(arena.capacity(), 56u);
    EXPECT_EQ(arena.allocate(57), nullptr);
    EXPECT_EQ(arena.allocate(~std::size_t{0}), nullptr);
    EXPECT_EQ(arena.used(), 0u);
    void* const first = arena.allocate(9);
    EXPECT_EQ(first, memory + 8);
    void* const second = arena.allocate(0);
    EXPECT_EQ(second, memory + 24);
    EXPECT_EQ(arena.used(), 24u);
    arena.free(first);
    EXPECT_EQ(arena.allocate(32), memory + 32) << "what was freed is not given out again";
    EXPECT_EQ(arena.allocate(0), nullptr);
    EXPECT_EQ(arena.peak(), 56u);
    arena.give(memory, 5);
    EXPECT_EQ(arena.allocate(1), nullptr);
}

} // namespace
