#include "gl/context/name_table.hpp"

#include <map>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "gl/context/arena.hpp"

namespace {

using spangle::gl::Arena;
using spangle::gl::NameTable;

struct Names : ::testing::Test {
    Names() : storage(new unsigned char[1 << 20]) { arena.give(storage.get(), 1 << 20); }
    std::unique_ptr<unsigned char[]> storage;
    Arena arena;
    NameTable names;
};

TEST_F(Names, AgreesWithAMap) {
    std::map<std::uint32_t, void*> model;
    std::mt19937 random(2);
    for (int i = 0; i < 200'000; ++i) {
        const std::uint32_t name =
            1 + random() % (i % 20'000 < 10'000 ? 40 : 2000) * (random() % 8 == 0 ? 0x10001u : 1u);
        void* const object = storage.get() + random() % 1000;
        if (void** const found = names.find(name); found != nullptr) {
            ASSERT_TRUE(model.contains(name));
            ASSERT_EQ(*found, model[name]);
            if (random() % 3 != 0) {
                ASSERT_EQ(names.remove(name), model[name]);
                model.erase(name);
            }
        } else {
            ASSERT_FALSE(model.contains(name));
            ASSERT_TRUE(names.insert(arena, name, object));
            model[name] = object;
        }
        ASSERT_EQ(names.count(), model.size());
    }
    std::uint32_t walked = 0;
    for (std::uint32_t i = 0; i < names.capacity(); ++i)
        if (names.slot(i).name != 0) {
            ++walked;
            EXPECT_EQ(model.at(names.slot(i).name), names.slot(i).object);
        }
    EXPECT_EQ(walked, model.size());
}

TEST_F(Names, ZeroIsNoName) {
    EXPECT_EQ(names.find(0), nullptr);
    names.insert(arena, 5, nullptr);
    EXPECT_EQ(names.find(0), nullptr);
    EXPECT_EQ(names.remove(0), nullptr);
    EXPECT_EQ(names.count(), 1u);
}

TEST_F(Names, UnusedRangesAreUnused) {
    EXPECT_EQ(names.unused(1), 1u);
    names.insert(arena, 10, nullptr);
    EXPECT_EQ(names.unused(5), 11u);
    names.insert(arena, 0xFFFFFFFF, nullptr); // after this only gaps between names are free
    EXPECT_EQ(names.unused(9), 1u);
    EXPECT_EQ(names.unused(10), 11u);
    EXPECT_EQ(names.unused(0xFFFFFFF4), 11u);
    EXPECT_EQ(names.unused(0xFFFFFFF5), 0u);
    names.insert(arena, 0x80000000, nullptr);
    EXPECT_EQ(names.unused(0x7FFFFFFF), 0u);
    EXPECT_EQ(names.unused(0x7FFFFFF5), 11u);
    EXPECT_EQ(names.unused(0x7FFFFFFE), 0x80000001u);
}

TEST_F(Names, NoMemoryChangesNothing) {
    Arena small;
    unsigned char memory[512];
    small.give(memory, sizeof memory);
    NameTable table;
    std::uint32_t name = 1;
    while (table.insert(small, name, nullptr))
        ASSERT_LT(++name, 100u);
    EXPECT_EQ(table.count(), name - 1);
    for (std::uint32_t n = 1; n < name; ++n)
        EXPECT_NE(table.find(n), nullptr);
    EXPECT_EQ(table.find(name), nullptr);
    EXPECT_FALSE(table.reserve(small, 0xFFFFFFFF));
    EXPECT_TRUE(small.consistent());
}

} // namespace
