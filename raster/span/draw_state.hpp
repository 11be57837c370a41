// A DrawState holds everything that turns a primitive into pixels. It is immutable once compiled. GL compiles
// one when its state has changed, and hands it to draw_triangle, draw_line and draw_point with each
// primitive.
#pragma once

#include <cstdint>

#include "raster/span/color_steps.hpp"
#include "raster/span/fused_keys.hpp"
#include "raster/span/key.hpp"
#include "raster/span/primitive_state.hpp"
#include "raster/span/span.hpp"
#include "raster/surface/surface.hpp"
#include <spangle/raster/fragment_state.hpp>

namespace spangle::raster {

#ifndef SPANGLE_FIRMWARE
/// Is told what is covered, for reports. All coordinates are window coordinates; each function may be null.
struct Observer {
    /// Called before the spans of a triangle: gets the snapped vertices (n.8), and the vertices before
    /// snapping if the policy knows them (else null).
    void (*triangle)(Observer&, const std::int32_t x[3], const std::int32_t y[3], const double exact_x[3],
                     const double exact_y[3], Rect scissor) = nullptr;
    /// Called before the spans of a line or a point.
    void (*other)(Observer&) = nullptr;
    /// Called for each span about to be drawn, of any primitive: columns [begin, end) of row y.
    void (*span)(Observer&, std::int32_t y, std::int32_t begin, std::int32_t end) = nullptr;
};
#endif

/// Counts what was drawn, for whoever asks. The counts wrap.
struct Counters {
    std::uint32_t triangles = 0; ///< triangles, lines and points that reached a pixel
    std::uint32_t fragments = 0; ///< fragments inside the scissor rectangle
    std::uint32_t passed = 0;    ///< fragments past all tests; counted where FragmentState::count is set
#ifndef SPANGLE_FIRMWARE
    Observer* observer = nullptr;
#endif
};

struct Tile;
struct Trapezoids;
/// Functions that draw triangles at once instead of as rows, with the planes of the span (tile.hpp,
/// trapezoids.hpp).
struct Shapes {
    void (*tile)(Span<Fixed>&, const Tile&); ///< null: no tiles are drawn
    void (*trapezoids)(Span<Fixed>&, const Trapezoids&);
};

/// A function of any signature: RowsFunction<P> to draw rows, PathFunction to draw paths, void(Packet<N>&,
/// const Span<P>&) for a stage of the chain. The code that stores it and the code that calls it agree on P
/// and N.
using AnyFunction = void (*)();

/// The most stages of a chain: stipple, test of depth and stencil, count, colour; for each unit two stages of
/// its coordinates and one of its texture; the colour sum and two stages of fog, or three stages of fog;
/// coverage, alpha test, blending, store (assemble.hpp).
inline constexpr int max_stages = (SPANGLE_FEATURE_STIPPLE ? 1 : 0) + (depth_formats > 1 ? 1 : 0) + 2 +
                                  (has_textures ? 3 * max_texture_units : 0) +
                                  (has_fog         ? 3
                                   : has_color_sum ? 1
                                                   : 0) +
                                  (SPANGLE_FEATURE_ANTIALIASING ? 1 : 0) + (has_samples ? 1 : 0) + 3;

/// The functions that draw one kind of primitive.
struct Variant {
    AnyFunction run = nullptr;      ///< a RowsFunction: a fused span, or the runner of `chain`
    AnyFunction walk = nullptr;     ///< a PathFunction; null: paths are drawn as rows
    const Shapes* shapes = nullptr; ///< null: all triangles are drawn as rows
    AnyFunction chain[has_chain ? max_stages + 1 : 1] = {}; ///< stages; the last is followed by null
    Flag<spans_by_gray> gray = false;                       ///< `run` reads Span::gray
    bool steps = false;  ///< affine colours count steps of 5, 6 and 5 bits; a step is 2^27, 2^26 or 2^27
    bool shares = false; ///< `chain` can draw fragments of several rows at once (shared_rows.hpp)
    std::uint32_t color_bias = 0; ///< what set-up adds to affine colours (8.24) so that they round
};

/// The attributes that set-up interpolates: only those that some stage reads.
struct Needs {
    Flag<spans_with_depth> z = false;
    Flag<spans_with_color> rgb = false;
    Flag<spans_with_alpha> alpha = false;
    Flag<spans_with_sum> secondary = false;
    bool fog = false;
    bool unit[max_texture_units] = {};
    bool r[max_texture_units] = {}; ///< for units that are on: the third coordinate is interpolated, too
    Flag<Among{spans_sample_any, false}> lod[max_texture_units] =
        {}; ///< for units that are on: slopes of coordinates are needed
    bool any_unit() const {
        bool any = false;
        for (const bool on : unit)
            any = any || on;
        return any;
    }
};

constexpr Needs needs_of(const Key& key) {
    Needs needs;
    needs.z = needs_depth(key);
    needs.rgb = key.color;
    needs.alpha = key.color_alpha;
    needs.secondary = key.color_sum;
    needs.fog = key.fog;
    for (int i = 0; i < max_texture_units; ++i)
        needs.unit[i] = key.unit[i].on;
    return needs;
}

/// The constants that make the fog coordinate c of a vertex at eye distance d, as a number with 24 fraction
/// bits: c = offset + d * scale * 2^scale_exponent. The fog stage makes the factor f of c:
///   LINEAR: c = (end - d) / (end - start), f = c;
///   EXP: c = density d log2 e, f = 2^-c;
///   EXP2: c = density d sqrt(log2 e), f = 2^-(c c).
struct FogConstants {
    std::int32_t scale = 0;
    std::int32_t scale_exponent = 0;
    std::int64_t offset = 0;
};

/// A tolerance of colours that allows any error: colours are always affine then.
inline constexpr std::uint32_t any_color_tolerance = UINT32_MAX;

struct Recorder; // defined in raster/primitive/keep.hpp

struct DrawState {
    [[gnu::noinline]] DrawState() = default; ///< not inline, because it is long

