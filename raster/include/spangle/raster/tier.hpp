// The accuracy [tiers](docs/glossary.md#tier), and the [knobs](docs/glossary.md#knob) that each of them sets
// (docs/architecture/fragments.md, "Tiers"). A tier never changes coverage or depth.
#pragma once

#include <cstdint>

#include <spangle/raster/limits.hpp>

/// Host builds also draw in tiers that a program composes. Only CMake defines this, for the library and for
/// its users.
#ifndef SPANGLE_OWN_TIERS
#define SPANGLE_OWN_TIERS 0
#endif
/// State keys name the runs of coordinates where they may be those of another tier than the number system
/// (has_mixed_runs).
#if SPANGLE_OWN_TIERS || defined(SPANGLE_KNOBS)
/// Whether state keys name the runs of coordinates.
#define SPANGLE_MIXES_RUNS 1
#else
#define SPANGLE_MIXES_RUNS 0
#endif

namespace spangle::raster {

static_assert(!SPANGLE_OWN_TIERS || (tiers == 7 && has_chain), "some tiers have no code in this build");

/// How accurate a draw is.
enum class Tier : std::uint8_t { exact, balanced, fast };

/// Whether this build has the code of a tier.
constexpr bool has_tier(Tier tier) {
    return (tiers >> static_cast<unsigned>(tier) & 1) != 0;
}
/// The tier of a draw; a constant in a build that has only one.
constexpr Tier drawn(Tier tier) {
    return one_of(tiers, tier);
}

/// How texture coordinates are interpolated between two divisions.
enum class Runs : std::uint8_t { straight, cubic };

/// Everything that makes a tier. Bounds are exponents: n stands for 2^-n.
struct Knobs {
    /// Fraction bits of 255ths that colours are combined in: 20, or 8 in words of 16 bits.
    std::uint8_t color_bits;
    /// Blending with SRC_ALPHA, ONE_MINUS_SRC_ALPHA into 565 counts colours in steps of the target, and alpha
    /// in 32nds. Colours of 20 bits are never blended in this way.
    bool coarse_blend;
    /// Dithered colours are counted in exact steps of the target; else a step may be a 290th too large.
    bool exact_steps;
    /// Attributes go through the vertices as they were before they were snapped to 1/256 pixel.
    bool unsnapped;
    /// The form of runs.
    Runs runs;
    /// Between two divisions coordinates are off by 2^-n texel of the base level at most: 0 to 13. Runs of
    /// the shortest length may exceed this bound, because they are never divided further.
    std::uint8_t texel_bits;
    /// Straight runs have at least 2^n pixels: 0 to 6.
    std::uint8_t shortest_run;
    /// Runs have at most 2^n pixels: cubic ones up to 4; straight ones up to 6, and where the texture repeats
    /// up to 16. A row that is within the error as a whole is one run.
    std::uint8_t longest_run;
    /// Coordinates are affine over a primitive where they are off by 2^-n texel at most: 2 to 13, or `never`.
    std::uint8_t affine_texel_bits;
    /// Colours are affine over a primitive where they are off by 2^-n of full scale at most: 2 to 24, 0 for
    /// always, or `never`.
    std::uint8_t affine_color_bits;
    /// Colours are also affine where they are off by 2^-n step of the target, of 8 bits or of 6: 0 to 20, or
    /// `never`.
    std::uint8_t affine_step_bits;
    /// Fog is affine over a primitive where its factor is off by 2^-n at most: 2 to 24, or 0 for always.
    std::uint8_t affine_fog_bits;

