// PolygonStipple in display lists. The pattern is unpacked with the unpack state of the compilation (GL 1.3,
// 5.4).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LISTS && SPANGLE_FEATURE_STIPPLE

#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/list/record.hpp"
#include "gl/pixel/polygon_stipple.hpp"

namespace spangle::gl {

namespace {

using list::Word;

constexpr std::uint32_t pattern_words = sizeof(StipplePattern) / sizeof(Word);

const Word* play_polygon_stipple(Context& context, const Word* words) {
    if (allowed_outside(context, family::PolygonStipple::text))
        std::memcpy(context.polygon.stipple.row, words, sizeof(StipplePattern));
    return words + pattern_words;
}

} // namespace

namespace encode {

void PolygonStipple(Context& context, const GLubyte* pattern) {
    if (pattern == nullptr)
        return list::record_error(context, GL_INVALID_VALUE, false);
    const StipplePattern unpacked = unpack_stipple(context.pixel_store.unpack, pattern);
    if (Word* const to = list::record(context, &list::player<&play_polygon_stipple, family::PolygonStipple>,
                                      pattern_words);
        to != nullptr)
        std::memcpy(to, unpacked.row, sizeof unpacked);
}

} // namespace encode

} // namespace spangle::gl

#endif
