#include "gl/context/initial.hpp"

#include <bit>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <memory>
#include <new>
#include <type_traits>

namespace spangle::gl {

namespace {

// The initial bytes of a context, compressed. Inline constructors would need a store instruction for each
// member. Most words of a context begin as 0, and few other values occur. The compressed form counts the
// words of 0 before each other word, and names its value.

inline constexpr std::size_t context_words = sizeof(Context) / sizeof(std::uint32_t);
static_assert(sizeof(Context) % sizeof(std::uint32_t) == 0);
/// Largest distance, in words, at which repetitions are looked for.
inline constexpr std::size_t most_back = 255;
// A copy of a context's bytes is therefore a context.
static_assert(std::is_trivially_copyable_v<Context>);

struct Image {
    std::uint32_t word[context_words] = {};

    template <class T> constexpr void put(std::size_t at, const T& value) {
        // In builds without textures, some arrays are empty.
        if constexpr (requires { value[0]; }) {
            for (std::size_t i = 0; i < sizeof value / sizeof value[0]; ++i)
                put(at + i * sizeof value[0], value[i]);
        } else if constexpr (std::is_class_v<T>) {
            put_members(at, value);
        } else if constexpr (std::is_same_v<T, signed char>) {
            put(at, static_cast<unsigned char>(value));
        } else {
            const auto bits = static_cast<std::uint32_t>(value);
            const std::size_t first = at % sizeof bits;
            const std::size_t up =
                std::endian::native == std::endian::little ? first : sizeof bits - sizeof(T) - first;
            const std::uint32_t mask = UINT32_MAX >> (sizeof bits - sizeof(T)) * 8;
            word[at / sizeof bits] |= (bits & mask) << up * 8;
        }
    }

    // Writes the members whose initial value is not 0, chapter by chapter, as far as this build has them.
#define PUT(MEMBER)                                                                                          \
    if constexpr (requires { requires std::is_member_object_pointer_v<decltype(&T::MEMBER)>; })              \
        put(at + offsetof(T, MEMBER), s.MEMBER);
#define MEMBERS(TYPE, ...)                                                                                   \
    if constexpr (std::is_same_v<T, TYPE>) {                                                                 \
        __VA_ARGS__                                                                                          \
    }
    template <int depth> constexpr void put_members(std::size_t at, const MatrixStack<depth>& s) {
        put(at + offsetof(MatrixStack<depth>, entry), s.entry[0]);
    }
    template <class T> constexpr void put_members(std::size_t at, const T& s) {
        MEMBERS(Real, PUT(bits))
        MEMBERS(CurrentState::TexCoord, PUT(v))
        MEMBERS(RasterPosition::TexCoord, PUT(v))
        MEMBERS(RasterPosition, PUT(position) PUT(color) PUT(index) PUT(tex_coord) PUT(valid))
        MEMBERS(CurrentState, PUT(color) PUT(secondary_color) PUT(normal) PUT(index) PUT(edge_flag)
                                  PUT(tex_coord) PUT(raster))
        MEMBERS(numeric::Matrix, PUT(m) PUT(e))
        MEMBERS(TransformState, PUT(matrix_mode) PUT(modelview) PUT(projection) PUT(texture) PUT(depth_range))
        MEMBERS(Light, PUT(ambient) PUT(diffuse) PUT(specular) PUT(position) PUT(spot_direction)
                           PUT(spot_cutoff) PUT(attenuation))
        MEMBERS(Material, PUT(ambient) PUT(diffuse) PUT(specular) PUT(emission) PUT(indexes))
        MEMBERS(LightingState, PUT(color_material_face) PUT(color_material_parameter) PUT(model_ambient)
                                   PUT(color_control) PUT(light) PUT(material))
        MEMBERS(ClientArray, PUT(size) PUT(type))
        MEMBERS(ArraysState, PUT(vertex) PUT(normal) PUT(color) PUT(index) PUT(edge_flag) PUT(fog_coord)
                                 PUT(secondary_color) PUT(tex_coord))
        MEMBERS(StipplePattern, PUT(row))
        MEMBERS(PolygonState,
                PUT(shade_model) PUT(front_face) PUT(cull_face_mode) PUT(mode) PUT(point_size) PUT(line_width)
                    PUT(point_size_max) PUT(point_fade_threshold) PUT(point_attenuation) PUT(sprite_origin)
                        PUT(stipple_factor) PUT(stipple_pattern) PUT(stipple))
        MEMBERS(StencilSide,
                PUT(func) PUT(value_mask) PUT(fail) PUT(pass_depth_fail) PUT(pass_depth_pass) PUT(write_mask))
        MEMBERS(BlendPart, PUT(src) PUT(equation))
        MEMBERS(FragmentOpsState,
                PUT(alpha_func) PUT(stencil) PUT(depth_func) PUT(depth_mask) PUT(depth_clear) PUT(blend_rgb)
                    PUT(blend_alpha) PUT(logic_op) PUT(dither) PUT(multisample) PUT(sample_coverage_value)
                        PUT(color_mask) PUT(index_mask) PUT(draw_buffer) PUT(read_buffer))
        MEMBERS(FogState, PUT(mode) PUT(density) PUT(end) PUT(source))
        MEMBERS(TexGenState, PUT(mode) PUT(object_plane) PUT(eye_plane))
        MEMBERS(TexEnvState, PUT(mode) PUT(func) PUT(source) PUT(operand) PUT(scale))
        MEMBERS(TextureUnitState, PUT(gen) PUT(env))
        MEMBERS(LevelShape, PUT(internal_format) PUT(dimensions) PUT(format))
        MEMBERS(TextureParameters, PUT(min_filter) PUT(mag_filter) PUT(wrap) PUT(priority) PUT(min_lod)
                                       PUT(max_lod) PUT(max_level) PUT(depth_mode) PUT(compare_func))
        MEMBERS(TextureObject, PUT(kind) PUT(parameters))
        MEMBERS(CubeTexture, PUT(object))
        MEMBERS(TextureState,
                PUT(unit) PUT(default_2d) PUT(default_1d) PUT(default_3d) PUT(default_cube) PUT(proxies))
        MEMBERS(PixelStore, PUT(alignment))
        MEMBERS(PixelStoreState, PUT(unpack) PUT(pack))
        MEMBERS(Linear, PUT(scale))
        MEMBERS(PixelModeState, PUT(linear) PUT(zoom))
        MEMBERS(HintState, PUT(mode))
        MEMBERS(SelectState, PUT(nearest))
        MEMBERS(FeedbackState, PUT(type))
        MEMBERS(RenderState, PUT(mode) PUT(select) PUT(feedback))
        MEMBERS(EvalState, PUT(segments_1) PUT(segments_2) PUT(domain_1) PUT(domain_2))
        MEMBERS(raster::Surface, PUT(end_row) PUT(format) PUT(depth_format))
        MEMBERS(Drawable, PUT(surface) PUT(read))
    }
#undef MEMBERS
#undef PUT
};

consteval Image initial_image() {
    Image image;
    image.put(offsetof(Context, dirty), std::uint16_t{dirty_all});
#define PUT(CHAPTER)                                                                                         \
    decltype(Context::CHAPTER) CHAPTER;                                                                      \
    image.put(offsetof(Context, CHAPTER), CHAPTER);
    PUT(current)
    PUT(transform)
    PUT(lighting)
    PUT(arrays)
    PUT(polygon)
    PUT(fragment_ops)
    PUT(fog)
    PUT(texture)
    PUT(pixel_store)
    PUT(pixel_mode)
    PUT(hint)
    PUT(render)
    PUT(eval)
    PUT(drawable)
#undef PUT
    return image;
}

/// One step of the compressed image: `zeros` words of 0, followed by word `value` of the table. If `value` is
/// 0, the next step copies words that were written before. Its two numbers are how many words back they
/// begin, and how many there are.
struct Step {
    std::uint8_t zeros, value;
};

/// The compressed image while it is being made, with room for the largest number of steps and values.
struct Steps {
    Step step[2 * context_words] = {};
    std::uint32_t value[UINT8_MAX + 1] = {};
    std::size_t steps = 0, values = 1;

