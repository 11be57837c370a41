// Evaluator maps in display lists. Control points are copied while the list is compiled, without the gaps of
// the client's strides (GL 1.3, 5.4).
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LISTS && SPANGLE_FEATURE_EVALUATORS

#include "gl/api/generated/commands.hpp"
#include "gl/list/record.hpp"
#include "gl/vertex/maps.hpp"

namespace spangle::gl {

namespace {

using list::Word;

constexpr std::uint32_t side_words = 3, head_words = 1 + 2 * side_words;

/// Plays a map. Its words are the target, domain and order of each side, and the control points.
template <unsigned dimension> const Word* play_map(Context& context, const Word* words) {
    const GLenum target = words[0];
    const auto components =
        static_cast<GLint>(components_of(target - (dimension == 0 ? GL_MAP1_COLOR_4 : GL_MAP2_COLOR_4)));
    const auto order = [words](int side) {
        return static_cast<GLint>(words[3 + static_cast<std::uint32_t>(side) * side_words]);
    };
    const Values points{words + head_words, GL_FLOAT};
    if (allowed_outside(context, dimension == 0 ? family::Map1::text : family::Map2::text)) {
        if constexpr (dimension == 0)
            cmd::Map1(context, target, {words[1]}, {words[2]}, components, order(0), points);
        else
            cmd::Map2(context, target, {words[1]}, {words[2]}, components * order(1), order(0), {words[4]},
                      {words[5]}, components, order(1), points);
    }
    return words + head_words + static_cast<std::uint32_t>(components * order(0) * order(1));
}

template <unsigned dimension> void capture(Context& context, const MapArguments& map) {
    if (const GLenum code = map_error(map, dimension); code != GL_NO_ERROR)
        return list::record_error(context, code, false, map_rule(map));
    const unsigned components =
        components_of(map.target - (dimension == 0 ? GL_MAP1_COLOR_4 : GL_MAP2_COLOR_4));
    const auto points = static_cast<std::uint32_t>(map.side[0].order * map.side[1].order);
    Word* to = list::record(
        context,
        &list::player<&play_map<dimension>, std::conditional_t<dimension == 0, family::Map1, family::Map2>>,
        head_words + points * components);
    if (to == nullptr)
        return;
    *to++ = map.target;
    for (const MapArguments::Side& side : map.side) {
        *to++ = side.from.bits;
        *to++ = side.to.bits;
        *to++ = static_cast<Word>(side.order);
    }
    for (GLint i = 0; i < map.side[0].order; ++i)
        for (GLint j = 0; j < map.side[1].order; ++j)
            for (unsigned c = 0; c < components; ++c)
                *to++ = control_value(map, i, j, c).bits;
}

} // namespace

namespace encode {

void Map1(Context& context, GLenum target, Real u1, Real u2, GLint stride, GLint order,
          const Values& points) {
    capture<0>(context, map_arguments(target, u1, u2, stride, order, points));
}

void Map2(Context& context, GLenum target, Real u1, Real u2, GLint ustride, GLint uorder, Real v1, Real v2,
          GLint vstride, GLint vorder, const Values& points) {
    capture<1>(context, {target, {{u1, u2, ustride, uorder}, {v1, v2, vstride, vorder}}, points});
}

} // namespace encode

} // namespace spangle::gl

#endif
