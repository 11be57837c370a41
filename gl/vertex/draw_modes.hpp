// The modes of one draw: what the state of a context means for the primitives from Begin to End.
//
// DrawModes owns no state of GL. derive() reads the context once per Begin, and all parts of the pipeline ask
// the accessors. An accessor is constant false in a build without the feature that it belongs to, so that
// the compiler drops the code behind it.
#pragma once

#include "gl/context/context.hpp"
#include "gl/context/features.hpp"
#include "gl/context/limits.hpp"
#include "gl/context/reach.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "gl/pixel/targets.hpp"
#include "gl/pixel/viewport_box.hpp"

namespace spangle::gl {

/// Size of aliased points and width of aliased lines in pixels: rounded, then clamped to 1 to 64 (GL 1.3, 3.3
/// and 3.4.2).
SPANGLE_RUN_CALL inline std::int32_t rounded_size(Real size) {
    return numeric::clamp<std::int32_t>(numeric::to_i32_round(size), 1, 64);
}

/// Size of antialiased points and width of antialiased lines in eighths of a pixel, clamped to 8 to 512 (GL
/// 1.3, 3.3).
inline std::int32_t eighths(Real size) {
    return numeric::clamp<std::int32_t>(((numeric::to_fixed(size, 16) >> 12) + 1) >> 1, 8, 512);
}

class DrawModes {
  public:
    /// What other parts of the pipeline derive from the same state. derive() needs it.
    struct Derived {
        bool two_sided;       ///< true if lighting computes colours of backs
        bool tracks_color;    ///< true if a material follows the current colour
        bool has_user_planes; ///< true if a clip plane of the user is enabled
    };

    /// Derives all modes for primitives of `mode`, a token of Begin.
    SPANGLE_INLINE void derive(const Context& context, GLenum mode, const Derived& derived);

    /// The token of Begin.
    GLenum mode() const { return mode_; }

    // Modes of vertices.
    bool is_lit() const { return is_lit_; }
    bool has_two_sides() const { return SPANGLE_TWO_SIDES && has_two_sides_; }
    bool has_fog() const { return SPANGLE_FEATURE_FOG && has_fog_; }
    /// True if fog uses fog coordinates as distance.
    bool has_fog_coordinates() const { return SPANGLE_FEATURE_FOG && has_fog_coordinates_; }
    /// True if unlit vertices have a secondary colour (COLOR_SUM).
    bool has_color_sum() const { return SPANGLE_FEATURE_SECONDARY_COLOR && has_color_sum_; }
    /// Bits of a colour index, or 0 if the framebuffer has RGBA colours.
    unsigned index_bits() const { return index_bits_; }
    bool has_color_index() const { return raster::has_indices && index_bits_ != 0; }
    /// Bit u is set if texture unit u is enabled, and bit u + third_coordinate if unit u needs r.
    unsigned units() const { return units_; }
    /// True if seldom used current state is copied to each vertex.
    bool needs_vertex_state() const {
        return (tells_reach || has_color_material || SPANGLE_FEATURE_POLYGON_MODE ||
                SPANGLE_FEATURE_SELECTION || SPANGLE_FEATURE_FEEDBACK || SPANGLE_FEATURE_FOG ||
                raster::has_indices || SPANGLE_FEATURE_SECONDARY_COLOR || SPANGLE_GATHERS_POLYGONS) &&
               needs_vertex_state_;
    }

    // Modes of all primitives.
    bool is_flat_shaded() const { return is_flat_shaded_; }
    /// True if primitives are selected or fed back instead of drawn.
    bool is_capturing() const {
        return (SPANGLE_FEATURE_SELECTION || SPANGLE_FEATURE_FEEDBACK) && is_capturing_;
    }
    /// True if primitives are clipped to the view volume itself, not to the guard band. Outlines draw the
    /// edges that clipping makes, and selection and feedback report its result. A wide line ends where its
    /// centre line leaves the volume.
    bool clips_to_view_volume() const { return has_outlines() || is_capturing() || clips_wide_lines_; }
    bool is_multisampling() const { return raster::has_samples && is_multisampling_; }

