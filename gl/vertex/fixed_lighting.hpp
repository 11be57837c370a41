// The lighting equation in integers (GL 1.3, 2.13.1).
//
// Intensities have 20 fraction bits (range 2^11; the spec asks 2^10 before the clamp), cosines and factors
// 30, sums 44 in 64 bits. What does not depend on the vertex is folded when lights or materials change.
#pragma once

#include <cstdint>

#include "gl/vertex/fixed_math.hpp"
#include "raster/numeric/block_matrix.hpp"
#include "raster/numeric/matrix_build.hpp"

namespace spangle::gl {

class FixedLighting {
  public:
    struct Input {
        Real normal[3]; ///< as given, in object space
    };

    /// `dirty`: the Dirty bits of what changed since the last time.
    void derive(const Context& context, unsigned dirty);
    /// A material or a tracked colour changed between Begin and End.
    void materials_changed() { folded_ = false; }

    bool needs_eye() const { return has_local_lights && on_ && needs_eye_; }
    bool two_sided() const { return SPANGLE_TWO_SIDES && on_ && two_side_; }
    /// The material follows the current colour: every vertex is lit when it is given.
    bool tracks_color() const { return has_color_material && tracks_color_; }

    static Input input(const Real (&n)[3]) { return {{n[0], n[1], n[2]}}; }

    /// Primary and secondary colour of a vertex; side 0 is the front, 1 the back. `eye`, its
    /// position, only matters while needs_eye().
    SPANGLE_INLINE void light(const Context& context, const Input& vertex, const numeric::Block4& eye,
                              int side, raster::FixedVertex& out) {
        light(context, vertex.normal, eye, side, out);
    }
    /// The same of a normal where it lies.
    SPANGLE_INLINE void light(const Context& context, const Real (&normal)[3], const numeric::Block4& eye,
                              int side, raster::FixedVertex& out) {
        if (!folded_) [[unlikely]]
            fold(context);
        if (!always_given && (!fold_[side].plain || (normalizes() && !light_unit(normal, side, out))))
            light_fully(normal, eye, side, out);
        else if (!normalizes())
            light_given(normal, side, out);
    }

    /// A vertex made by clipping.
    static void mix(const Input& a, const Input& b, const FixedMath::Parameter& t, Input& out);

  private:
    using Sum = std::int64_t; ///< 44 fraction bits

    struct Source {
        bool directional = true, spot = false, attenuated = false;
        /// Reaches every vertex alike.
        bool simple() const { return !has_local_lights || (directional && !spot); }
        numeric::Unit3 to_light;   ///< directional: unit vector to the light
        numeric::BlockRow3 facing; ///< directional: to_light times the normal matrix, for normals as given
        numeric::Unit3 half;       ///< directional, viewer at infinity: unit half vector
        numeric::Block3 position;  ///< positional, eye space
        numeric::Unit3 spot_axis;
        std::int32_t spot_cosine = 0; ///< of the cutoff, Q0.30
        std::uint32_t spot_exponent;  ///< as numeric::power_exponent() gives it
        numeric::Block attenuation[3];
        std::int32_t ambient[3], diffuse[3], specular[3]; ///< 20 fraction bits
    };
    /// Products of one side's material with every light.
    struct Fold {
        std::int64_t
            plain_base[3];    ///< base as sums of plain lighting have it, and half a unit of their colours
        std::int32_t base[3]; ///< emission, model ambient and the ambient light that is not attenuated
        std::int32_t ambient[max_lights][3], diffuse[max_lights][3], specular[max_lights][3];
        bool has_specular = false;
        /// Light i may add to the specular sum.
        bool shines(int i) const {
            const std::int32_t(&s)[3] = specular[i];
            return has_specular && (!raster::has_shortcuts || (s[0] | s[1] | s[2]) != 0);
        }
        std::uint32_t shininess; ///< as numeric::power_exponent() gives it
        std::uint32_t alpha;     ///< colour units
        Real index[3];           ///< of an index framebuffer: ambient, diffuse, specular
        bool plain = false;      ///< only ambient and diffuse terms of lights that reach every vertex alike
    };
    /// The normal of a vertex in eye space.
    struct Direction {
        std::int32_t m[3];
        int fraction_bits; ///< 30 for unit vectors, 28 (range 8) for what GL leaves unnormalised
    };

    /// A normal of plain lighting, and what its products are multiplied with.
    struct PlainNormal {
        std::int32_t m[3], e, inverse; ///< 1 / its length, where normals are unit
    };

    bool on_ = false, needs_eye_ = false, two_side_ = false, tracks_color_ = false, folded_ = false;
    bool normalize_ = false, local_viewer_ = false, separate_ = false;
    bool all_simple_ = false;  ///< no light asks where the vertex is
    bool common_rows_ = false; ///< of the normal matrix: their results have one exponent
    unsigned index_bits_ = 0;  ///< of an index framebuffer; 0: colours
    int count_ = 0;            ///< enabled lights
    Source source_[max_lights];
    Fold fold_[SPANGLE_TWO_SIDES ? 2 : 1];
    std::int32_t model_ambient_[3] = {};
    numeric::BlockMatrix3 normal_matrix_;

    /// All light is plain, and normals are as they are given.
    static constexpr bool always_given =
        !has_specular && !has_local_lights && !has_full_lighting && !raster::has_indices;
    bool normalizes() const { return has_full_lighting && normalize_; }
    bool indexed() const { return raster::has_indices && index_bits_ != 0; }
    void derive_lights(const Context& context);
    void derive_normals(const TransformState& transform);
    void derive_source(const Light& light, Source& out) const;
    void fold(const Context& context);
    void fold_side(const Material& material, Fold& out) const;
    [[gnu::noinline]] void set_index(const Fold& fold, const Sum (&primary)[3], const Sum (&specular)[3],
                                     raster::FixedVertex& out) const;
    void light_fully(const Real (&normal)[3], const numeric::Block4& eye, int side,
                     raster::FixedVertex& out) const;
    static void add_factor(const std::int32_t (&diffuse)[3], std::int32_t factor, std::int64_t (&sum)[3]);
    static void set_plain(const Fold& fold, const std::int64_t (&sum)[3], raster::FixedVertex& out);
    SPANGLE_INLINE static std::int32_t facing(const Source& source, const PlainNormal& n, bool unit,
                                              int side);
    void add_plain(int side, raster::FixedVertex& out, const PlainNormal& n, bool unit) const;
    void light_given(const Real (&normal)[3], int side, raster::FixedVertex& out) const;
    bool light_unit(const Real (&normal)[3], int side, raster::FixedVertex& out) const;
    Direction direction_of(const Real (&normal)[3], int side) const;
    void add_directional(const Source& source, const Fold& fold, int i, const Direction& n, Sum (&primary)[3],
                         Sum (&specular)[3]) const;
    void add_general(const Source& source, const Fold& fold, int i, const numeric::Block3& to_eye,
                     const Direction& n, Sum (&primary)[3], Sum (&specular)[3]) const;
};

} // namespace spangle::gl
