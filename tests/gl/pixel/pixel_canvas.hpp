// A context of the product's engine on a surface whose memory the test can read.
#pragma once

#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <spangle/GL/gl.h>

#include "gl/context/arena.hpp"
#include "gl/context/create.hpp"
#include "gl/vertex/engine.hpp"
#include "raster/surface/pixel.hpp"

namespace spangle::gl::test {

struct CanvasWish {
    PixelFormat format = PixelFormat::rgba8888;
    DepthFormat depth = DepthFormat::z24s8;
    raster::Tier tier = raster::Tier::exact;
    std::int32_t width = 40, height = 28;
    bool top_first = false;
    const Engine* engine = &fixed_engine;
    std::size_t memory = 1 << 20; ///< bytes beside those of the pipeline
};

/// A context that is current while the object lives. Coordinates are pixels: x and y from the lower left
/// corner.
class PixelCanvas {
  public:
    explicit PixelCanvas(const CanvasWish& wish = {})
        : memory_((wish.memory + wish.engine->pipeline_bytes) / 8) {
        arena.give(memory_.data(), 8 * memory_.size());
        context = create_context(arena, {.tier = wish.tier, .engine = wish.engine}, nullptr);
        const std::int32_t pixel = format_info(wish.format).bytes_per_pixel;
        color.resize(static_cast<std::size_t>(wish.width * wish.height * pixel));
        depth.resize(static_cast<std::size_t>(wish.width * wish.height));
        raster::Surface s;
        s.format = wish.format;
        s.width = wish.width;
        s.height = wish.height;
        s.color = color.data() + (wish.top_first ? (wish.height - 1) * wish.width * pixel : 0);
        s.color_stride = (wish.top_first ? -1 : 1) * wish.width * pixel;
        s.depth_format = wish.depth;
        if (wish.depth != DepthFormat::none) {
            s.depth = reinterpret_cast<std::uint8_t*>(depth.data());
            s.depth_stride = wish.width * (wish.depth == DepthFormat::z16 ? 2 : 4);
        }
        make_current(context, s, false);
        glMatrixMode(GL_PROJECTION);
        glOrtho(0, wish.width, 0, wish.height, -1, 1);
        glMatrixMode(GL_MODELVIEW);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
    }
    ~PixelCanvas() {
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        destroy_context(context);
        EXPECT_EQ(arena.used(), 0u);
        EXPECT_TRUE(arena.consistent());
    }
    PixelCanvas(const PixelCanvas&) = delete;
    PixelCanvas& operator=(const PixelCanvas&) = delete;

    const raster::Surface& surface() const { return context->drawable.surface; }
    /// Returns a stored component in 255ths; components of 5 and 6 bits are rounded to nearest.
    std::uint8_t at(std::int32_t x, std::int32_t y, int c) const {
        return raster::read_color(surface(), x, y).c[c].to_8();
    }
    std::uint32_t depth_at(std::int32_t x, std::int32_t y) const {
        return raster::read_depth(surface(), x, y).k;
    }
    std::uint8_t stencil_at(std::int32_t x, std::int32_t y) const {
        return raster::read_stencil(surface(), x, y);
    }

  private:
    std::vector<std::uint64_t> memory_;

  public:
    Arena arena;
    Context* context;
    std::vector<std::uint8_t> color;
    std::vector<std::uint32_t> depth;
};

} // namespace spangle::gl::test
