// The initial state of a context is kept as steps, which must give what the constructors give.
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

template <class Texture> void clear_view(Texture& texture) {
    if constexpr (requires { texture.view_faces; }) {
        std::memset(static_cast<void*>(&texture.view_faces), 0, sizeof texture.view_faces);
        clear_view(texture.object);
    } else {
        std::memset(static_cast<void*>(&texture.view), 0, sizeof texture.view);
    }
}

/// Clears what is derived of textures when they are first used.
template <class State> void clear_views(State& s) {
    clear_view(s.default_2d);
    if constexpr (requires { s.default_1d; })
        clear_view(s.default_1d);
    if constexpr (requires { s.default_3d; })
        clear_view(s.default_3d);
    if constexpr (requires { s.default_cube; })
        clear_view(s.default_cube);
}

TEST(Initial, StepsMakeWhatConstructorsMake) {
    static Memory made, expected;
    Context* const context = begin_context(&made);
    // The memory was zeroed first, so that bytes between members are zero, too.
    auto* const reference = new (&expected) Context();
    for (Context* c : {context, reference}) {
        // Drawing compiles the fragment state before it reads it, so its bytes do not matter.
        std::memset(static_cast<void*>(&c->fragments), 0, sizeof c->fragments);
        clear_views(c->texture);
        clear_above_top(c->transform.modelview);
        clear_above_top(c->transform.projection);
        for (auto& stack : c->transform.texture)
            clear_above_top(stack);
    }
    for (std::size_t i = 0; i < sizeof(Context); ++i)
        ASSERT_EQ(made.byte[i], expected.byte[i]) << "byte " << i;
}

/// The first draw compiles the fragment state, whatever memory held before.
TEST(Initial, FragmentsAreToBeCompiled) {
    static Memory made;
    const Context* const context = begin_context(&made);
    EXPECT_NE(context->dirty & dirty_fragment, 0);
    EXPECT_EQ(context->fragments.counters, nullptr);
}

} // namespace