    constexpr void add(std::size_t zeros, std::size_t value) {
        step[steps++] = {static_cast<std::uint8_t>(zeros), static_cast<std::uint8_t>(value)};
    }
    constexpr std::size_t index_of(std::uint32_t word) {
        std::size_t i = 1;
        while (i < values && value[i] != word)
            ++i;
        if (i == values)
            value[values++] = word;
        return i;
    }
};

/// Returns how many words from `at` on equal the words `back` words before them. The last word counted is not
/// 0.
constexpr std::size_t repeated(const Image& image, std::size_t at, std::size_t back) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < UINT8_MAX && at + i < context_words; ++i) {
        if (image.word[at + i] != image.word[at + i - back])
            break;
        if (image.word[at + i] != 0)
            count = i + 1;
    }
    return count;
}

consteval Steps initial_steps() {
    const Image image = initial_image();
    Steps out;
    std::size_t zeros = 0;
    for (std::size_t at = 0; at < context_words;) {
        if (image.word[at] == 0) {
            ++at;
            ++zeros;
            continue;
        }
        for (; zeros > UINT8_MAX; zeros -= UINT8_MAX) {
            out.add(UINT8_MAX, 0);
            out.add(0, 0);
        }
        std::size_t count = 0, back = 0;
        for (std::size_t b = 1; b <= most_back && b <= at; ++b)
            if (const std::size_t there = repeated(image, at, b); there > count) {
                count = there;
                back = b;
            }
        if (count > 2) { // a copy takes two steps
            out.add(zeros, 0);
            out.add(back, count);
        } else {
            count = 1;
            out.add(zeros, out.index_of(image.word[at]));
        }
        at += count;
        zeros = 0;
    }
    return out;
}

/// The compressed image without unused room.
template <std::size_t steps, std::size_t values> struct Packed {
    Step step[steps];
    std::uint32_t value[values];
};
constexpr auto initial = [] {
    constexpr Steps from = initial_steps();
    Packed<from.steps, from.values> out{};
    for (std::size_t i = 0; i < from.steps; ++i)
        out.step[i] = from.step[i];
    for (std::size_t i = 0; i < from.values; ++i)
        out.value[i] = from.value[i];
    return out;
}();

} // namespace

Context* begin_context(void* memory) {
    constexpr std::size_t word = sizeof(std::uint32_t);
    auto* at = std::assume_aligned<word>(static_cast<unsigned char*>(memory));
    for (const Step* step = std::begin(initial.step); step != std::end(initial.step); ++step) {
        at += step->zeros * word;
        if (step->value != 0) {
            std::memcpy(std::assume_aligned<word>(at), &initial.value[step->value], word);
            at += word;
            continue;
        }
        ++step;
        for (unsigned left = step->value; left != 0; --left, at += word)
            std::memcpy(std::assume_aligned<word>(at), std::assume_aligned<word>(at - step->zeros * word),
                        word);
    }
    return std::launder(static_cast<Context*>(memory));
}

} // namespace spangle::gl
