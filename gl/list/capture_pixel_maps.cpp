// Pixel maps in display lists. Their entries are copied while the list is compiled (GL 1.3, 5.4).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LISTS && SPANGLE_FEATURE_PIXEL_TRANSFER

#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/list/record.hpp"
#include "gl/pixel/pixel_maps.hpp"

namespace spangle::gl {

namespace {

using list::Word;

constexpr std::uint32_t map_words = 3;

std::uint32_t entry_bytes(GLenum type, GLsizei size) {
    return static_cast<std::uint32_t>(size) * (type == GL_UNSIGNED_SHORT ? 2 : 4);
}

/// Plays a pixel map. Its words are the map, the size, the type, and the entries as the client gave them.
const Word* play_pixel_map(Context& context, const Word* words) {
    const auto size = static_cast<GLsizei>(words[1]);
    if (allowed_outside(context, family::PixelMap::text))
        cmd::PixelMap(context, words[0], size, {words + map_words, words[2]});
    return words + map_words + (entry_bytes(words[2], size) + 3) / 4;
}

} // namespace

void encode::PixelMap(Context& context, GLenum map, GLsizei size, const Values& values) {
    if (const GLenum code = pixel_map_error(map, size, values); code != GL_NO_ERROR)
        return list::record_error(context, code, false, pixel_map_rule(values));
    const std::uint32_t bytes = entry_bytes(values.type, size);
    Word* const to =
        list::record(context, &list::player<&play_pixel_map, family::PixelMap>, map_words + (bytes + 3) / 4);
    if (to == nullptr)
        return;
    to[0] = map;
    to[1] = static_cast<Word>(size);
    to[2] = values.type;
    std::memcpy(to + map_words, values.at, bytes);
}

} // namespace spangle::gl

#endif
