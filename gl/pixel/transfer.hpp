// Pixel transfer consists of the operations on every group between unpacking and its receiver, or between the
// framebuffer and packing (GL 1.3, 3.6.5).
#pragma once

#include "gl/pixel/component.hpp"
#include "gl/pixel/index.hpp"
#include "gl/pixel/pixel_mode_state.hpp"

namespace spangle::gl {

/// A colour during pixel transfer: red, green, blue, alpha.
struct Pixel {
    Component value[4];
};

/// Pixel transfer with the present state. The object is set up once for each image. If the state changes no
/// colour, transfer costs one test per group.
class Transfer {
  public:
    explicit Transfer(const PixelModeState& state);

    /// Whether transfer may change a colour component.
    bool changes_colors() const { return has_scale_or_bias_ || has_map_; }

    /// Applies scale and bias, then the maps of components.
    void transfer_if_needed(Pixel& color) const {
        if (changes_colors())
            transfer_color(color);
    }
    /// Applies shift and offset, then the maps from indices to colours, whether MAP_COLOR is on or off.
    Pixel color_of(Index index) const;
    /// Applies shift and offset, then the map of colour indices if MAP_COLOR is on.
    Index index(Index index) const;
    /// Applies shift and offset, then the map of stencil indices if MAP_STENCIL is on.
    Index stencil(Index index) const;
    Component depth(Component z) const;

  private:
    void transfer_color(Pixel& color) const;

    const PixelModeState& state_;
    bool has_scale_or_bias_ = false, has_map_ = false;
};

} // namespace spangle::gl