    // Modes of points and lines.
    /// Sizes in pixels, rounded, 1 to 64.
    std::int32_t point_size() const { return point_size_; }
    std::int32_t line_width() const { return line_width_; }
    /// True if points are antialiased, are sprites, or have a size that depends on the vertex. It is also
    /// true if the drawable has samples.
    bool has_special_points() const {
        return (SPANGLE_FEATURE_ANTIALIASING || raster::has_samples || SPANGLE_FEATURE_POINT_PARAMETERS) &&
               has_special_points_;
    }
    /// True if lines are stippled or antialiased, or if the drawable has samples.
    bool has_special_lines() const {
        return (SPANGLE_FEATURE_STIPPLE || SPANGLE_FEATURE_ANTIALIASING || raster::has_samples) &&
               has_special_lines_;
    }

    // Modes of polygons.
    /// True if faces of a winding are culled: counter-clockwise ones, or clockwise ones.
    bool culls(bool clockwise) const { return culls_winding_[clockwise ? 1 : 0]; }
    bool front_is_ccw() const { return front_is_ccw_; }
    /// True if a mode asks for more of triangles and quads than clipping, culling and filling. polygon()
    /// draws them then.
    bool needs_polygon_path() const {
        return (SPANGLE_TWO_SIDES || SPANGLE_FEATURE_POLYGON_MODE || SPANGLE_FEATURE_SELECTION ||
                SPANGLE_FEATURE_FEEDBACK || SPANGLE_FEATURE_CLIP_PLANES || SPANGLE_FEATURE_STENCIL_SIDES ||
                SPANGLE_FEATURE_POLYGON_OFFSET || SPANGLE_FEATURE_ANTIALIASING || raster::has_samples) &&
               needs_polygon_path_;
    }
    /// True if PolygonMode draws front or back faces as lines or points.
    bool has_outlines() const { return SPANGLE_FEATURE_POLYGON_MODE && has_outlines_; }
    /// Polygon mode of side 0 (front) or 1 (back).
    GLenum face_mode(int side) const { return face_mode_[side]; }
    /// True if back faces have a DrawState of their own.
    bool has_two_sided_stencil() const { return SPANGLE_FEATURE_STENCIL_SIDES && has_two_sided_stencil_; }
    /// True if PolygonOffset is enabled for some polygon mode.
    bool has_polygon_offset() const { return SPANGLE_FEATURE_POLYGON_OFFSET && has_polygon_offset_; }
    bool has_smooth_polygons() const { return SPANGLE_FEATURE_ANTIALIASING && has_smooth_polygons_; }
    /// True if filled polygons are antialiased, or if the drawable has samples.
    bool fills_whole_polygons() const {
        return (SPANGLE_FEATURE_ANTIALIASING || raster::has_samples) && fills_whole_polygons_;
    }
    /// True if polygons are outlined, captured or antialiased. A polygon is then drawn as a whole, not
    /// divided into triangles.
    bool is_drawn_whole() const { return has_outlines() || is_capturing() || fills_whole_polygons(); }
    /// True if the corners of a POLYGON are gathered until it ends. Feedback reports a POLYGON as one polygon
    /// (GL 1.3, 5.3). An antialiased polygon must cover a pixel once, not once for each triangle of a fan (GL
    /// 1.3, 3.5.3).
    bool gathers_polygons() const { return SPANGLE_GATHERS_POLYGONS && gathers_polygons_; }

  private:
    // Modes that vertices and triangles ask for come first, because the short instructions of
    // microcontrollers reach few bytes.
    bool is_lit_ = false, has_fog_ = false, is_flat_shaded_ = false, needs_vertex_state_ = false,
         needs_polygon_path_ = false, is_capturing_ = false, culls_winding_[2] = {}, front_is_ccw_ = false,
         has_outlines_ = false, has_two_sides_ = false, has_special_lines_ = false,
         has_special_points_ = false, clips_wide_lines_ = false, fills_whole_polygons_ = false,
         has_polygon_offset_ = false, has_two_sided_stencil_ = false, has_fog_coordinates_ = false,
         has_color_sum_ = false, has_smooth_polygons_ = false, is_multisampling_ = false,
         gathers_polygons_ = false;
    GLenum mode_ = GL_POINTS;
    unsigned units_ = 0, index_bits_ = 0;
    std::int32_t point_size_ = 0, line_width_ = 0;
    GLenum face_mode_[2] = {};

