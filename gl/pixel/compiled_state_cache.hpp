// Keeps the last few compiled states of fragments, because many programs alternate between a few states.
#pragma once

#include <cstdint>

#include "raster/numeric/machine.hpp"
#include "raster/span/draw_state.hpp"

namespace spangle::gl {

struct Engine;

/// Number of compiled states that are kept. Boards have no RAM for them; there, each change of state is
/// compiled.
inline constexpr unsigned compiled_state_count = numeric::wide_words ? 8 : 0;

class CompiledStateCache {
  public:
    /// Writes the compiled form of a state for a drawable. The form is copied if the same state was compiled
    /// before and no texture has changed since. `texture_changes` is ShareGroup::texture_changes.
    void compile(const Engine& engine, const raster::FragmentState& state, const raster::Surface& target,
                 std::uint32_t texture_changes, raster::DrawState& out);

  private:
    /// The values that the compiled form depends on, apart from the fragment state itself.
    struct CacheKey {
        std::uint32_t texture_changes;
        PixelFormat format;
        DepthFormat depth_format;
        bool has_depth, shares_stride; ///< shares_stride: colour and depth planes have the same stride
        bool is_known = false;         ///< the entry holds a compiled state
        friend bool operator==(const CacheKey&, const CacheKey&) = default;
    };
    struct Entry {
        CacheKey origin;
        raster::DrawState state;
    };
    Entry entries_[compiled_state_count == 0 ? 1 : compiled_state_count];
    unsigned next_replaced_ = 0; ///< index of the state that the next new one replaces
};

} // namespace spangle::gl
