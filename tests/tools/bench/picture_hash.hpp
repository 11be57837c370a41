// Computes a hash of the picture in the current context's drawing buffer.
#pragma once

#include <cstdint>

#include <spangle/GL/gl.h>

namespace spangle::bench {

inline constexpr std::uint32_t no_picture = 2166136261u;

/// FNV-1a over the picture as GL reads it back, row by row, continued from `hash`. The picture may be 2048
/// pixels wide.
inline std::uint32_t picture_hash(int width, int height, std::uint32_t hash = no_picture) {
    static GLubyte row[2048 * 4];
    for (int y = 0; y < height; ++y) {
        glReadPixels(0, y, width, 1, GL_RGBA, GL_UNSIGNED_BYTE, row);
        for (int i = 0; i < width * 4; ++i)
            hash = (hash ^ row[i]) * 16777619u;
    }
    return hash;
}

} // namespace spangle::bench
