#include "host_sim/cli/picture_load.hpp"

#include <algorithm>
#include <bit>
#include <climits>
#include <cstdint>
#include <cstring>
#include <filesystem>

#include <SDL2/SDL_image.h>

#include <spangle/sim/image.hpp>

namespace spangle::cli {

namespace {

/// Box-filters an RGBA surface to powers of two no larger than `largest`.
ModelImage shrink(const SDL_Surface& s, int largest) {
    ModelImage out;
    const auto fit = [largest](int n) {
        return static_cast<int>(std::bit_floor(static_cast<unsigned>(std::min(n, largest))));
    };
    out.width = fit(s.w);
    out.height = fit(s.h);
    out.rgba.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) * 4);
    const auto* pixels = static_cast<const std::uint8_t*>(s.pixels);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int x0 = x * s.w / out.width, x1 = std::max(x0 + 1, (x + 1) * s.w / out.width);
            const int y0 = y * s.h / out.height, y1 = std::max(y0 + 1, (y + 1) * s.h / out.height);
            std::uint64_t sum[4] = {};
            for (int v = y0; v < y1; ++v)
                for (int u = x0; u < x1; ++u)
                    for (int c = 0; c < 4; ++c)
                        sum[c] += pixels[v * s.pitch + 4 * u + c];
            const auto n = static_cast<std::uint64_t>((x1 - x0) * (y1 - y0));
            // In GL, t runs upwards; in image files, rows run downwards.
            std::uint8_t* to =
                &out.rgba[static_cast<std::size_t>(((out.height - 1 - y) * out.width + x) * 4)];
            for (int c = 0; c < 4; ++c)
                to[c] = static_cast<std::uint8_t>((sum[c] + n / 2) / n);
            out.translucent = out.translucent || to[3] != 255;
        }
    return out;
}

/// Why a picture of this size is not read; empty if it is.
std::string beyond(std::uint64_t width, std::uint64_t height) {
    if (width <= sim::longest_side && height <= sim::longest_side && width * height <= sim::most_pixels)
        return "";
    return "it is " + std::to_string(width) + "x" + std::to_string(height) + "; at most " +
           std::to_string(sim::longest_side) + " pixels a side and " +
           std::to_string(sim::most_pixels >> 20) + " Mi together are read";
}

/// Why a PNG file is too large, by the size in its head (PNG, 11.2.2: IHDR comes first), before anything is
/// decoded; empty if it is not, or is no PNG.
std::string too_large_png(SDL_RWops* file) {
    std::uint8_t head[24] = {};
    const bool png = SDL_RWread(file, head, 1, sizeof head) == sizeof head &&
                     std::memcmp(head, "\x89PNG\r\n\x1a\n", 8) == 0;
    SDL_RWseek(file, 0, RW_SEEK_SET);
    const auto word = [&head](int at) {
        return std::uint64_t{head[at]} << 24 | std::uint64_t{head[at + 1]} << 16 |
               std::uint64_t{head[at + 2]} << 8 | head[at + 3];
    };
    return png ? beyond(word(16), word(20)) : "";
}

/// Converts a surface that SDL_image decoded to RGBA bytes, shrinks the picture, and frees the surface.
/// Returns why that fails, or an empty string.
std::string take(SDL_Surface* raw, int largest, ModelImage& out) {
    if (raw == nullptr)
        return IMG_GetError();
    std::string problem = raw->w <= 0 || raw->h <= 0
                              ? "it has no pixels"
                              : beyond(static_cast<unsigned>(raw->w), static_cast<unsigned>(raw->h));
    SDL_Surface* const rgba =
        problem.empty() ? SDL_ConvertSurfaceFormat(raw, SDL_PIXELFORMAT_RGBA32, 0) : nullptr;
    SDL_FreeSurface(raw);
    if (rgba != nullptr)
        out = shrink(*rgba, largest);
    else if (problem.empty())
        problem = SDL_GetError();
    SDL_FreeSurface(rgba);
    return problem;
}

std::string take(SDL_RWops* file, const std::string& ending, int largest, ModelImage& out) {
    if (file == nullptr)
        return SDL_GetError();
    if (std::string problem = too_large_png(file); !problem.empty()) {
        SDL_RWclose(file);
        return problem;
    }
    return take(IMG_LoadTyped_RW(file, 1, ending.c_str()), largest, out);
}

} // namespace

std::string read_picture(const std::string& path, int largest, ModelImage& out) {
    const std::string dot = std::filesystem::path(path).extension().string();
    return take(SDL_RWFromFile(path.c_str(), "rb"), dot.empty() ? dot : dot.substr(1), largest, out);
}

std::string read_picture(const void* bytes, std::size_t size, int largest, ModelImage& out) {
    return size > INT_MAX ? "it is too large"
                          : take(SDL_RWFromConstMem(bytes, static_cast<int>(size)), "", largest, out);
}

std::string read_texels(void* bgra, std::size_t width, std::size_t height, int largest, ModelImage& out) {
    if (std::string problem = beyond(width, height); !problem.empty())
        return problem;
    return take(SDL_CreateRGBSurfaceWithFormatFrom(bgra, static_cast<int>(width), static_cast<int>(height),
                                                   32, static_cast<int>(width * 4), SDL_PIXELFORMAT_BGRA32),
                largest, out);
}

} // namespace spangle::cli
