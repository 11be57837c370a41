// A DrawState holds all data and functions that turn a primitive into pixels. It is immutable once compiled.
// GL compiles one when its state has changed. It passes the DrawState to draw_triangle, draw_line and
// draw_point with each primitive.
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
/// Is told which pixels are covered, for reports. All coordinates are window coordinates. Each function may
/// be null.
struct Observer {
    /// Called before the spans of a triangle. It gets the snapped vertices (n.8). It gets the vertices before
    /// snapping, too, if the policy knows them; else null.
    void (*triangle)(Observer&, const std::int32_t x[3], const std::int32_t y[3], const double exact_x[3],
                     const double exact_y[3], Rect scissor) = nullptr;
    /// Called before the spans of a line or a point.
    void (*other)(Observer&) = nullptr;
    /// Called for each span about to be drawn, of any primitive: columns [begin, end) of row y.
    void (*span)(Observer&, std::int32_t y, std::int32_t begin, std::int32_t end) = nullptr;
};
#endif

/// Counts what was drawn, for queries and reports. The counts wrap.
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
/// Functions that draw whole triangles instead of rows, with the planes of the span (tile.hpp,
/// trapezoids.hpp).
struct Shapes {
    void (*tile)(Span<Fixed>&, const Tile&); ///< null: tiles are not drawn
    void (*trapezoids)(Span<Fixed>&, const Trapezoids&);
};

/// A function of any signature. It is a RowsFunction<P>, which draws rows, a PathFunction, which draws paths,
/// or a stage of the chain. The stage has the type void(Packet<N>&, const Span<P>&). The code that stores the
/// function and the code that calls it agree on P and N.
using AnyFunction = void (*)();

/// The largest number of stages of a chain (assemble.hpp). The chain has these stages:
/// - stipple; test of depth and stencil; count; colour;
/// - for each unit two stages of coordinates and one stage of the texture;
/// - the colour sum and two stages of fog, or three stages of fog;
/// - coverage, alpha test, blending, store.
inline constexpr int max_stages = (SPANGLE_FEATURE_STIPPLE ? 1 : 0) + (depth_formats > 1 ? 1 : 0) + 2 +
                                  (has_textures ? 3 * max_texture_units : 0) +
                                  (has_fog         ? 3
                                   : has_color_sum ? 1
                                                   : 0) +
                                  (SPANGLE_FEATURE_ANTIALIASING ? 1 : 0) + (has_samples ? 1 : 0) + 3;

/// The functions that draw one kind of primitive.
struct Variant {
    AnyFunction run = nullptr;      ///< a RowsFunction: a fused span, or the function that runs `chain`
    AnyFunction walk = nullptr;     ///< a PathFunction; null where paths are drawn as rows
    const Shapes* shapes = nullptr; ///< null where all triangles are drawn as rows
    AnyFunction chain[has_chain ? max_stages + 1 : 1] = {}; ///< stages; the last is followed by null
    Flag<spans_by_gray> gray = false;                       ///< `run` reads Span::gray
    /// Affine colours count steps of 5, 6 and 5 bits; one step is 2^27, 2^26 and 2^27.
    bool steps = false;
    bool shares = false; ///< `chain` can draw fragments of several rows in one packet (shared_rows.hpp)
    std::uint32_t color_bias = 0; ///< what set-up adds to affine colours (8.24), so that they round
};

/// The attributes that set-up interpolates. They are only those that a stage reads.
struct Needs {
    Flag<spans_with_depth> z = false;
    Flag<spans_with_color> rgb = false;
    Flag<spans_with_alpha> alpha = false;
    Flag<spans_with_sum> secondary = false;
    bool fog = false;
    bool unit[max_texture_units] = {};
    bool r[max_texture_units] = {}; ///< for units that are on: the third coordinate is interpolated
    /// For units that are on: levels of detail need the slopes of coordinates.
    Flag<Among{spans_sample_any, false}> lod[max_texture_units] = {};
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

/// The constants that make the fog coordinate c of a vertex from its eye distance d. c has 24 fraction bits:
/// c = offset + d * scale * 2^scale_exponent. The fog stage makes the factor f from c:
/// - LINEAR: c = (end - d) / (end - start), f = c;
/// - EXP: c = density d log2 e, f = 2^-c;
/// - EXP2: c = density d sqrt(log2 e), f = 2^-(c c).
struct FogConstants {
    std::int32_t scale = 0;
    std::int32_t scale_exponent = 0;
    std::int64_t offset = 0;
};

/// A tolerance of colours that allows any error, so that colours are always affine.
inline constexpr std::uint32_t any_color_tolerance = UINT32_MAX;

struct Recorder; // defined in raster/primitive/keep.hpp

struct DrawState {
    [[gnu::noinline]] DrawState() = default; ///< not inline, because the code is long