    static bool is_culled(const PolygonState& p, bool front);
    static bool sizes_points(const PolygonState& p);
};

inline bool DrawModes::is_culled(const PolygonState& p, bool front) {
    if (!p.cull_face)
        return false;
    return p.cull_face_mode == GL_FRONT_AND_BACK || (p.cull_face_mode == GL_FRONT) == front;
}

/// True if the size of points depends on the vertex or is clamped, or if points are sprites.
inline bool DrawModes::sizes_points([[maybe_unused]] const PolygonState& p) {
#if SPANGLE_FEATURE_POINT_PARAMETERS
    const bool follows = p.point_attenuation[0] != numeric::one || p.point_attenuation[1] != numeric::zero ||
                         p.point_attenuation[2] != numeric::zero;
    return p.point_sprite || follows || p.point_size < p.point_size_min || p.point_size_max < p.point_size;
#else
    return false;
#endif
}

SPANGLE_INLINE void DrawModes::derive(const Context& context, GLenum mode, const Derived& derived) {
    mode_ = mode;
    if constexpr (SPANGLE_FEATURE_FOG) {
        has_fog_ = context.fog.fog;
        has_fog_coordinates_ = has_fog_ && context.fog.source == GL_FOG_COORDINATE;
    }
    if constexpr (raster::has_indices)
        index_bits_ = context.drawable.index_bits;
    is_lit_ = context.lighting.lighting;
    has_color_sum_ = SPANGLE_FEATURE_SECONDARY_COLOR && !is_lit_ && sums_colors(context.lighting);
    has_two_sides_ = derived.two_sided;
    units_ = context.texture.units_in_use();
    const PolygonState& polygon = context.polygon;
    is_flat_shaded_ = polygon.shade_model == GL_FLAT;
    front_is_ccw_ = polygon.front_face == GL_CCW;
    for (int clockwise = 0; clockwise < 2; ++clockwise)
        culls_winding_[clockwise] = is_culled(polygon, front_is_ccw_ == (clockwise == 0));
    is_capturing_ = !context.render.draws();
    if constexpr (SPANGLE_FEATURE_POLYGON_MODE) {
        for (int side = 0; side < 2; ++side)
            face_mode_[side] = polygon.mode[side];
        has_outlines_ =
            (face_mode_[0] != GL_FILL || face_mode_[1] != GL_FILL) && context.render.mode != GL_SELECT;
    }
    clips_wide_lines_ = has_clipping && mode != GL_POINTS && mode <= GL_LINE_STRIP &&
                        !lines_are_thin(context) && !viewport_holds_window(context);
    has_two_sided_stencil_ = SPANGLE_FEATURE_STENCIL_SIDES && stencil_sides(context);
    const bool sampled = has_sample_buffer(context);
    is_multisampling_ = multisampling(context);
    has_smooth_polygons_ = SPANGLE_FEATURE_ANTIALIASING && polygon.polygon_smooth && !is_multisampling_;
    fills_whole_polygons_ = has_smooth_polygons_ || sampled;
    if constexpr (SPANGLE_GATHERS_POLYGONS)
        gathers_polygons_ = is_capturing() ? SPANGLE_FEATURE_FEEDBACK && context.render.mode == GL_FEEDBACK
                                           : has_smooth_polygons_;
    needs_vertex_state_ = derived.tracks_color || has_outlines() || is_capturing() || has_fog_coordinates_ ||
                          has_color_index() || has_color_sum_ || (mode == GL_POLYGON && gathers_polygons()) ||
                          (tells_reach && is_told(context));
    has_special_points_ = (SPANGLE_FEATURE_ANTIALIASING && polygon.point_smooth) || sampled ||
                          ((mode == GL_POINTS || has_outlines_) && sizes_points(polygon));
    has_polygon_offset_ = SPANGLE_FEATURE_POLYGON_OFFSET &&
                          (polygon.offset_fill || polygon.offset_line || polygon.offset_point);
    needs_polygon_path_ =
        has_two_sides_ || clips_to_view_volume() || derived.has_user_planes || has_two_sided_stencil_;
    needs_polygon_path_ = needs_polygon_path_ || has_polygon_offset() || fills_whole_polygons();
    has_special_lines_ = (SPANGLE_FEATURE_STIPPLE && polygon.line_stipple) ||
                         (SPANGLE_FEATURE_ANTIALIASING && polygon.line_smooth) || sampled;
    if constexpr (has_points || SPANGLE_FEATURE_POLYGON_MODE)
        point_size_ = rounded_size(polygon.point_size);
    if constexpr (has_lines || SPANGLE_FEATURE_POLYGON_MODE)
        line_width_ = rounded_size(polygon.line_width);
}

} // namespace spangle::gl
