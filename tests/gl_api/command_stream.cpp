#include "tests/gl_api/command_stream.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "gl/context/arena.hpp"
#include "gl/context/create.hpp"
#include "gl/vertex/engine.hpp"
#include "tests/gl_api/command_table.hpp"

namespace spangle::test {
namespace {

constexpr std::int32_t width = 64, height = 48;
constexpr std::int64_t most_items = 64; ///< of an array or a side of an image
/// Holds the largest image: (64 + 8)^3 groups of 16 bytes, its rows aligned.
constexpr std::size_t client_bytes = std::size_t{72} * 72 * (72 * 16 + 8) + 64;

/// What parameters are set to that take one token of several.
constexpr GLenum settings[] = {GL_NEAREST,
                               GL_LINEAR,
                               GL_NEAREST_MIPMAP_NEAREST,
                               GL_LINEAR_MIPMAP_NEAREST,
                               GL_NEAREST_MIPMAP_LINEAR,
                               GL_LINEAR_MIPMAP_LINEAR,
                               GL_CLAMP,
                               GL_REPEAT,
                               GL_CLAMP_TO_EDGE,
                               GL_CLAMP_TO_BORDER,
                               GL_MODULATE,
                               GL_DECAL,
                               GL_BLEND,
                               GL_REPLACE,
                               GL_ADD,
                               GL_EXP2,
                               0,
                               1,
                               2};
constexpr GLenum internal_formats[] = {GL_RGBA,
                                       GL_RGB,
                                       GL_ALPHA,
                                       GL_LUMINANCE,
                                       GL_LUMINANCE_ALPHA,
                                       GL_INTENSITY,
                                       GL_RGB8,
                                       GL_RGBA8,
                                       GL_RGB5,
                                       GL_RGB5_A1,
                                       GL_RGBA4,
                                       GL_R3_G3_B2,
                                       GL_ALPHA4,
                                       GL_LUMINANCE8,
                                       GL_INTENSITY8,
                                       GL_LUMINANCE8_ALPHA8,
                                       1,
                                       2,
                                       3,
                                       4};

/// The stream; zeros when it has ended.
class Bytes {
  public:
    Bytes(const std::uint8_t* data, std::size_t bytes) : at(data), end(data + bytes) {}
    bool more() const { return at != end; }
    std::uint8_t byte() { return at != end ? *at++ : std::uint8_t{0}; }
    std::uint32_t word() {
        std::uint32_t w = byte();
        for (int i = 1; i < 4; ++i)
            w |= static_cast<std::uint32_t>(byte()) << 8 * i;
        return w;
    }

  private:
    const std::uint8_t *at, *end;
};

/// What images, arrays and parameters are read from: the same for all streams.
const std::vector<std::uint8_t>& numbers() {
    static const auto all = [] {
        std::vector<std::uint8_t> bytes(client_bytes);
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = static_cast<std::uint8_t>(i * i * 17 + i * 3);
        return bytes;
    }();
    return all;
}

/// What answers are written to.
std::uint8_t* result() {
    static std::vector<std::uint8_t> bytes(client_bytes);
    return bytes.data();
}

class Run {
  public:
    Run(const std::uint8_t* data, std::size_t bytes) : in(data, bytes) {
        for (std::size_t i = 0; i < client.size(); ++i) // indices of every type stay below 128
            client[i] = i % 4 == 0 ? static_cast<std::uint8_t>(i * 37 / 4 % 128) : std::uint8_t{0};
        std::fill(std::begin(elements), std::end(elements), client.data());
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
        s.color = color.data() + (height - 1) * width * pixel; // top row first
        s.color_stride = -width * pixel;
        s.depth = reinterpret_cast<std::uint8_t*>(depth.get());
        s.depth_stride = width * (deep ? 4 : 2);
        s.depth_format = deep ? DepthFormat::z24s8 : DepthFormat::z16;
        s.accum = accum.get();
        surface_ = s;
        if ((how_ & 4) != 0) {
            other_memory.resize((gl::fixed_engine.pipeline_bytes * 9 / 8 + 64) / 8); // sizes come in eighths
            arena.give(other_memory.data(), 8 * other_memory.size());
            other = gl::create_context(arena, {.tier = raster::Tier::balanced, .engine = &gl::fixed_engine},
                                       context);
        }
        turn_to(context);
    }

