// Commands of lights, materials, the light model and ColorMaterial (GL 1.3, 2.13.1 to 2.13.3).
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <iterator>

#include "gl/api/generated/commands.hpp"
#include "gl/context/context.hpp"
#include "gl/context/features.hpp"
#include "gl/context/hooks.hpp"
#include "gl/vertex/engine.hpp"
#include "raster/numeric/matrix_build.hpp"

#if SPANGLE_FEATURE_LIGHTING

namespace spangle::gl {

namespace {

constexpr Real ninety = numeric::from_i32(90), hundred_twenty_eight = numeric::from_i32(128);

bool in_range(Real v, Real high) {
    return !(v < numeric::zero) && !(high < v);
}

/// Returns the sides that a face names: bit 0 stands for the front and bit 1 for the back. 0: the token names
/// no face.
unsigned sides_of(GLenum face) {
    return face == GL_FRONT ? 1u : face == GL_BACK ? 2u : face == GL_FRONT_AND_BACK ? 3u : 0u;
}

static_assert(sizeof(Param) == sizeof(Real));

void copy(Real (&to)[4], const Params& from) {
    std::memcpy(to, from.v, sizeof to);
}

bool is_black(const Params& v) {
    return numeric::is_zero(v.v[0].real()) && numeric::is_zero(v.v[1].real()) &&
           numeric::is_zero(v.v[2].real());
}

void give(Params& to, const Real* from, std::uint32_t count) {
    to.count = count;
    std::memcpy(static_cast<void*>(to.v), from, count * sizeof(Real));
}

/// Prepares a change of materials. Materials may change inside Begin/End, and vertices given before keep the
/// colours of the old material (GL 1.3, 2.13.2).
void materials_change(Context& context) {
    if (context.inside_begin_end())
        context.engine->settle_colors(context);
    context.changed(dirty_materials);
}

/// Message for a light that this build does not have. Other wrong arguments have no message.
constexpr const char* beyond_lights =
    SPANGLE_TEXT("light is beyond the lights of this build (SPANGLE_LIGHTS)");

/// Sets the error for a kind of lighting that this build does not have.
void refuse_pname(Context& context) {
    error(context, GL_INVALID_OPERATION,
          SPANGLE_TEXT("this build has no such lighting (SPANGLE_LIGHT_KINDS, SPANGLE_FULL_LIGHTING)"));
}

/// True if a component of a diffuse light or material is 16 or more, which only a build with
/// SPANGLE_FULL_LIGHTING accepts.
bool too_bright(const Params& v) {
    constexpr std::uint32_t sixteen = numeric::from_i32(16).bits;
    bool bright = false;
    for (int c = 0; c < 3 && !has_full_lighting; ++c)
        bright = bright || (v.v[c].word & 0x7FFFFFFF) >= sixteen;
    return bright;
}

/// Offsets of properties in Material, in Reals. The first three tokens start at AMBIENT, and the others at
/// EMISSION; the last entry is the end. AMBIENT_AND_DIFFUSE has no room of its own.
constexpr std::uint8_t material_place[] = {0, 4, 8, 12, 16, 17, 17, 20};
static_assert(offsetof(Material, emission) == 12 * sizeof(Real) &&
              offsetof(Material, indexes) == 17 * sizeof(Real) && sizeof(Material) == 20 * sizeof(Real));

/// Returns the index of a property in material_place. 7 or more: the token names no property of materials.
constexpr GLenum material_property(GLenum pname) {
    return pname - GL_AMBIENT < 3 ? pname - GL_AMBIENT : pname - GL_EMISSION + 3;
}

constexpr bool lies_at(GLenum pname, std::size_t offset) {
    return material_place[material_property(pname)] * sizeof(Real) == offset;
}
static_assert(lies_at(GL_AMBIENT, offsetof(Material, ambient)) &&
              lies_at(GL_DIFFUSE, offsetof(Material, diffuse)) &&
              lies_at(GL_SPECULAR, offsetof(Material, specular)) &&
              lies_at(GL_EMISSION, offsetof(Material, emission)) &&
              lies_at(GL_SHININESS, offsetof(Material, shininess)) &&
              lies_at(GL_COLOR_INDEXES, offsetof(Material, indexes)));

/// Sets a property of a material for Material or ColorMaterial.
void set_property(Material& m, GLenum pname, const void* v, std::uint32_t count) {
    std::memcpy(reinterpret_cast<Real*>(&m) + material_place[material_property(pname)], v,
                count * sizeof(Real));
}

/// True if ColorMaterial tracks the property, so that Material must not set it (GL 1.3, appendix B, corollary
/// 11).
bool is_tracked(const LightingState& state, unsigned side, GLenum pname) {
    if (!has_color_material || !state.color_material ||
        (sides_of(state.color_material_face) & (1u << side)) == 0)
        return false;
    const GLenum mode = state.color_material_parameter;
    return mode == pname || (mode == GL_AMBIENT_AND_DIFFUSE && (pname == GL_AMBIENT || pname == GL_DIFFUSE));
}

void track_color(Context& context) {
    LightingState& state = context.lighting;
    const unsigned sides = sides_of(state.color_material_face);
    const GLenum mode = state.color_material_parameter;
    const bool both = mode == GL_AMBIENT_AND_DIFFUSE;
    for (unsigned side = 0; side < 2; ++side)
        if ((sides & (1u << side)) != 0) {
            set_property(state.material[side], both ? GL_AMBIENT : mode, context.current.color, 4);
            if (both)
                set_property(state.material[side], GL_DIFFUSE, context.current.color, 4);
        }
}

/// Transforms a position or direction to eye space, in which lights are stored (GL 1.3, 2.13.1).
void to_eye(const Context& context, const Real (&v)[4], Real* out, int components) {
    const numeric::Matrix& m = context.transform.modelview.entry[context.transform.modelview.top];
    for (int i = 0; i < components; ++i) {
        numeric::Block sum;
        for (int j = 0; j < components; ++j)
            sum = numeric::add(sum, numeric::mul(numeric::to_block(m.at(i, j)), numeric::to_block(v[j])));
        out[i] = numeric::to_real(sum);
    }
}

/// Offsets of properties in Light, in Reals, for the tokens from AMBIENT on. The last entry is the end.
constexpr std::uint8_t property_place[] = {0, 4, 8, 12, 16, 19, 20, 21, 22, 23, 24};
static_assert(std::size(property_place) == GL_QUADRATIC_ATTENUATION - GL_AMBIENT + 2);
static_assert(offsetof(Light, position) == 12 * sizeof(Real) &&
              offsetof(Light, spot_cutoff) == 20 * sizeof(Real) && sizeof(Light) == 24 * sizeof(Real));

constexpr bool light_has(GLenum pname, std::size_t offset) {
    return property_place[pname - GL_AMBIENT] * sizeof(Real) == offset;
}
static_assert(light_has(GL_AMBIENT, offsetof(Light, ambient)) &&
              light_has(GL_DIFFUSE, offsetof(Light, diffuse)) &&
              light_has(GL_SPECULAR, offsetof(Light, specular)) &&
              light_has(GL_POSITION, offsetof(Light, position)) &&
              light_has(GL_SPOT_DIRECTION, offsetof(Light, spot_direction)) &&
              light_has(GL_SPOT_EXPONENT, offsetof(Light, spot_exponent)) &&
              light_has(GL_SPOT_CUTOFF, offsetof(Light, spot_cutoff)) &&
              light_has(GL_CONSTANT_ATTENUATION, offsetof(Light, attenuation)) &&
              light_has(GL_QUADRATIC_ATTENUATION, offsetof(Light, attenuation) + 2 * sizeof(Real)));

Real* property_of(Light& light, GLenum pname) {
    return reinterpret_cast<Real*>(&light) + property_place[pname - GL_AMBIENT];
}
std::uint32_t property_size(GLenum pname) {
    return static_cast<std::uint32_t>(property_place[pname - GL_AMBIENT + 1] -
                                      property_place[pname - GL_AMBIENT]);
}

} // namespace

void color_material_enabled(Context& context) {
    track_color(context);
    context.changed(dirty_materials);
}

void color_changed(Context& context) {
    materials_change(context);
    track_color(context);
}

namespace cmd {

void Light(Context& context, GLenum light, GLenum pname, const Params& params) {
    if (light < GL_LIGHT0 || light >= GL_LIGHT0 + max_lights || params.count == 0)
        return error(context, GL_INVALID_ENUM, params.count == 0 ? nullptr : beyond_lights);
    const Real v[4] = {params.v[0].real(), params.v[1].real(), params.v[2].real(), params.v[3].real()};
    const bool spot = pname == GL_SPOT_CUTOFF && !(v[0] == no_spot_cutoff);
    const bool in_eye_space = pname == GL_POSITION || pname == GL_SPOT_DIRECTION;
    if ((pname == GL_SPOT_EXPONENT && !in_range(v[0], hundred_twenty_eight)) ||
        (spot && !in_range(v[0], ninety)) || (pname >= GL_CONSTANT_ATTENUATION && v[0] < numeric::zero))
        return error(context, GL_INVALID_VALUE);
    if ((pname == GL_DIFFUSE && too_bright(params)) ||
        (!has_local_lights && (spot || (pname == GL_POSITION && !numeric::is_zero(v[3])))))
        return refuse_pname(context);
    Real* const to = property_of(context.lighting.light[light - GL_LIGHT0], pname);
    if (in_eye_space)
        to_eye(context, v, to, static_cast<int>(params.count));
    else
        std::memcpy(to, v, params.count * sizeof(Real));
    context.changed(dirty_lights);
}

void GetLight(Context& context, GLenum light, GLenum pname, Params& params) {
    params.count = 0;
    if (light < GL_LIGHT0 || light >= GL_LIGHT0 + max_lights || pname < GL_AMBIENT ||
        pname > GL_QUADRATIC_ATTENUATION)
        return error(context, GL_INVALID_ENUM, beyond_lights);
    give(params, property_of(context.lighting.light[light - GL_LIGHT0], pname), property_size(pname));
}

void LightModel(Context& context, GLenum pname, const Params& params) {
    if (params.count == 0)
        return error(context, GL_INVALID_ENUM);
    LightingState& state = context.lighting;
    switch (pname) {
    case GL_LIGHT_MODEL_AMBIENT:
        copy(state.model_ambient, params);
        break;
    case GL_LIGHT_MODEL_LOCAL_VIEWER:
        if (!has_local_lights && params.v[0].integer() != 0)
            return refuse_pname(context);
        state.local_viewer = params.v[0].integer() != 0;
        break;
    case GL_LIGHT_MODEL_TWO_SIDE:
        if (!SPANGLE_TWO_SIDES && params.v[0].integer() != 0)
            return refuse_pname(context);
        state.two_side = params.v[0].integer() != 0;
        break;
    case GL_LIGHT_MODEL_COLOR_CONTROL: {
        const GLenum control = params.v[0].token();
        if (control != GL_SINGLE_COLOR && control != GL_SEPARATE_SPECULAR_COLOR)
            return error(context, GL_INVALID_ENUM);
        state.color_control = control;
        break;
    }
    default:
        return error(context, GL_INVALID_ENUM);
    }
    context.changed(dirty_lights);
    context.changed(dirty_fragment); // a separate specular colour needs the colour sum
}

void Material(Context& context, GLenum face, GLenum pname, const Params& params) {
    const unsigned sides = sides_of(face);
    if (sides == 0 || params.count == 0)
        return error(context, GL_INVALID_ENUM);
    if (pname == GL_SHININESS && !in_range(params.v[0].real(), hundred_twenty_eight))
        return error(context, GL_INVALID_VALUE);
    if (!has_specular && pname == GL_SPECULAR && !is_black(params))
        return refuse_pname(context);
    if ((pname == GL_DIFFUSE || pname == GL_AMBIENT_AND_DIFFUSE) && too_bright(params))
        return refuse_pname(context);
    materials_change(context);
    for (unsigned side = 0; side < 2; ++side) {
        if ((sides & (1u << side)) == 0)
            continue;
        const bool both = pname == GL_AMBIENT_AND_DIFFUSE;
        for (const GLenum one :
             {both ? static_cast<GLenum>(GL_AMBIENT) : pname, both ? static_cast<GLenum>(GL_DIFFUSE) : pname})
            if (!is_tracked(context.lighting, side, one))
                set_property(context.lighting.material[side], one, params.v, params.count);
    }
}

void GetMaterial(Context& context, GLenum face, GLenum pname, Params& params) {
    params.count = 0;
    const GLenum property = material_property(pname);
    if ((face != GL_FRONT && face != GL_BACK) || property > material_property(GL_COLOR_INDEXES) ||
        pname == GL_AMBIENT_AND_DIFFUSE)
        return error(context, GL_INVALID_ENUM);
    const gl::Material& m = context.lighting.material[face == GL_BACK ? 1 : 0];
    const unsigned place = material_place[property];
    give(params, reinterpret_cast<const Real*>(&m) + place, material_place[property + 1] - place);
}

void ColorMaterial(Context& context, GLenum face, GLenum mode) {
    const bool known = mode == GL_EMISSION || mode == GL_AMBIENT || mode == GL_DIFFUSE ||
                       mode == GL_SPECULAR || mode == GL_AMBIENT_AND_DIFFUSE;
    if (sides_of(face) == 0 || !known)
        return error(context, GL_INVALID_ENUM);
    context.lighting.color_material_face = face;
    context.lighting.color_material_parameter = mode;
    if (has_color_material && context.lighting.color_material)
        track_color(context);
    context.changed(dirty_materials);
}

} // namespace cmd

} // namespace spangle::gl

#endif
