// Computes the lighting equation in integers (GL 1.3, 2.13.1).
//
// Intensities have 20 fraction bits and a range of 2^11; GL asks for 2^10 before they are clamped. Cosines
// and factors have 30 fraction bits. Sums have 44 fraction bits in 64 bits. Products of a light and a
// material do not depend on the vertex, and are computed when either changes (MaterialProducts).
#pragma once

#include <cstdint>
#include <type_traits>

#include "gl/vertex/fixed_math.hpp"
#include "raster/numeric/block_matrix.hpp"
#include "raster/numeric/matrix_build.hpp"

namespace spangle::gl {

class FixedLighting {
  public:
    struct Input {
        Real normal[3]; ///< the normal as given, in object space
    };

    /// Derives values from state that has changed. `dirty` holds the Dirty bits that were set since the last
    /// call.
    void derive(const Context& context, unsigned dirty);
    /// Makes products with the material invalid. It is called when a material or a tracked colour changes
    /// between Begin and End.
    void materials_changed() { has_material_products_ = false; }

    bool needs_eye() const { return has_local_lights && is_enabled_ && needs_eye_; }
    bool two_sided() const { return SPANGLE_TWO_SIDES && is_enabled_ && has_two_sides_; }
    /// True if the material follows the current colour. Each vertex is then lit as soon as it is given.
    bool tracks_color() const { return has_color_material && tracks_color_; }

    static Input input(const Real (&n)[3]) { return {{n[0], n[1], n[2]}}; }

    /// Sets primary and secondary colour of a vertex. `side` is 0 for the front and 1 for the back. `eye` is
    /// the position in eye space, which matters only if needs_eye().
    SPANGLE_INLINE void light(const Context& context, const Input& vertex, const numeric::Block4& eye,
                              int side, raster::FixedVertex& out) {
        light(context, vertex.normal, eye, side, out);
    }
    /// Lights a vertex given by its normal alone; see the other light().
    SPANGLE_INLINE void light(const Context& context, const Real (&normal)[3], const numeric::Block4& eye,
                              int side, raster::FixedVertex& out) {
        if (!has_material_products_) [[unlikely]]
            fold(context);
        if (!always_has_given_normals &&
            (!material_products_[side].plain ||
             (makes_unit_normals() && !light_with_unit_normal(normal, side, out))))
            light_with_all_terms(normal, eye, side, out);
        else if (!makes_unit_normals())
            light_with_given_normal(normal, side, out);
    }

    /// Mixes the lighting inputs of a and b for the new vertex that clipping makes at t on their edge.
    static void mix(const Input& a, const Input& b, const FixedMath::Parameter& t, Input& out);

  private:
    using Sum = std::int64_t; ///< sum of light contributions, 44 fraction bits

    struct LightSource {
        bool directional = true, spot = false, attenuated = false;
        /// True if the light reaches every vertex from the same direction and with the same strength.
        bool simple() const { return !has_local_lights || (directional && !spot); }
        numeric::Unit3 to_light; ///< directional light: unit vector toward the light
        /// For directional lights: to_light times the normal matrix. Its product with a normal as given is
        /// the cosine in eye space.
        numeric::BlockRow3 facing;
        /// For directional lights and a viewer at infinity: unit half vector.
        numeric::Unit3 half;
        numeric::Block3 position; ///< positional light: position in eye space
        numeric::Unit3 spot_axis;
        std::int32_t spot_cosine = 0; ///< cosine of the cutoff angle, Q0.30
        std::uint32_t spot_exponent;  ///< exponent in the form of numeric::power_exponent()
        numeric::Block attenuation[3];
        std::int32_t ambient[3], diffuse[3], specular[3]; ///< intensities with 20 fraction bits
    };
    /// Products of one side's material with all lights, with 20 fraction bits.
    struct MaterialProducts {
        std::int64_t plain_base[3]; ///< start of a sum of plain lighting: `base` plus half a colour unit
        /// Emission, model ambient, and the ambient terms of lights that are simple().
        std::int32_t base[3];
        std::int32_t ambient[max_lights][3], diffuse[max_lights][3], specular[max_lights][3];
        bool has_specular = false;
        /// True if light i may contribute to the specular sum.
        bool has_specular_of(int i) const {
            const std::int32_t(&s)[3] = specular[i];
            return has_specular && (s[0] | s[1] | s[2]) != 0;
        }
        std::uint32_t shininess; ///< exponent in the form of numeric::power_exponent()
        std::uint32_t alpha;     ///< alpha of the material in colour units
        Real index[3];           ///< ambient, diffuse and specular index, for a colour index framebuffer
        /// True for plain lighting, which has only ambient and diffuse terms, of lights that are simple().
        bool plain = false;
    };
    /// The normal of a vertex in eye space.
    struct Direction {
        std::int32_t m[3];
        int fraction_bits; ///< 30 for unit vectors; 28 (range 8) for other normals
    };

