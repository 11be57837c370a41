#include "tests/gl/api/command_stream.hpp"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include "gl/context/arena.hpp"
#include "gl/context/create.hpp"
#include "gl/vertex/engine.hpp"
#include "tests/gl/api/command_bands.hpp"
#include "tests/gl/api/command_calls.hpp"

namespace spangle::test {
namespace {

constexpr std::int32_t width = 64, height = 48;

class Run {
  public:
    Run(const std::uint8_t* data, std::size_t bytes) : in(data, bytes) {
        arena.give(memory.get(), memory_bytes);
        context = gl::create_context(
            arena, {.tier = raster::Tier(in.byte() % 3), .engine = &gl::fixed_engine}, nullptr);
        const bool deep = in.byte() % 2 != 0;
        raster::Surface s;
        s.format = static_cast<PixelFormat>(in.byte() % 4);
        how_ = in.byte();
        if ((how_ & 2) != 0 && is_drawable(PixelFormat::index8))
            s.format = PixelFormat::index8;
        const std::int32_t pixel = format_info(s.format).bytes_per_pixel;
        color.resize(static_cast<std::size_t>(width * height * pixel));
        depth.reset(new std::uint32_t[deep ? width * height : width * height / 2]());
        s.width = width;
        s.height = height;
        s.color = color.data() + (height - 1) * width * pixel; // memory holds the top row first
        s.color_stride = -width * pixel;
        s.depth = reinterpret_cast<std::uint8_t*>(depth.get());
        s.depth_stride = width * (deep ? 4 : 2);
        s.depth_format = deep ? DepthFormat::z24s8 : DepthFormat::z16;
        s.accum = accum.get();
        surface_ = s;
        if ((how_ & 4) != 0) {
            // An arena rounds sizes up by at most an eighth.
            other_memory.resize((gl::fixed_engine.pipeline_bytes * 9 / 8 + 64) / 8);
            arena.give(other_memory.data(), 8 * other_memory.size());
            other = gl::create_context(arena, {.tier = raster::Tier::balanced, .engine = &gl::fixed_engine},
                                       context);
        }
        turn_to(context);
    }

    void all() {
        Calls calls(in);
        while (in.more()) {
            const unsigned selected = in.byte() | static_cast<unsigned>(in.byte()) << 8;
            if (selected >= 0xFF00 && other != nullptr && !context->inside_begin_end() &&
                context->list.index == 0)
                turn();
            else
                calls.one(selected);
        }
    }

    ~Run() {
        gl::destroy_context(context);
        gl::destroy_context(other);
        if (arena.used() != 0 || !arena.consistent()) {
            std::fprintf(stderr, "the arena is damaged or %zu bytes are left\n", arena.used());
            std::abort();
        }
    }

  private:
    /// Bits of how_ choose double buffering, an index framebuffer, a second context that shares, and fewer
    /// bits of an index.
    void turn_to(gl::Context* now) {
        gl::make_current(now, surface_, (how_ & 1) != 0);
        if (is_indexed(surface_.format))
            now->drawable.index_bits = static_cast<std::uint8_t>(1 + (how_ >> 3) % 8);
    }
    void turn() {
        std::swap(context, other);
        turn_to(context);
    }

    Bytes in;
    const std::size_t memory_bytes = 256 * 1024 + gl::fixed_engine.pipeline_bytes;
    std::unique_ptr<std::uint64_t[]> memory{new std::uint64_t[memory_bytes / 8]};
    std::vector<std::uint64_t> other_memory;
    gl::Arena arena;
    gl::Context *context = nullptr, *other = nullptr;
    unsigned how_ = 0;
    raster::Surface surface_;
    std::vector<std::uint8_t> color;
    std::unique_ptr<std::uint32_t[]> depth;
    std::unique_ptr<std::int16_t[]> accum{new std::int16_t[4 * width * height]()};
};

} // namespace

void run_command_stream(const std::uint8_t* data, std::size_t bytes) {
    if (bytes == 0 || data[0] < first_of_bands)
        Run(data, bytes).all();
    else
        run_in_bands(data, bytes);
}

} // namespace spangle::test
