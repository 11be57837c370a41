// The last few states of fragments that were compiled: programs go back and forth between some of them.
#pragma once

#include <cstdint>

#include "raster/numeric/machine.hpp"
#include "raster/span/draw_state.hpp"

namespace spangle::gl {

struct Engine;

/// Hosts keep as many. A board has no RAM for that, and compiles each change.
inline constexpr unsigned kept_states = numeric::wide_words ? 8 : 0;

class KeptStates {
  public:
    /// Writes the compiled form of a state for a drawable, `texture_changes` being those of the share group.
    /// The form is copied where the same state was compiled before and no texture has changed since.
    void compile(const Engine& engine, const raster::FragmentState& state, const raster::Surface& target,
                 std::uint32_t texture_changes, raster::DrawState& out);

  private:
    /// What the compiled form depends on beside the state.
    struct Origin {
        std::uint32_t texture_changes;
        PixelFormat format;
        DepthFormat depth_format;
        bool has_depth, one_stride; ///< rows of colours and of depths lie equally far apart
        bool is_known = false;      ///< true once a state was kept here
        friend bool operator==(const Origin&, const Origin&) = default;
    };
    struct Kept {
        Origin origin;
        raster::DrawState state;
    };
    Kept kept_[kept_states == 0 ? 1 : kept_states];
    unsigned next_ = 0; ///< which is given up for the next new one
};

} // namespace spangle::gl
