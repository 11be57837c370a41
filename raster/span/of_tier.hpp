// Answers what a draw's tier says, where a line of code asks for it.
//
// `Of` is a formula without captures that makes a value of knobs, such as [](const Knobs& k) { return
// k.unsnapped; }. Where programs compose tiers it is applied to the knobs of the draw. Elsewhere each tier's
// value is a constant. What is left is one comparison of tiers, or nothing where a build has given knobs:
// firmware holds no knobs.
#pragma once

#include "raster/span/draw_state.hpp"
#include "raster/span/instructions.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

#if SPANGLE_OWN_TIERS
template <auto Of> SPANGLE_INLINE auto of_tier(const DrawState& draw) {
    return Of(draw.knobs);
}
template <auto Of> SPANGLE_INLINE auto of_tier(const FragmentState& state) {
    return Of(state.own_tier ? state.knobs : knobs_of(state.tier));
}
/// As of_tier(), for code that only tiers with straight runs, or only tiers with cubic runs, reach.
template <auto Of> SPANGLE_INLINE auto of_straight_tier(const DrawState& draw) {
    return Of(draw.knobs);
}
template <auto Of> SPANGLE_INLINE auto of_cubic_tier(const DrawState& draw) {
    return Of(draw.knobs);
}
#elif defined(SPANGLE_KNOBS)
template <auto Of, class State> SPANGLE_INLINE constexpr auto of_tier(const State&) {
    return Of(given_knobs);
}
/// Given knobs have one form of runs. Runs of the other form are those of a tier of the library: narrow
/// surfaces have cubic runs.
template <auto Of> SPANGLE_INLINE constexpr auto of_straight_tier(const DrawState&) {
    return Of(given_knobs.runs == Runs::straight ? given_knobs : balanced_knobs);
}
template <auto Of> SPANGLE_INLINE constexpr auto of_cubic_tier(const DrawState&) {
    return Of(given_knobs.runs == Runs::cubic ? given_knobs : exact_knobs);
}
#else
template <auto Of, class State> SPANGLE_INLINE auto of_tier(const State& state) {
    constexpr auto exact = Of(exact_knobs), balanced = Of(balanced_knobs), fast = Of(fast_knobs);
    const Tier tier = drawn(state.tier);
    if constexpr (balanced == fast)
        return tier == Tier::exact ? exact : balanced;
    else if constexpr (exact == balanced)
        return tier == Tier::fast ? fast : balanced;
    else
        return tier == Tier::exact ? exact : tier == Tier::fast ? fast : balanced;
}
template <auto Of> SPANGLE_INLINE auto of_straight_tier(const DrawState& draw) {
    constexpr auto balanced = Of(balanced_knobs), fast = Of(fast_knobs);
    return drawn(draw.tier) == Tier::fast ? fast : balanced;
}
template <auto Of> SPANGLE_INLINE constexpr auto of_cubic_tier(const DrawState&) {
    return Of(exact_knobs);
}
#endif

/// Whether colours are combined in 20 bits below a 255th.
inline constexpr auto has_exact_colors = [](const Knobs& k) { return k.color_bits == 20; };
inline constexpr auto has_cubic_runs = [](const Knobs& k) { return k.runs == Runs::cubic; };

/// Whether attributes go through the vertices as they were before snapping.
SPANGLE_INLINE bool unsnaps(const DrawState& draw) {
    return has_tier(Tier::exact) && of_tier<[](const Knobs& k) { return k.unsnapped; }>(draw);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