    FragmentState fragment; ///< the state as GL gave it; its texture pointers must stay valid
    FogConstants fog;
    Needs needs;
    /// Some attribute is neither a colour nor a depth.
    Flag<spans_with_coordinates> textured_or_fogged = false;
    bool smooth_rgb = false; ///< the only attributes are smooth red, green and blue, and depth
    bool shapes = false;     ///< some variant draws shapes (Shapes)
    bool tiles = false;      ///< some variant draws tiles
    bool pixels = false;     ///< colours come with the fragments, as four components in colour units
    bool words = false;   ///< with `pixels`: they come as the R5 G6 B5 words that are stored, in host order
    bool guesses = false; ///< colours of Kind::full may be guessed (Span::guess)
    Tier tier = Tier::exact;
#if SPANGLE_OWN_TIERS
    Knobs knobs{}; ///< knobs of the draw's tier, as far as its format leaves them
#endif
    StepFactors step_factors{}; ///< for affine colours that count steps (Variant::steps)
    /// Four times what affine colours may be off by, in colour units.
    std::uint32_t four_color_tolerances = 0;
    PixelFormat format{};
    DepthFormat depth_format{};
    /// Bytes of a pixel; 0: a narrow format, whose stages find a pixel by its column.
    std::uint8_t color_bytes = 0;
    std::uint8_t depth_bytes = 0; ///< bytes of a depth value; 0: depth is not used
    /// True where a coordinate repeats, which decides the form of texture coordinates (number.hpp,
    /// TexCoords).
    struct Wraps {
        Flag<Among{true, !spans_sample_any}> s = true, t = true;
    } wraps[max_texture_units];
    /// True for MIRRORED_REPEAT: set-up counts in two repeats, so that the word wraps as the texture does.
    struct Halves {
        Flag<Among{spans_sample_any, false}> s = false, t = false;
    } halves[max_texture_units];
    /// log2 of the texels around which a coordinate wraps, rounded up: two images where the coordinate is
    /// halved.
    std::uint8_t log2_width[max_texture_units] = {}, log2_height[max_texture_units] = {};
    Counters* counters = nullptr; ///< may be null, but not where FragmentState::count is set
    /// Not null where the fragment state has coverage, a polygon stipple, a depth offset, or modes of
    /// samples.
    const PrimitiveState* primitive = nullptr;
    Variant variant[kind_count];
    /// Lines of width 1 with both ends inside of this area may be drawn as paths.
    struct Area {
        std::int32_t x = 0, y = 0; ///< subpixels, as are w and h
        std::uint32_t w = 0, h = 0;
        bool holds(std::int32_t px, std::int32_t py) const {
            return static_cast<std::uint32_t>(px - x) < w && static_cast<std::uint32_t>(py - y) < h;
        }
    } paths;
#if !SPANGLE_CHAIN
    bool lacks_span = false; ///< some kind of primitive has no span; nothing is drawn then
#endif
    /// No primitive can be drawn (depth NEVER, no colour and no depth or stencil written, empty scissor), or
    /// none is drawn here and now (Recorder).
    bool nothing = false;
#if SPANGLE_FEATURE_BANDS
    /// Is told of every primitive. `nothing` is set then, so that drawing asks for this pointer only where
    /// `nothing` is set.
    Recorder* recorder = nullptr;
    bool draws_too = false; ///< the surface gets the recorded primitives as well
#endif
};

/// V is the vertex type of the policy. The fixed one is compiled into firmware, the others on hosts only.
template <class V> void compile(const FragmentState& fragment, const Surface& target, DrawState& out);
template <class V> DrawState compile(const FragmentState& fragment, const Surface& target) {
    DrawState draw;
    compile<V>(fragment, target, draw);
    return draw;
}

/// Sets all of a DrawState but its variants, which begin empty. It is the same in every policy, and the
/// former contents of `draw` do not matter. Returns key_of_any_kind().
Key prepare(DrawState& draw, const FragmentState& fragment, const Surface& target);

/// Follows a change of the scissor rectangle in the fragment state of `draw`: finds `paths` again.
void scissor_changed(DrawState& draw, const Surface& target);

/// The function that runs the chain of a number system of the fixed policy along rows; `narrow`: on a narrow
/// surface.
AnyFunction chain_runner(Number number, bool narrow = false);

/// The part of a state's key that the keys of all kinds have in common.
Key key_of_any_kind(const FragmentState& fragment, const Surface& target);
/// The key of one kind, made from key_of_any_kind().
Key key_of_kind(const Key& any, const FragmentState& fragment, Kind kind);
/// The key of one kind, by which `compile` looks up fused spans.
inline Key make_key(const FragmentState& fragment, const Surface& target, Kind kind) {
    return key_of_kind(key_of_any_kind(fragment, target), fragment, kind);
}

} // namespace spangle::raster
