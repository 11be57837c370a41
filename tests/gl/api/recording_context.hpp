// A current context whose vertex pipeline records what reaches it.
#pragma once

#include <cstring>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "gl/api/generated/commands.hpp"
#include "gl/context/arena.hpp"
#include "gl/context/create.hpp"
#include "gl/vertex/array_element.hpp"
#include "gl/vertex/engine.hpp"

namespace spangle::test {

struct Event {
    enum What { begin, vertex, end } what;
    GLenum mode = 0;
    std::uint32_t position[4] = {}, color[4] = {}, normal[3] = {}, tex_coord[4] = {}; ///< bits of floats
    friend bool operator==(const Event&, const Event&) = default;
};

inline std::vector<Event>& events() {
    static std::vector<Event> all;
    return all;
}

inline const gl::Engine recording_engine = {
    8,
    [](void*) {},
    [](const raster::FragmentState&, const raster::Surface&, raster::DrawState&) {},
    [](gl::Context&, GLenum mode) { events().push_back({.what = Event::begin, .mode = mode}); },
    [](gl::Context& c, gl::Real x, gl::Real y, gl::Real z, gl::Real w) {
        Event e{.what = Event::vertex};
        const gl::Real position[4] = {x, y, z, w};
        for (int i = 0; i < 4; ++i) {
            e.position[i] = position[i].bits;
            e.color[i] = c.current.color[i].bits;
            e.tex_coord[i] = c.current.tex_coord[0].v[i].bits;
        }
        for (int i = 0; i < 3; ++i)
            e.normal[i] = c.current.normal[i].bits;
        events().push_back(e);
    },
    [](gl::Context& c, std::uint32_t count, const gl::Indices& indices) {
        for (std::uint32_t i = 0; i < count; ++i)
            gl::cmd::ArrayElement(c, static_cast<GLint>(indices.at(i)));
    },
    [](gl::Context&) { events().push_back({.what = Event::end}); },
    [](gl::Context&) {},
#if SPANGLE_FEATURE_DRAW_PIXELS || SPANGLE_FEATURE_BITMAPS
    [](gl::Context&, const raster::DrawState&, const raster::Surface&, raster::PixelSource&) {},
#endif
#if SPANGLE_FEATURE_RASTER_POS
    [](gl::Context&, const gl::Real (&)[4]) {},
#endif
};

/// The surface has 64 x 48 pixels of RGBA8888 with Z24S8.
class RecordingContext : public ::testing::Test {
  protected:
    static constexpr std::int32_t width = 64, height = 48;
    static constexpr std::size_t arena_bytes = 4 << 20;

    explicit RecordingContext(bool double_buffered = true, std::size_t bytes = arena_bytes,
                              const gl::Engine& engine = recording_engine)
        : memory(new std::uint64_t[bytes / 8]) {
        arena.give(memory.get(), bytes);
        context = gl::create_context(arena, {.tier = raster::Tier::exact, .engine = &engine}, nullptr);
        gl::make_current(context, surface(), double_buffered);
        events().clear();
    }
    ~RecordingContext() override {
        gl::destroy_context(context);
        EXPECT_EQ(arena.used(), 0u) << "a context leaves nothing behind";
        EXPECT_TRUE(arena.consistent());
    }

    raster::Surface surface() {
        raster::Surface s;
        s.color = color;
        s.depth = depth;
        s.accum = accum;
        s.color_stride = width * 4;
        s.depth_stride = width * 4;
        s.width = width;
        s.height = height;
        s.format = PixelFormat::rgba8888;
        s.depth_format = DepthFormat::z24s8;
        return s;
    }

    /// Returns all state without the error code, derived state and the recorder.
    std::vector<unsigned char> snapshot() const {
        gl::Context copy;
        std::memcpy(static_cast<void*>(&copy), context, sizeof copy);
        copy.error_code = 0;
#if SPANGLE_MESSAGES
        copy.pending_error = {};
        copy.compiled = {};
#endif
        copy.dirty = 0;
#if SPANGLE_FEATURE_LISTS
        std::memset(static_cast<void*>(&copy.list.recorder), 0, sizeof copy.list.recorder);
        std::memset(copy.list.return_to, 0, sizeof copy.list.return_to);
#endif
        const auto* bytes = reinterpret_cast<const unsigned char*>(&copy);
        return {bytes, bytes + sizeof copy};
    }

    std::unique_ptr<std::uint64_t[]> memory;
    gl::Arena arena;
    gl::Context* context = nullptr;
    alignas(4) std::uint8_t color[width * height * 4] = {}, depth[width * height * 4] = {};
    std::int16_t accum[width * height * 4] = {};
};

} // namespace spangle::test
