// Map1, Map2 and GetMap set and query the control points of evaluators (GL 1.3, 5.1).
#include "gl/vertex/maps.hpp"

#include "gl/context/hooks.hpp"

#if SPANGLE_FEATURE_EVALUATORS

#include <cstring>

#include "gl/api/convert.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"

namespace spangle::gl {

namespace {

/// A map of order 1. Its control point follows it, where EvalMap::points() finds it.
struct InitialMap {
    EvalMap map;
    Real point[4];
};

constexpr EvalMap::Side initial_side{1, numeric::zero, numeric::one};
constexpr InitialMap initial_of(Real x, Real y, Real z, Real w) {
    return {{{initial_side, initial_side}}, {x, y, z, w}};
}

/// Initial maps. Their control points are the initial values of the current attributes (GL 1.3, table 6.22).
constexpr InitialMap of_color = initial_of(numeric::one, numeric::one, numeric::one, numeric::one),
                     of_normal = initial_of(numeric::zero, numeric::zero, numeric::one, numeric::zero),
                     of_position = initial_of(numeric::zero, numeric::zero, numeric::zero, numeric::one);

const EvalMap& initial_map(unsigned target) {
    return target <= eval_index ? of_color.map : target == eval_normal ? of_normal.map : of_position.map;
}

GLenum first_target(unsigned dimension) {
    return dimension == 0 ? GL_MAP1_COLOR_4 : GL_MAP2_COLOR_4;
}

bool side_is_wrong(const MapArguments::Side& side, unsigned components) {
    return side.order < 1 || side.order > max_eval_order || side.stride < static_cast<GLint>(components) ||
           side.from == side.to;
}

void define(Context& context, const MapArguments& given, unsigned dimension) {
    if (const GLenum code = map_error(given, dimension); code != GL_NO_ERROR)
        return error(context, code, map_rule(given));
    if (context.texture.active != 0)
        return error(context, GL_INVALID_OPERATION,
                     SPANGLE_TEXT("evaluators are of texture unit 0, which is not active"));
    const unsigned target = given.target - first_target(dimension), components = components_of(target);
    const auto points = static_cast<std::size_t>(given.side[0].order * given.side[1].order);
    auto* const map =
        static_cast<EvalMap*>(context.arena->allocate(sizeof(EvalMap) + points * components * sizeof(Real)));
    if (map == nullptr)
        return error(context, GL_OUT_OF_MEMORY, SPANGLE_TEXT("no room in the arena for the points"));
    for (int d = 0; d < 2; ++d)
        map->side[d] = {given.side[d].order, given.side[d].from, given.side[d].to};
    Real* to = map->points();
    for (GLint i = 0; i < given.side[0].order; ++i)
        for (GLint j = 0; j < given.side[1].order; ++j)
            for (unsigned c = 0; c < components; ++c)
                *to++ = control_value(given, i, j, c);
    context.arena->free(context.eval.map[dimension][target]);
    context.eval.map[dimension][target] = map;
}

} // namespace

unsigned components_of(unsigned target) {
    constexpr std::uint8_t components[eval_targets] = {4, 1, 3, 1, 2, 3, 4, 3, 4};
    static_assert(
        GL_MAP1_INDEX - GL_MAP1_COLOR_4 == eval_index && GL_MAP1_NORMAL - GL_MAP1_COLOR_4 == eval_normal &&
        GL_MAP1_TEXTURE_COORD_1 - GL_MAP1_COLOR_4 == eval_texture_1 &&
        GL_MAP1_TEXTURE_COORD_4 - GL_MAP1_COLOR_4 == eval_texture_4 &&
        GL_MAP1_VERTEX_3 - GL_MAP1_COLOR_4 == eval_vertex_3 &&
        GL_MAP1_VERTEX_4 - GL_MAP1_COLOR_4 == eval_vertex_4 &&
        GL_MAP2_VERTEX_4 - GL_MAP2_COLOR_4 == eval_vertex_4 &&
        GL_MAP2_NORMAL - GL_MAP2_COLOR_4 == eval_normal && components[eval_color] == 4 &&
        components[eval_index] == 1 && components[eval_normal] == 3 && components[eval_texture_1] == 1 &&
        components[eval_texture_4] == 4 && components[eval_vertex_3] == 3 && components[eval_vertex_4] == 4);
    return components[target];
}

GLenum map_error(const MapArguments& map, unsigned dimension) {
    const unsigned target = map.target - first_target(dimension);
    if (target >= eval_targets)
        return GL_INVALID_ENUM;
    const unsigned components = components_of(target);
    return side_is_wrong(map.side[0], components) || side_is_wrong(map.side[1], components) ||
                   map.points.at == nullptr
               ? GL_INVALID_VALUE
               : GL_NO_ERROR;
}

Real control_value(const MapArguments& map, GLint i, GLint j, unsigned c) {
    // A product of a stride and an index needs more than 32 bits where the client's stride is large.
    const auto at = [](GLint stride, GLint n) {
        return static_cast<std::size_t>(stride) * static_cast<std::size_t>(n);
    };
    return convert::array_value(map.points, at(map.side[0].stride, i) + at(map.side[1].stride, j) + c);
}

const EvalMap& map_of(const Context& context, unsigned dimension, unsigned target) {
    const EvalMap* const map = context.eval.map[dimension][target];
    return map != nullptr ? *map : initial_map(target);
}

void release_evaluators(Context& context) {
    for (auto& maps : context.eval.map)
        for (EvalMap*& map : maps) {
            context.arena->free(map);
            map = nullptr;
        }
}

namespace cmd {

void Map1(Context& context, GLenum target, Real u1, Real u2, GLint stride, GLint order,
          const Values& points) {
    define(context, map_arguments(target, u1, u2, stride, order, points), 0);
}

void Map2(Context& context, GLenum target, Real u1, Real u2, GLint ustride, GLint uorder, Real v1, Real v2,
          GLint vstride, GLint vorder, const Values& points) {
    define(context, {target, {{u1, u2, ustride, uorder}, {v1, v2, vstride, vorder}}, points}, 1);
}

void GetMap(Context& context, GLenum target, GLenum query, const Values& v) {
    const unsigned dimension = target >= GL_MAP2_COLOR_4 ? 1 : 0, t = target - first_target(dimension);
    if (t >= eval_targets || (query != GL_COEFF && query != GL_ORDER && query != GL_DOMAIN))
        return error(context, GL_INVALID_ENUM);
    if (v.at == nullptr)
        return error(context, GL_INVALID_VALUE);
    const EvalMap& map = map_of(context, dimension, t);
    std::size_t n = 0;
    const auto put = [&](Kind kind, Param value) { convert::store_array_value(v, n++, kind, value); };
    if (query == GL_COEFF) {
        const auto points = static_cast<std::size_t>(map.side[0].order * map.side[1].order);
        while (n < points * components_of(t))
            put(Kind::real, Param::from(map.points()[n]));
        return;
    }
    for (unsigned d = 0; d <= dimension; ++d) {
        if (query == GL_ORDER) {
            put(Kind::integer, Param::from_integer(static_cast<std::uint32_t>(map.side[d].order)));
        } else {
            put(Kind::real, Param::from(map.side[d].from));
            put(Kind::real, Param::from(map.side[d].to));
        }
    }
}

} // namespace cmd

} // namespace spangle::gl

#else

namespace spangle::gl {
void release_evaluators(Context&) {}
} // namespace spangle::gl

#endif
