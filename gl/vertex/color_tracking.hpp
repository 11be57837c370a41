// ColorMaterial follows the current colour (GL 1.3, 2.13.3).
#pragma once

namespace spangle::gl {

struct Context;

/// The current colour has changed while COLOR_MATERIAL is enabled: the tracked properties follow at once.
void color_changed(Context& context);

} // namespace spangle::gl
