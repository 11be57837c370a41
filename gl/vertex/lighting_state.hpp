// State of lights, materials, the light model and ColorMaterial (GL 1.3, 2.13).
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

// Initial values of materials and of the light model (GL 1.3, tables 6.11 to 6.13).
inline constexpr Real one_fifth = numeric::from_float(0.2f), four_fifths = numeric::from_float(0.8f);
/// Spot cutoff, in degrees, of a light that shines in all directions.
inline constexpr Real no_spot_cutoff = numeric::from_i32(180);

struct Light {
    Real ambient[4] = {numeric::zero, numeric::zero, numeric::zero, numeric::one};
    Real diffuse[4] = {numeric::zero, numeric::zero, numeric::zero, numeric::one};
    Real specular[4] = {numeric::zero, numeric::zero, numeric::zero, numeric::one};
    Real position[4] = {numeric::zero, numeric::zero, numeric::one, numeric::zero}; ///< position in eye space
    /// Direction in eye space.
    Real spot_direction[3] = {numeric::zero, numeric::zero, -numeric::one};
    Real spot_exponent = numeric::zero;
    Real spot_cutoff = no_spot_cutoff;
    Real attenuation[3] = {numeric::one, numeric::zero, numeric::zero};
};

struct Material {
    Real ambient[4] = {one_fifth, one_fifth, one_fifth, numeric::one};
    Real diffuse[4] = {four_fifths, four_fifths, four_fifths, numeric::one};
    Real specular[4] = {numeric::zero, numeric::zero, numeric::zero, numeric::one};
    Real emission[4] = {numeric::zero, numeric::zero, numeric::zero, numeric::one};
    Real shininess = numeric::zero;
    Real indexes[3] = {numeric::zero, numeric::one, numeric::one}; ///< ambient, diffuse and specular index
};

#if SPANGLE_FEATURE_LIGHTING
struct LightingState {
    constexpr LightingState() {
        for (int c = 0; c < 3; ++c)
            light[0].diffuse[c] = light[0].specular[c] = numeric::one;
    }

    bool lighting = false;
    bool light_enabled[max_lights] = {};
    bool color_material = false;
    GLenum color_material_face = GL_FRONT_AND_BACK;
    GLenum color_material_parameter = GL_AMBIENT_AND_DIFFUSE;
    Real model_ambient[4] = {one_fifth, one_fifth, one_fifth, numeric::one};
    bool local_viewer = false;
    bool two_side = false;
    GLenum color_control = GL_SINGLE_COLOR;
    bool color_sum = false; ///< COLOR_SUM: secondary colours are added even without lighting
    Light light[max_lights];
    Material material[2]; ///< materials of front and back
};
#else
struct LightingState {
    static constexpr bool lighting = false, color_material = false;
    bool color_sum = false;
    static constexpr GLenum color_control = GL_SINGLE_COLOR;
};
#endif

/// True if a secondary colour is added to fragments. With lighting it is the specular colour, which may be
/// zero, and without lighting that of the vertices (GL 1.4, 3.9).
inline bool sums_colors(const LightingState& state) {
    return state.lighting ? state.color_control == GL_SEPARATE_SPECULAR_COLOR : state.color_sum;
}

} // namespace spangle::gl