    /// A normal in plain lighting. Its components are m * 2^e, or m * inverse * 2^e if normals are made unit
    /// (NORMALIZE).
    struct PlainNormal {
        /// `inverse` is the mantissa of 1 / |m|.
        std::int32_t m[3], e, inverse;
    };

    bool is_enabled_ = false, needs_eye_ = false, has_two_sides_ = false, tracks_color_ = false,
         has_material_products_ = false;
    bool normalizes_ = false, has_local_viewer_ = false, has_separate_specular_ = false;
    bool all_lights_are_simple_ = false; ///< true if all lights are simple() and the viewer is at infinity
    /// True if all rows of the normal matrix, and therefore their products with a normal, share one exponent.
    bool rows_share_exponent_ = false;
    /// Bits of a colour index. 0: the framebuffer has RGBA colours.
    unsigned index_bits_ = 0;
    int light_count_ = 0; ///< number of enabled lights
    LightSource lights_[max_lights];
    MaterialProducts material_products_[SPANGLE_TWO_SIDES ? 2 : 1];
    std::int32_t model_ambient_[3] = {};
    numeric::BlockMatrix3 normal_matrix_;
    /// True if the normal matrix is kept with all its bits, for lights that change while the modelview matrix
    /// does not. Boards have no RAM for it; there, it is computed again.
    static constexpr bool keeps_normals = numeric::wide_words;
    struct KeptNormals {
        numeric::NormalMatrix normal;
        void keep(const numeric::NormalMatrix& of) { normal = of; }
        const numeric::NormalMatrix& get() const { return normal; }
    };
    struct NoNormals {
        static void keep(const numeric::NormalMatrix&) {}
        static numeric::NormalMatrix get() { return {}; }
    };
    [[no_unique_address]] std::conditional_t<keeps_normals, KeptNormals, NoNormals> kept_normals_;

    /// True if the build has plain lighting only, with normals as given.
    static constexpr bool always_has_given_normals =
        !has_specular && !has_local_lights && !has_full_lighting && !raster::has_indices;
    bool makes_unit_normals() const { return has_full_lighting && normalizes_; }
    bool indexed() const { return raster::has_indices && index_bits_ != 0; }
    void derive_lights(const Context& context);
    void derive_normals(const TransformState& transform);
    /// Derives `facing` of each directional light.
    void face_lights(const numeric::NormalMatrix& normal);
    void derive_source(const Light& light, LightSource& out) const;
    void fold(const Context& context);
    void multiply_material(const Material& material, MaterialProducts& out) const;
    [[gnu::noinline]] void set_index(const MaterialProducts& fold, const Sum (&primary)[3],
                                     const Sum (&specular)[3], raster::FixedVertex& out) const;
    void light_with_all_terms(const Real (&normal)[3], const numeric::Block4& eye, int side,
                              raster::FixedVertex& out) const;
    static void add_factor(const std::int32_t (&diffuse)[3], std::int32_t factor, std::int64_t (&sum)[3]);
    static void set_plain_color(const MaterialProducts& fold, const std::int64_t (&sum)[3],
                                raster::FixedVertex& out);
    SPANGLE_INLINE static std::int32_t facing(const LightSource& source, const PlainNormal& n, bool unit,
                                              int side);
    void add_plain_light(int side, raster::FixedVertex& out, const PlainNormal& n, bool unit) const;
    void light_with_given_normal(const Real (&normal)[3], int side, raster::FixedVertex& out) const;
    bool light_with_unit_normal(const Real (&normal)[3], int side, raster::FixedVertex& out) const;
    Direction direction_of(const Real (&normal)[3], int side) const;
    void add_directional(const LightSource& source, const MaterialProducts& fold, int i, const Direction& n,
                         Sum (&primary)[3], Sum (&specular)[3]) const;
    void add_general(const LightSource& source, const MaterialProducts& fold, int i,
                     const numeric::Block3& to_eye, const Direction& n, Sum (&primary)[3],
                     Sum (&specular)[3]) const;
};

} // namespace spangle::gl
