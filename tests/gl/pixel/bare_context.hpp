// A context without EGL, engine or window, which is enough for commands that only use state, textures and
// pixels.
#pragma once

#include <vector>

#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"

namespace spangle::gl::test {

struct SharedMemory {
    explicit SharedMemory(std::size_t bytes) : memory(bytes / 8 + 1) { arena.give(memory.data(), bytes); }

    std::vector<std::uint64_t> memory;
    Arena arena;
    ShareGroup share{arena};
};

struct BareContext {
    explicit BareContext(SharedMemory& shared, PixelFormat format = PixelFormat::rgba8888,
                         DepthFormat depth = DepthFormat::z24s8, std::int32_t width = 8,
                         std::int32_t height = 6)
        : color(static_cast<std::size_t>(width * height * format_info(format).bytes_per_pixel)),
          planes(static_cast<std::size_t>(width * height) * 4) {
        context.arena = &shared.arena;
        context.share = &shared.share;
        raster::Surface& s = context.drawable.surface;
        s.width = width;
        s.height = height;
        s.format = format;
        s.color_stride = width * format_info(format).bytes_per_pixel;
        s.color = color.data();
        s.depth_format = depth;
        s.depth_stride = depth == DepthFormat::none ? 0 : width * (depth == DepthFormat::z16 ? 2 : 4);
        s.depth = depth == DepthFormat::none ? nullptr : planes.data();
        context.drawable.read = s;
    }

    GLenum take_error() {
        const GLenum code = context.error_code;
        context.error_code = GL_NO_ERROR;
        return code;
    }

    std::vector<std::uint8_t> color, planes;
    Context context;
};

} // namespace spangle::gl::test