    /// The value of a bound `affine_...` that keeps attributes from ever being affine.
    static constexpr std::uint8_t never = 255;
    friend constexpr bool operator==(const Knobs&, const Knobs&) = default;
};

/// The knobs of Tier::exact.
inline constexpr Knobs exact_knobs = {
    .color_bits = 20,
    .coarse_blend = false,
    .exact_steps = true,
    .unsnapped = true,
    .runs = Runs::cubic,
    .texel_bits = 13, // NEAREST itself is defined to within 2^-13 texel
    .shortest_run = 0,
    .longest_run = 4,
    .affine_texel_bits = Knobs::never,
    .affine_color_bits = 19,
    .affine_step_bits = Knobs::never,
    .affine_fog_bits = 21,
};
/// The knobs of Tier::balanced.
inline constexpr Knobs balanced_knobs = {
    .color_bits = 8,
    .coarse_blend = false,
    .exact_steps = false,
    .unsnapped = false,
    .runs = Runs::straight,
    .texel_bits = 2,
    .shortest_run = 0,
    .longest_run = 6,
    .affine_texel_bits = 2,
    .affine_color_bits = Knobs::never,
    .affine_step_bits = 2,
    .affine_fog_bits = 9,
};
/// The knobs of Tier::fast.
inline constexpr Knobs fast_knobs = {
    .color_bits = 8,
    .coarse_blend = true,
    .exact_steps = false,
    .unsnapped = false,
    .runs = Runs::straight,
    .texel_bits = 1,
    .shortest_run = 4,
    .longest_run = 16,
    .affine_texel_bits = 2,
    .affine_color_bits = 4, // an error of 2^-4 everywhere is 24 dB, and the tier promises 22
    .affine_step_bits = Knobs::never,
    .affine_fog_bits = 4,
};

/// The knobs of a tier.
constexpr const Knobs& knobs_of(Tier tier) {
    return tier == Tier::exact ? exact_knobs : tier == Tier::fast ? fast_knobs : balanced_knobs;
}

/// Whether every field is within its range.
constexpr bool are_valid(const Knobs& k) {
    const auto among = [](std::uint8_t v, int least, int most) { return v >= least && v <= most; };
    return (k.color_bits == 8 || k.color_bits == 20) && k.texel_bits <= 13 && k.shortest_run <= 6 &&
           k.longest_run <= 16 && k.shortest_run <= k.longest_run &&
           (k.affine_texel_bits == Knobs::never || among(k.affine_texel_bits, 2, 13)) &&
           (k.affine_color_bits == 0 || k.affine_color_bits == Knobs::never ||
            among(k.affine_color_bits, 2, 24)) &&
           (k.affine_step_bits == Knobs::never || k.affine_step_bits <= 20) &&
           (k.affine_fog_bits == 0 || among(k.affine_fog_bits, 2, 24));
}
static_assert(are_valid(exact_knobs) && are_valid(balanced_knobs) && are_valid(fast_knobs));

/// Firmware may draw in one tier that its user composed. SPANGLE_KNOBS gives every field its value; then all
/// knobs are constants, whatever tier a config or a hint asks for. `./dev firmware --tier` sets it.
#ifdef SPANGLE_KNOBS
/// Whether SPANGLE_KNOBS gives the knobs.
inline constexpr bool has_given_knobs = true;
/// The knobs of SPANGLE_KNOBS.
inline constexpr Knobs given_knobs = {SPANGLE_KNOBS};
#else
/// Whether SPANGLE_KNOBS gives the knobs.
inline constexpr bool has_given_knobs = false;
/// The knobs of SPANGLE_KNOBS, where they are given.
inline constexpr Knobs given_knobs = exact_knobs;
#endif

/// The tiers whose code draws with these knobs, as SPANGLE_TIER_SET has them.
constexpr unsigned tiers_for(const Knobs& k) {
    const bool exact = k.color_bits == 20 || k.runs == Runs::cubic || k.unsnapped;
    const bool other = k.color_bits == 8 || k.runs == Runs::straight;
    return (exact ? 1u : 0) + (!other ? 0 : k.coarse_blend ? 4 : 2);
}
static_assert(!has_given_knobs || (are_valid(given_knobs) && !SPANGLE_OWN_TIERS));
static_assert(!has_given_knobs || tiers == tiers_for(given_knobs),
              "SPANGLE_TIER_SET is not that of SPANGLE_KNOBS");

/// Whether coordinates may have the runs of another tier than the one whose number system colours have.
inline constexpr bool has_mixed_runs =
    SPANGLE_OWN_TIERS ||
    (has_given_knobs && (given_knobs.runs == Runs::cubic) != (given_knobs.color_bits == 20));

} // namespace spangle::raster