    FragmentState fragment; ///< the state as GL gave it; its texture pointers must stay valid
    FogConstants fog;
    Needs needs;
    /// At least one attribute is neither a colour nor a depth.
    Flag<spans_with_coordinates> textured_or_fogged = false;
    bool smooth_rgb = false; ///< the only attributes are depth and smooth red, green and blue
    bool shapes = false;     ///< at least one variant draws shapes (Shapes)
    bool tiles = false;      ///< at least one variant draws tiles
    bool pixels = false;     ///< colours come with the fragments, as four components in colour units
    bool words = false;      ///< with `pixels`: colours are the R5 G6 B5 words that are stored, in host order
    bool guesses = false;    ///< colours of Kind::full may be guessed (Span::guess)
    Tier tier = Tier::exact;
#if SPANGLE_OWN_TIERS
    Knobs knobs{}; ///< knobs of the draw's tier, as far as its format allows them
#endif
    StepFactors step_factors{}; ///< factors of affine colours that count steps (Variant::steps)
    /// Four times the allowed error of affine colours, in colour units.
    std::uint32_t four_color_tolerances = 0;
    PixelFormat format{};
    DepthFormat depth_format{};
    /// Bytes of a pixel. 0 stands for a narrow format, whose stages find a pixel by its column.
    std::uint8_t color_bytes = 0;
    std::uint8_t depth_bytes = 0; ///< bytes of a depth value; 0 where depth is not used
    /// True where a coordinate repeats. This decides the form of texture coordinates (TexCoords, number.hpp).
    struct Wraps {
        Flag<Among{true, !spans_sample_any}> s = true, t = true;
    } wraps[max_texture_units];
    /// True for MIRRORED_REPEAT. Set-up then counts in two repeats, so that the word wraps as the texture
    /// does.
    struct Halves {
        Flag<Among{spans_sample_any, false}> s = false, t = false;
    } halves[max_texture_units];
    /// The base-2 logarithms, rounded up, of the width and height in texels after which coordinates wrap:
    /// those of the image, or of two images where `halves` is set.
    std::uint8_t log2_width[max_texture_units] = {}, log2_height[max_texture_units] = {};
    /// Null if nothing is counted; never null where FragmentState::count is set.
    Counters* counters = nullptr;
    /// Not null where the fragment state has coverage, a polygon stipple, a depth offset, or modes of
    /// multisampling.
    const PrimitiveState* primitive = nullptr;
    Variant variant[kind_count];
    /// Lines of width 1 with both ends inside of this area may be drawn as paths.
    struct Area {
        std::int32_t x = 0, y = 0; ///< lowest corner in subpixels; w and h are the size
        std::uint32_t w = 0, h = 0;
        bool holds(std::int32_t px, std::int32_t py) const {
            return static_cast<std::uint32_t>(px - x) < w && static_cast<std::uint32_t>(py - y) < h;
        }
    } paths;
#if !SPANGLE_CHAIN
    bool lacks_span = false; ///< at least one kind of primitive has no span; nothing is drawn then
#endif
    /// No primitive can be drawn: depth NEVER, nothing is written, or the scissor rectangle is empty.
    /// Primitives that a Recorder gets are not drawn here, either.
    bool nothing = false;
#if SPANGLE_FEATURE_BANDS
    /// Is told of every primitive. `nothing` is set then, so drawing looks at this pointer only where
    /// `nothing` is set.
    Recorder* recorder = nullptr;
    bool draws_too = false; ///< primitives that are recorded are drawn to the surface, too
#endif
};

/// Compiles a state. V is the vertex type of the policy. Firmware has the fixed policy alone; the others
/// exist on hosts only.
template <class V> void compile(const FragmentState& fragment, const Surface& target, DrawState& out);
template <class V> DrawState compile(const FragmentState& fragment, const Surface& target) {
    DrawState draw;
    compile<V>(fragment, target, draw);
    return draw;
}

/// Sets all members of `draw` except its variants, which become empty. The function is the same in every
/// policy. The former contents of `draw` do not matter. Returns key_of_any_kind().
Key prepare(DrawState& draw, const FragmentState& fragment, const Surface& target);

/// Follows a change of the scissor rectangle in the fragment state of `draw`, and finds `paths` again.
void scissor_changed(DrawState& draw, const Surface& target);

/// The function that runs the chain of a number system of the fixed policy along rows. `narrow` says that the
/// surface has a narrow format.
AnyFunction chain_runner(Number number, bool narrow = false);

/// The parts of a state's key that are the same for all kinds.
Key key_of_any_kind(const FragmentState& fragment, const Surface& target);
/// The key of one kind, made from key_of_any_kind().
Key key_of_kind(const Key& any, const FragmentState& fragment, Kind kind);
/// The key of one kind, by which compile() looks up fused spans.
inline Key make_key(const FragmentState& fragment, const Surface& target, Kind kind) {
    return key_of_kind(key_of_any_kind(fragment, target), fragment, kind);
}

} // namespace spangle::raster