    void all() {
        const auto table = commands();
        while (in.more()) {
            const unsigned selected = in.byte() | static_cast<unsigned>(in.byte()) << 8;
            if (selected >= 0xFF00 && other != nullptr && !context->inside_begin_end() &&
                context->list.index == 0)
                turn();
            else
                one(table[selected % table.size()]);
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
    /// Bits of how_: double buffered, an index framebuffer, a second context that shares, fewer bits of an
    /// index.
    void turn_to(gl::Context* now) {
        gl::make_current(now, surface_, (how_ & 1) != 0);
        if (is_indexed(surface_.format))
            now->drawable.index_bits = static_cast<std::uint8_t>(1 + (how_ >> 3) % 8);
    }
    void turn() {
        std::swap(context, other);
        turn_to(context);
    }

    void one(const Command& c) {
        const std::string_view family = c.family;
        if (family == "CallList" || family == "CallLists") {
            // Lists that call twice take exponential time, which is what was asked for; one call each is
            // linear.
            if (called_in == context->list.index && called_in != 0)
                return;
            called_in = context->list.index;
        } else if (family == "NewList") {
            called_in = 0;
        }
        Value values[12];
        const Pname* pname = nullptr;
        for (std::size_t i = 0; i < c.args.size(); ++i)
            values[i] = argument(c, c.args[i], family, pname);
        if (family == "CallLists" && called_in != 0 && values[0].integer > 1)
            values[0].integer = 1;
        c.call(values);
    }

    Value argument(const Command& c, const Arg& arg, std::string_view family, const Pname*& pname) {
        const std::uint8_t how = in.byte();
        Value v{};
        switch (arg.kind) {
        case Kind::in:
        case Kind::out:
            if (how % 16 != 0)
                v.pointer = c.args.size() > 4 && &arg == &c.args[3] && family == "MultiDrawElements"
                                ? static_cast<void*>(elements)
                            : family == "DrawElements" || family == "DrawRangeElements" ||
                                    family.starts_with("MultiDraw") ||
                                    family.starts_with("Buffer") // may hold indices, too
                                ? client.data()
                                : arg.kind == Kind::out ? result()
                                                        : const_cast<std::uint8_t*>(numbers().data()) +
                                                              how % 8 * 8; // aligned for every type
            break;
        case Kind::enum_:
            if (!arg.accepted.empty() && how % 8 != 0)
                v.integer = arg.accepted[choice_of(how, 8, arg.accepted.size())];
            else
                v.integer = how % 16 == 0 ? in.word() : in.word() % 0x9000;
            break;
        case Kind::pname:
            pname = how % 16 != 0 ? &c.pnames[choice_of(how, 16, c.pnames.size())] : nullptr;
            v.integer = pname != nullptr ? pname->name : in.word() % 0x9000;
            break;
        case Kind::real:
        case Kind::pvalue:
            v.number = number(c, how);
            if (arg.kind == Kind::pvalue && pname != nullptr && pname->kind == 'i' && how % 4 != 0)
                v.number =
                    how % 4 == 1 ? static_cast<double>(pname->good) : settings[how % std::size(settings)];
            if (family == "PixelStore") // rows that client memory holds
                v.number = how % 11 - 2.0;
            break;
        case Kind::sizei:
            v.integer = free_size(family) && how % 16 == 0 ? static_cast<std::int32_t>(in.word())
                                                           : how % (most_items + 3) - 2;
            break;
        case Kind::int_:
            if (!arg.accepted.empty() && how % 8 != 0) { // an internal format
                v.integer = internal_formats[how % std::size(internal_formats)];
                break;
            }
            if (arg.high - arg.low < most_items && how % 8 != 0) { // in the range, or one beside it
                v.integer = arg.low - 1 + how % (arg.high - arg.low + 3);
                break;
            }
            v.integer = how % 8 == 0 && !reads_by_number(family) ? static_cast<std::int32_t>(in.word())
                                                                 : how % 68 - 3;
            break;
        case Kind::boolean:
            v.integer = how % 2;
            break;
        default:
            v.integer = how % 4 == 0 ? in.word() : how % 32;
        }
        return v;
    }

    /// Sizes that no client memory depends on.
    static bool free_size(std::string_view family) {
        return family == "Viewport" || family == "Scissor" || family == "GenLists" || family == "DeleteLists";
    }

    /// Elements of client memory, or of a mesh, by a number that must stay small.
    static bool reads_by_number(std::string_view family) {
        return family == "ArrayElement" || family == "DrawArrays" || family.starts_with("Map") ||
               family.starts_with("EvalMesh");
    }

    double number(const Command& c, std::uint8_t how) {
        const std::string_view name = c.name;
        const bool integers =
            name.find("xOES") != name.npos || name.back() == 'i' || name.back() == 's' || name.back() == 'b';
        if (how % 16 == 0 && !integers) {
            const std::uint32_t bits = in.word();
            float f;
            std::memcpy(&f, &bits, sizeof f);
            return f;
        }
        if (integers) // what every integer type can hold
            return how % 2 == 0 ? how % 100
                   : name.find("ub") != name.npos || name.find("us") != name.npos ||
                           name.find("ui") != name.npos
                       ? 5
                       : -(how % 100);
        return how % 4 == 0 ? how * 0.25 - 32 : (how - 128) / 64.0;
    }

    Bytes in;
    const std::size_t memory_bytes = 256 * 1024 + gl::fixed_engine.pipeline_bytes;
    std::unique_ptr<std::uint64_t[]> memory{new std::uint64_t[memory_bytes / 8]};
    std::vector<std::uint64_t> other_memory;
    gl::Arena arena;
    gl::Context *context = nullptr, *other = nullptr;
    unsigned how_ = 0;
    raster::Surface surface_;
    void* elements[most_items] = {}; ///< of MultiDrawElements
    GLuint called_in = 0;            ///< the list being compiled that has had its call
    std::vector<std::uint8_t> color;
    std::unique_ptr<std::uint32_t[]> depth;
    std::unique_ptr<std::int16_t[]> accum{new std::int16_t[4 * width * height]()};
    std::vector<std::uint8_t> client = std::vector<std::uint8_t>(4096);
};

} // namespace

void run_command_stream(const std::uint8_t* data, std::size_t bytes) {
    Run(data, bytes).all();
}

} // namespace spangle::test
