// The viewport as a box of pixels. Its edges are those of the view volume (GL 1.3, 2.10.1 and 2.11) and lie
// on pixel edges, so a clipped polygon covers no pixel centre beyond it.
#pragma once

#include "gl/pixel/targets.hpp"
#include "gl/pixel/zoom.hpp"

namespace spangle::gl {

/// Whether the viewport contains the whole area, so that clipping removes none of its pixels.
inline bool viewport_holds(const Context& context, const Rect& area) {
    const GLint(&v)[4] = context.transform.viewport;
    return v[0] <= area.x && v[1] <= area.y && v[0] + v[2] >= area.x + area.w &&
           v[1] + v[3] >= area.y + area.h;
}

/// Whether the viewport contains the whole window. Clipping must not depend on which band is in memory.
inline bool viewport_holds_window(const Context& context) {
    const raster::Surface& surface = context.drawable.surface;
    return viewport_holds(context, {0, 0, surface.width, surface.height});
}

/// Whether lines are aliased and one pixel wide. Of such a line, clipping leaves just the fragments that lie
/// in the viewport, so the line itself need not be clipped. Other lines are wider than their geometry.
inline bool lines_are_thin(const Context& context) {
    return !context.polygon.line_smooth && !multisampling(context) &&
           numeric::to_i32_round(context.polygon.line_width) <= 1;
}

/// The pixels of an area that lie in the viewport. May be empty.
inline Rect in_viewport(const Context& context, const Rect& area) {
    const GLint(&v)[4] = context.transform.viewport;
    const Interval columns = clip_interval(v[0], v[2], area.x, area.x + area.w),
                   rows = clip_interval(v[1], v[3], area.y, area.y + area.h);
    return {columns.begin, rows.begin, columns.end - columns.begin, rows.end - rows.begin};
}

} // namespace spangle::gl
