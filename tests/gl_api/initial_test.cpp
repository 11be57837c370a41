// What a context begins as: kept as steps, and the same as its constructors make it.
#include "gl/context/initial.hpp"

#include <cstring>
#include <new>

#include <gtest/gtest.h>

namespace {

using namespace spangle::gl;

struct alignas(Context) Memory {
    unsigned char byte[sizeof(Context)];
};

template <class Stack> void clear_above_top(Stack& stack) {
    for (std::size_t i = 1; i < std::size(stack.entry); ++i)
        std::memset(static_cast<void*>(&stack.entry[i]), 0, sizeof stack.entry[i]);
}

TEST(Initial, StepsMakeWhatConstructorsMake) {
    static Memory made, expected;
    Context* const context = begin_context(&made);
    auto* const reference = new (&expected) Context(); // zeroed first, so that bytes between members are, too
    for (Context* c : {context, reference}) {
        std::memset(static_cast<void*>(&c->fragments), 0, sizeof c->fragments); // made by its constructor
        clear_above_top(c->transform.modelview);
        clear_above_top(c->transform.projection);
        for (auto& stack : c->transform.texture)
            clear_above_top(stack);
    }
    for (std::size_t i = 0; i < sizeof(Context); ++i)
        ASSERT_EQ(made.byte[i], expected.byte[i]) << "byte " << i;
}

/// The first draw compiles, whatever is there.
TEST(Initial, FragmentsAreToBeCompiled) {
    static Memory made;
    const Context* const context = begin_context(&made);
    EXPECT_NE(context->dirty & dirty_fragment, 0);
    EXPECT_EQ(context->fragments.counters, nullptr);
}

} // namespace
