// PixelMap, GetPixelMap and the sizes of the ten maps (GL 1.3, 3.6.3 and 6.1.3).
#include "gl/context/hooks.hpp"

#if SPANGLE_FEATURE_PIXEL_TRANSFER

#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/component.hpp"
#include "gl/pixel/pixel_maps.hpp"

namespace spangle::gl {

namespace {

bool is_of_indices(unsigned name) {
    return name <= map_s_to_s;
}
bool is_addressed_by_indices(unsigned name) {
    return name < map_r_to_r;
}

/// Loads an element of the client's array, which need not be aligned.
std::uint32_t load(const Values& array, std::size_t i) {
    const unsigned bytes = array.type == GL_UNSIGNED_SHORT ? 2 : 4;
    return load_element(static_cast<const unsigned char*>(array.at) + i * bytes, bytes, false);
}
void store(const Values& array, std::size_t i, std::uint32_t value) {
    const unsigned bytes = array.type == GL_UNSIGNED_SHORT ? 2 : 4;
    store_element(static_cast<unsigned char*>(const_cast<void*>(array.at)) + i * bytes, bytes, false, value);
}

/// Returns the form in which a pixel map stores an element. Colours are stored as clamped fractions. Indices
/// keep their values, and stencil indices are stored as integers.
std::uint32_t entry_of(unsigned name, const Values& array, std::size_t i) {
    const std::uint32_t value = load(array, i);
    if (array.type == GL_FLOAT) {
        const Real real = numeric::from_float_bits(value);
        return name == map_s_to_s    ? static_cast<std::uint32_t>(numeric::to_i32_round(real))
               : is_of_indices(name) ? real.bits
                                     : numeric::clamp01(real).bits;
    }
    if (is_of_indices(name))
        return value;
    return to_real(Component{value, static_cast<std::uint8_t>(array.type == GL_UNSIGNED_SHORT ? 16 : 32)})
        .bits;
}

/// Converts an entry to the type that the client asks for.
std::uint32_t answer(unsigned name, bool integers, std::uint32_t entry, GLenum type) {
    if (!is_of_indices(name))
        return encode_element(type == GL_FLOAT ? ElementKind::real : ElementKind::unsigned_integer,
                              type == GL_UNSIGNED_SHORT ? 16 : 32, component(Real{entry}));
    if (type == GL_FLOAT)
        return integers ? numeric::from_u32(entry).bits : entry;
    return integers ? entry : static_cast<std::uint32_t>(numeric::to_i32_round({entry}));
}

} // namespace

static_assert(GL_PIXEL_MAP_S_TO_S - GL_PIXEL_MAP_I_TO_I == map_s_to_s &&
              GL_PIXEL_MAP_I_TO_R - GL_PIXEL_MAP_I_TO_I == map_i_to_r &&
              GL_PIXEL_MAP_I_TO_A - GL_PIXEL_MAP_I_TO_I == map_i_to_r + 3 &&
              GL_PIXEL_MAP_R_TO_R - GL_PIXEL_MAP_I_TO_I == map_r_to_r &&
              GL_PIXEL_MAP_A_TO_A - GL_PIXEL_MAP_I_TO_I == pixel_maps - 1 &&
              GL_PIXEL_MAP_S_TO_S_SIZE - GL_PIXEL_MAP_I_TO_I_SIZE == map_s_to_s &&
              GL_PIXEL_MAP_I_TO_R_SIZE - GL_PIXEL_MAP_I_TO_I_SIZE == map_i_to_r &&
              GL_PIXEL_MAP_R_TO_R_SIZE - GL_PIXEL_MAP_I_TO_I_SIZE == map_r_to_r &&
              GL_PIXEL_MAP_A_TO_A_SIZE - GL_PIXEL_MAP_I_TO_I_SIZE == pixel_maps - 1);

GLenum pixel_map_error(GLenum map, GLsizei size, const Values& values) {
    const unsigned name = map - GL_PIXEL_MAP_I_TO_I;
    if (name >= pixel_maps)
        return GL_INVALID_ENUM;
    const bool fits = size >= 1 && size <= max_pixel_map_table &&
                      (!is_addressed_by_indices(name) || (size & (size - 1)) == 0);
    return fits && values.at != nullptr ? GL_NO_ERROR : GL_INVALID_VALUE;
}

GLint pixel_map_size(const Context& context, GLenum pname) {
    const PixelMap* const map = context.pixel_mode.map[pname - GL_PIXEL_MAP_I_TO_I_SIZE];
    return map != nullptr ? map->size : 1;
}

void release_pixel_maps(Context& context) {
    for (PixelMap* map : context.pixel_mode.map)
        context.arena->free(map);
}

namespace cmd {

void PixelMap(Context& context, GLenum map, GLsizei size, const Values& values) {
    if (const GLenum code = pixel_map_error(map, size, values); code != GL_NO_ERROR)
        return error(context, code, pixel_map_rule(values));
    const unsigned name = map - GL_PIXEL_MAP_I_TO_I;
    const auto count = static_cast<std::size_t>(size);
    void* const memory = context.arena->allocate(sizeof(gl::PixelMap) + count * sizeof(std::uint32_t));
    if (memory == nullptr)
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena for the map"));
    auto* const table = static_cast<gl::PixelMap*>(memory);
    *table = {size, is_of_indices(name) && (values.type != GL_FLOAT || name == map_s_to_s)};
    for (std::size_t i = 0; i < count; ++i)
        table->entries()[i] = entry_of(name, values, i);
    context.arena->free(context.pixel_mode.map[name]);
    context.pixel_mode.map[name] = table;
}

void GetPixelMap(Context& context, GLenum map, const Values& values) {
    const unsigned name = map - GL_PIXEL_MAP_I_TO_I;
    if (name >= pixel_maps)
        return error(context, GL_INVALID_ENUM);
    if (values.at == nullptr)
        return error(context, GL_INVALID_VALUE);
    const gl::PixelMap* const table = context.pixel_mode.map[name];
    if (table == nullptr) // the initial map has one entry, 0
        return store(values, 0, 0);
    for (GLsizei i = 0; i < table->size; ++i)
        store(values, static_cast<std::size_t>(i),
              answer(name, table->integers, table->entries()[i], values.type));
}

} // namespace cmd

} // namespace spangle::gl

#else

namespace spangle::gl {

void release_pixel_maps(Context&) {}

} // namespace spangle::gl

#endif
