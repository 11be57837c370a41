// Returns values that depend on a draw's tier.
//
// `Of` is a lambda without captures that computes a value from knobs, such as [](const Knobs& k) { return
// k.unsnapped; }. Where programs compose tiers, it is applied to the knobs of the draw. Elsewhere each tier's
// value is a constant, and the code compares tiers. Builds with given knobs need no comparison, and firmware
// stores no knobs.
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
/// Does what of_tier() does, for code that only tiers with straight runs reach. of_cubic_tier() is for code
/// that only tiers with cubic runs reach.
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
/// Given knobs have one form of runs. Runs of the other form are those of a tier of the library, because
/// narrow surfaces have cubic runs.
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

/// Whether colours have 20 bits below a 255th.
inline constexpr auto has_exact_colors = [](const Knobs& k) { return k.color_bits == 20; };
inline constexpr auto has_cubic_runs = [](const Knobs& k) { return k.runs == Runs::cubic; };

/// Whether attributes pass through the vertices' positions before snapping.
SPANGLE_INLINE bool unsnaps(const DrawState& draw) {
    return has_tier(Tier::exact) && of_tier<[](const Knobs& k) { return k.unsnapped; }>(draw);
}

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
