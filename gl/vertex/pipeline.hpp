// The vertex pipeline, from vertices as given to primitives in window space: transform, assemble, clip, cull,
// light, draw. It is one template for all numeric policies; M supplies the arithmetic, L the lighting. This
// file has what all parts share; the file named above a group of declarations defines them.
//
// The order is that of GL 1.3, figure 2.8, as far as a program can see it. Colours are computed late, for
// vertices of primitives that survive culling, since no step in between changes a vertex's colour.
#pragma once

#include <bit>
#include <new>
#include <type_traits>

#include "gl/context/context.hpp"
#include "gl/context/reach.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "gl/pixel/targets.hpp"
#include "gl/pixel/viewport_box.hpp"
#include "gl/vertex/capture.hpp"
#include "gl/vertex/current_element.hpp"
#include "gl/vertex/texgen.hpp"
#include "gl/vertex/user_planes.hpp"
#include "raster/band/batch_rows.hpp"
#include "raster/primitive/draw.hpp"
#include "raster/primitive/line_end.hpp"
#include "raster/primitive/line_stipple.hpp"
#include "raster/primitive/polygon_offset.hpp"

namespace spangle::gl {

/// Draws the fragments of `source`, which places them, with the values of the current raster position.
template <class M>
void draw_at_raster_position(const Context& context, const raster::DrawState& state,
                             const raster::Surface& target, raster::PixelSource& source) {
    typename M::Window at;
    M::set_raster(context.current.raster, at);
    if (is_indexed(context.drawable))
        M::set_index(context.current.raster.index, context.drawable.index_bits, at);
    raster::draw_pixels(state, target, at, source);
}

template <class M, class L> class Pipeline {
  public:
    using Window = typename M::Window;

    void begin(Context& context, GLenum mode) {
        context_ = &context;
        mode_ = mode;
        corners_needed_ = corners_of(mode);
        corner_count_ = 0;
        is_odd_triangle_ = false;
        restarts_stipple_ = true;
        if (begins_outside_band(context))
            return;
        for (int i = 0; i < slot_count; ++i)
            corner_[i] = &vertex_slot_[i];
        derive(context);
        if (tells_reach && is_told(context)) [[unlikely]]
            record_draw_reach();
        if (mode == GL_POLYGON && (has_outlines() || gathers_polygons()))
            begin_polygon();
        const PrimitiveKind drawn = mode == GL_POINTS       ? PrimitiveKind::points
                                    : mode <= GL_LINE_STRIP ? PrimitiveKind::lines
                                                            : PrimitiveKind::polygons;
        state_ = &draw_state(context, drawn);
        context.fragments.primitive.stippled = drawn == PrimitiveKind::polygons;
    }

    SPANGLE_INLINE void vertex(Context& context, Real x, Real y, Real z, Real w) {
        if (is_outside_band())
            return;
        Vertex& v = *corner_[corner_count_];
        const CurrentState& current = context.current;
        v.position[0] = x;
        v.position[1] = y;
        v.position[2] = z;
        v.position[3] = w;
        set_normal(v, current.normal);
        if constexpr (caches_window_positions)
            transform_with_cache(v);
        else
            transform_vertex(v);
        set_attributes_of(current, v);
        if (needs_vertex_state())
            take_vertex_state(current, v);
        if (++corner_count_ == corners_needed_)
            primitive();
    }

    /// Takes elements of the enabled arrays, as if ArrayElement gave them one by one.
    void elements(Context& context, std::uint32_t count, const Indices& indices);

    void end() {
        if (!is_outside_band()) {
            if (has_lines && mode_ == GL_LINE_LOOP && corner_count_ == 2)
                line(*corner_[1], *corner_[0]);
            if (mode_ == GL_POLYGON && (has_outlines() || gathers_polygons()))
                end_polygon();
        }
        if constexpr (skips_batches)
            if (batches_ != nullptr)
                batches_->end_batch();
    }

    /// RasterPos: a vertex that is not drawn. If it is outside of the clip volume, only `valid` changes.
    void raster_position(Context& context, const Real (&position)[4]);

    /// Called before a material changes: vertices given so far get their colours from the old one.
    void settle_colors();

  private:
    /// Bits of Vertex::flags. Bits 0 to 5 are the planes of the view volume that the vertex is outside of,
    /// bits 8 to 13 the planes (guard band, near, far) that it must be clipped by; then follow single bits.
    static constexpr int user_shift = 6; ///< number of the first plane of the user, in sets of planes
    static constexpr unsigned outside_mask = 0x3F, beyond_shift = 8, beyond_mask = 0x3F << beyond_shift,
                              unprojected = 1 << 14, ///< the vertex has no window coordinates yet
        uncolored = 1 << 15,                         ///< the vertex is still to be lit
        is_clipped_vertex = 1 << 16,                 ///< the vertex is a ClippedVertex
        edge_flag = 1 << 17,                         ///< the current edge flag when the vertex was given
        boundary = 1 << 18,   ///< outlines of the polygon at hand draw the edge that starts here
        is_pending = 1 << 19, ///< primitives of Pending that use the vertex are still to be drawn
        back_known = 1 << 20; ///< the colour of the back was settled along with that of the front

    /// Builds with neither lighting nor generated coordinates do without normals.
    static constexpr bool has_normals = SPANGLE_FEATURE_LIGHTING || SPANGLE_FEATURE_TEXGEN;
    /// A vertex as it was given, in object space.
    struct ObjectVertex {
        Real position[4]{numeric::zero, numeric::zero, numeric::zero, numeric::one};
#if SPANGLE_FEATURE_LIGHTING || SPANGLE_FEATURE_TEXGEN
        Real normal[3]{};
#else
        static constexpr Real normal[3]{};
#endif
    };
    struct Vertex : ObjectVertex {
        std::uint32_t flags = 0;
#if SPANGLE_VERTEX_CACHE != 1
        std::uint32_t cache_epoch =
            0;        ///< cache_epoch_ when a cached vertex was processed; valid while both are equal
        Real st[2]{}; ///< the coordinates that read_texture() made window.tex of
#endif
        Window window{};
    };
    /// A vertex while it is clipped, or one that clipping made. It keeps values that other vertices compute
    /// when they need them.
    struct ClippedVertex : Vertex {
        typename M::Point clip{};
#if SPANGLE_FEATURE_FOG
        typename M::Depth eye_z{}; ///< z in eye space with its sign, or the fog coordinate
#endif
#if SPANGLE_TWO_SIDES || SPANGLE_FEATURE_CLIP_PLANES || SPANGLE_FEATURE_POINT_PARAMETERS
        typename M::Point eye{};
#endif
#if SPANGLE_FEATURE_FEEDBACK
        typename M::Eye texture{}; ///< set while primitives are fed back
#endif
#if SPANGLE_TWO_SIDES
        typename L::Input light{}; ///< to light the back; the front has its colour already
        typename M::Colors back{}; ///< set where back_known
#endif
    };
#if SPANGLE_VERTEX_CACHE != 1
    /// The vertex cache keeps first_vertices elements from the start. Where it may grow, the first draw with
    /// more elements makes it one of vertex_cache elements.
    static constexpr bool grows_cache = SPANGLE_GROWS_CACHE != 0 && raster::has_shortcuts &&
                                        vertex_cache > 1024 && std::has_single_bit(vertex_cache);
    static constexpr std::size_t first_vertices = grows_cache ? 128 : vertex_cache;
    /// Where a vertex fell that was given by itself, not as an element of arrays.
    struct CachedPosition {
        Real position[3]{};            ///< position as given; its w was 1
        std::uint32_t cache_epoch = 0; ///< cache_epoch_ when the place was kept; valid while both are equal
        typename M::Place transform_with_cache{};
    };
    static constexpr std::size_t
        most_cached_positions =
            512, ///< the more the better, as far as the first-level cache of hosts reaches
        cached_position_count =
            std::bit_floor(sizeof(Vertex) * vertex_cache / sizeof(CachedPosition) < most_cached_positions
                               ? sizeof(Vertex) * vertex_cache / sizeof(CachedPosition)
                               : most_cached_positions),
        cached_position_room = (sizeof(CachedPosition) * cached_position_count + sizeof(Vertex) - 1) /
                               sizeof(Vertex), ///< in vertices
        cached_position_overlap =
            cached_position_room < first_vertices ? cached_position_room : first_vertices;
    /// Vertices that may come again. Elements by their index, or vertices given by themselves by their
    /// position, take turns in the same memory.
    union VertexCache {
        Vertex vertex[first_vertices];
        CachedPosition cached_position[cached_position_count];
        VertexCache() : vertex{} {}
    };
#endif
    /// This build keeps the window positions of vertices given by themselves.
    static constexpr bool caches_window_positions = vertex_cache != 1 && raster::has_shortcuts;
    /// Vertices of line strips are not kept: a small cache forgets them before another strip asks for them.
    static constexpr bool skips_cache_for_strips =
        vertex_cache < 1024 && raster::has_shortcuts && std::is_same_v<Window, raster::FixedVertex>;
    /// Room of Pending for vertices; a line strip of line_batch lines has one vertex more.
    static constexpr int pending_vertices = (numeric::cheap_branches ? 1 : 4) * line_batch + 1;
    /// Builds without shortcuts draw all triangles and quads as polygons.
    static constexpr bool faces_are_polygons = has_polygons && !raster::has_shortcuts;
    static constexpr int slot_count = 4;
    /// Room for the corners of a quad while it is clipped: each plane of the volume and of the user adds one,
    /// and clip_polygon() wants room for two at every edge. A Cut that a plane took away is free for the next
    /// plane.
    static constexpr int clip_vertices = slot_count + 6 +
                                         (SPANGLE_FEATURE_CLIP_PLANES ? max_clip_planes : 0) + 2 + clip_spare,
                         clipped_vertex_count = clip_vertices + clip_spare;
    static_assert(clipped_vertex_count <= 32);
    static_assert(has_clipping || !(SPANGLE_FEATURE_CLIP_PLANES || SPANGLE_FEATURE_POLYGON_MODE ||
                                    SPANGLE_FEATURE_SELECTION || SPANGLE_GATHERS_POLYGONS),
                  "user's planes, outlines, selection, feedback and antialiasing need SPANGLE_CLIPPING");
    static_assert(raster::has_perspective || !has_clipping, "what SPANGLE_CLIPPING cuts has a w of its own");

    /// Number of elements of a long draw that are drawn, or left out of a band, together.
    static constexpr std::uint32_t piece = 12;
    static constexpr bool skips_batches = SPANGLE_FEATURE_BANDS != 0;

    Context* context_ = nullptr;
    /// The batches of the drawable, while a callback draws its bands; null in modes SELECT and FEEDBACK.
    raster::BatchRows* batches_ = nullptr;
    const raster::DrawState* state_ = nullptr;
    GLenum mode_ = GL_POINTS;
    int corner_count_ = 0, corners_needed_ = 0; ///< vertices in corner_, and how many make a primitive
    bool is_odd_triangle_ = false;              ///< the strip has an odd number of triangles so far
    bool has_fog_ = false, is_lit_ = false, is_flat_shaded_ = false, has_two_sides_ = false;
    unsigned units_ = 0;               ///< bit u: texture unit u is on; bit u + third_coordinate: it uses r
    unsigned units_with_r_ = 0;        ///< bit u: unit u uses r; as it was when the cached vertices were made
    bool has_fog_coordinates_ = false; ///< fog takes its distance from fog coordinates
    bool has_color_sum_ = false;       ///< vertices have secondary colours without lighting: COLOR_SUM
    unsigned index_bits_ = 0;          ///< bits of an index framebuffer; 0: the framebuffer has colours
    bool needs_vertex_state_ = false;  ///< take_vertex_state() is called for each vertex
    bool needs_polygon_path_ = false;  ///< polygon() draws triangles and quads, too
    bool has_outlines_ = false;        ///< PolygonMode makes lines or points of front or back faces
    bool has_two_sided_stencil_ = false; ///< back faces have a DrawState of their own
    bool is_capturing_ = false;          ///< primitives are selected or fed back, not drawn
    bool clips_wide_lines_ = false;      ///< wide lines are clipped at viewport edges within the window
    bool has_polygon_offset_ = false;    ///< PolygonOffset is on for some polygon mode
    bool has_special_lines_ = false;     ///< lines are stippled, antialiased, or drawn to samples
    bool has_special_points_ = false;    ///< points likewise, or they are sprites, or have sizes of their own
    bool fills_whole_polygons_ = false;  ///< filled polygons are antialiased, or drawn to samples
    bool has_smooth_polygons_ = false;
    bool is_multisampling_ = false;
    bool restarts_stipple_ = false; ///< the next line starts the stipple pattern anew
    GLenum face_mode_[2] = {};      ///< polygon mode of front and back
    bool front_is_ccw_ = false,
         culls_winding_[2] = {};      ///< culls_winding_: counter-clockwise and clockwise faces
    Vertex* corner_[slot_count] = {}; ///< vertices of the primitive being assembled
    unsigned cached_layout_ =
        0; ///< layout of the arrays that the cached vertices came from; see arrays_begin()
    ObjectVertex object_vertex_;   ///< position and normal of the element at hand
    Real last_draw_color_[4] = {}; ///< current colour during the last draw of elements
    std::uint32_t cache_epoch_ =
        0; ///< cached vertices of another `cache_epoch` are invalid; see invalidate_cache()
    std::int32_t point_size_ = 0, line_width_ = 0; ///< in pixels, 1 to 64
    raster::LineStipple stipple_;
    typename M::Transforms transforms_;
    L lighting_;
    UserPlanes<M> planes_;
    TexGen<M> texgen_;
    Window unlit_{};           ///< the current colour in the rasterizer's units
    Real unlit_color_[4] = {}; ///< the current colour that unlit_ was converted from
    bool has_unlit_color_ = false;
#if SPANGLE_VERTEX_CACHE != 1
    bool caches_positions_ = false;     ///< vertex_cache_ holds `cached_position`, not `vertex`
    std::uint32_t immediate_count_ = 0; ///< number of vertices given by themselves since the last elements
#endif
#if SPANGLE_CLIPPING
    std::uint32_t free_clipped_vertices_ =
        0; ///< bit i: clipped_vertex_[i] is no corner of the polygon being clipped
#endif
#if SPANGLE_GATHERS_POLYGONS
    ClippedVertex* gathered_ = nullptr; ///< in the arena: corners of a polygon that is drawn when it ends
    int gathered_count_ = 0, gathered_capacity_ = 0;
    const Window** gathered_windows_ = nullptr; ///< room for the corners that clipping leaves of that polygon
    bool gathering_failed_ = false;             ///< the arena had no room for all corners
#endif
    Vertex vertex_slot_[slot_count];
#if SPANGLE_TWO_SIDES
    typename M::Colors back_colors_[slot_count]; ///< back colours of vertex_slot_, set where back_known
#endif
#if SPANGLE_FEATURE_FEEDBACK
    typename M::Eye texture_coords_[slot_count]; ///< of vertex_slot_, set while primitives are fed back
#endif
#if SPANGLE_VERTEX_CACHE != 1
    VertexCache vertex_cache_;
    struct GrownCache {
        Vertex* elements = nullptr; ///< room for vertex_cache elements, or null
        Vertex* base = nullptr;     ///< the elements that are kept now: `elements`, or vertex_cache_.vertex
        std::uint32_t mask = 0;     ///< bits of an index that choose the place
    };
    struct FixedCache {};
    [[no_unique_address]] std::conditional_t<grows_cache, GrownCache, FixedCache> grown_cache_;
#endif
#if SPANGLE_CLIPPING
    ClippedVertex clipped_vertex_[clipped_vertex_count];
#endif

    /// A callback draws this band, and no part of the batch that begins reaches the band.
    bool begins_outside_band([[maybe_unused]] const Context& context) {
        if constexpr (skips_batches) {
            batches_ = context.render.draws() ? context.drawable.batches : nullptr;
            return batches_ != nullptr && !batches_->begin_batch();
        }
        return false;
    }
    /// The batch that has begun is left out of the band; true from its begin() to its end().
    bool is_outside_band() const {
        return skips_batches && batches_ != nullptr && batches_->is_skipped();
    }

    void derive(Context& context) {
        if (const unsigned dirty = context.dirty & dirty_vertex; dirty != 0) {
            if ((dirty & (dirty_matrices | dirty_others)) != 0) {
                M::derive(context.transform, transforms_);
                planes_.derive(context.transform);
                texgen_.derive(context);
            }
            lighting_.derive(context, dirty);
            context.dirty = static_cast<std::uint8_t>(context.dirty & ~dirty_vertex);
            invalidate_cache();
        }
        if constexpr (SPANGLE_FEATURE_FOG) {
            has_fog_ = context.fog.fog;
            has_fog_coordinates_ = has_fog_ && context.fog.source == GL_FOG_COORDINATE;
        }
        if constexpr (raster::has_indices)
            index_bits_ = context.drawable.index_bits;
        is_lit_ = context.lighting.lighting;
        has_color_sum_ = SPANGLE_FEATURE_SECONDARY_COLOR && !is_lit_ && sums_colors(context.lighting);
        if (has_color_sum_)
            has_unlit_color_ = false;
        has_two_sides_ = lighting_.two_sided();
        units_ = context.texture.units_in_use();
        if (const unsigned thirds = units_ >> third_coordinate; thirds != units_with_r_) {
            units_with_r_ = thirds;
            invalidate_cache();
        }
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
        clips_wide_lines_ = has_clipping && mode_ != GL_POINTS && mode_ <= GL_LINE_STRIP &&
                            !lines_are_thin(context) && !viewport_holds_window(context);
        has_two_sided_stencil_ = SPANGLE_FEATURE_STENCIL_SIDES && stencil_sides(context);
        const bool sampled = has_sample_buffer(context);
        is_multisampling_ = multisampling(context);
        has_smooth_polygons_ = SPANGLE_FEATURE_ANTIALIASING && polygon.polygon_smooth && !is_multisampling_;
        fills_whole_polygons_ = has_smooth_polygons_ || sampled;
        needs_vertex_state_ = lighting_.tracks_color() || has_outlines() || is_capturing() ||
                              has_fog_coordinates_ || has_color_index() || has_color_sum_ ||
                              (mode_ == GL_POLYGON && gathers_polygons()) ||
                              (tells_reach && is_told(context));
        has_special_points_ = (SPANGLE_FEATURE_ANTIALIASING && polygon.point_smooth) || sampled ||
                              ((mode_ == GL_POINTS || has_outlines_) && sizes_points(polygon));
        has_polygon_offset_ = SPANGLE_FEATURE_POLYGON_OFFSET &&
                              (polygon.offset_fill || polygon.offset_line || polygon.offset_point);
        needs_polygon_path_ =
            has_two_sides_ || clips_to_view_volume() || planes_.any() || has_two_sided_stencil_;
        needs_polygon_path_ = needs_polygon_path_ || has_polygon_offset() || fills_whole_polygons();
        has_special_lines_ = (SPANGLE_FEATURE_STIPPLE && polygon.line_stipple) ||
                             (SPANGLE_FEATURE_ANTIALIASING && polygon.line_smooth) || sampled;
#if SPANGLE_FEATURE_STIPPLE
        stipple_.pattern = polygon.stipple_pattern;
        stipple_.factor = static_cast<std::uint32_t>(polygon.stipple_factor);
#endif
        if constexpr (has_points || SPANGLE_FEATURE_POLYGON_MODE)
            point_size_ = rounded_size(polygon.point_size);
        if constexpr (has_lines || SPANGLE_FEATURE_POLYGON_MODE)
            line_width_ = rounded_size(polygon.line_width);
    }

    /// Makes all cached vertices invalid.
    SPANGLE_RUN_CALL void invalidate_cache() {
        if (++cache_epoch_ != 0)
            return;
#if SPANGLE_VERTEX_CACHE != 1
        clear_cache();
#endif
        cache_epoch_ = 1;
    }

    static bool is_culled(const PolygonState& p, bool front) {
        if (!p.cull_face)
            return false;
        return p.cull_face_mode == GL_FRONT_AND_BACK || (p.cull_face_mode == GL_FRONT) == front;
    }

    /// The size of aliased points and lines in pixels: rounded, 1 to 64; 0 counts as 1 (GL 1.3, 3.3, 3.4.2).
    SPANGLE_RUN_CALL static std::int32_t rounded_size(Real size) {
        return numeric::clamp<std::int32_t>(numeric::to_i32_round(size), 1, 64);
    }

    static bool sizes_points([[maybe_unused]] const PolygonState& p) {
#if SPANGLE_FEATURE_POINT_PARAMETERS
        const bool follows = p.point_attenuation[0] != numeric::one ||
                             p.point_attenuation[1] != numeric::zero ||
                             p.point_attenuation[2] != numeric::zero;
        return p.point_sprite || follows || p.point_size < p.point_size_min ||
               p.point_size_max < p.point_size;
#else
        return false;
#endif
    }
    bool has_outlines() const {
        return SPANGLE_FEATURE_POLYGON_MODE && has_outlines_;
    }
    bool has_polygon_offset() const {
        return SPANGLE_FEATURE_POLYGON_OFFSET && has_polygon_offset_;
    }
    bool has_fog() const {
        return SPANGLE_FEATURE_FOG && has_fog_;
    }
    bool needs_vertex_state() const {
        return (tells_reach || has_color_material || SPANGLE_FEATURE_POLYGON_MODE ||
                SPANGLE_FEATURE_SELECTION || SPANGLE_FEATURE_FEEDBACK || SPANGLE_FEATURE_FOG ||
                raster::has_indices || SPANGLE_FEATURE_SECONDARY_COLOR || SPANGLE_GATHERS_POLYGONS) &&
               needs_vertex_state_;
    }
    bool needs_polygon_path() const {
        return (SPANGLE_TWO_SIDES || SPANGLE_FEATURE_POLYGON_MODE || SPANGLE_FEATURE_SELECTION ||
                SPANGLE_FEATURE_FEEDBACK || SPANGLE_FEATURE_CLIP_PLANES || SPANGLE_FEATURE_STENCIL_SIDES ||
                SPANGLE_FEATURE_POLYGON_OFFSET || SPANGLE_FEATURE_ANTIALIASING || raster::has_samples) &&
               needs_polygon_path_;
    }
    bool has_special_lines() const {
        return (SPANGLE_FEATURE_STIPPLE || SPANGLE_FEATURE_ANTIALIASING || raster::has_samples) &&
               has_special_lines_;
    }
    bool has_special_points() const {
        return (SPANGLE_FEATURE_ANTIALIASING || raster::has_samples || SPANGLE_FEATURE_POINT_PARAMETERS) &&
               has_special_points_;
    }
    bool fills_whole_polygons() const {
        return (SPANGLE_FEATURE_ANTIALIASING || raster::has_samples) && fills_whole_polygons_;
    }
    /// The size of antialiased points and lines in eighths of a pixel, for sizes from 1 to 64 (GL 1.3, 3.3).
    static std::int32_t eighths(Real size) {
        return numeric::clamp<std::int32_t>(((numeric::to_fixed(size, 16) >> 12) + 1) >> 1, 8, 512);
    }
    /// Polygons are outlined, captured or antialiased as a whole, so they may not be divided into triangles.
    bool is_drawn_whole() const {
        return has_outlines() || is_capturing() || fills_whole_polygons();
    }
    bool is_capturing() const {
        return (SPANGLE_FEATURE_SELECTION || SPANGLE_FEATURE_FEEDBACK) && is_capturing_;
    }
    bool has_color_index() const {
        return raster::has_indices && index_bits_ != 0;
    }
    /// Primitives are clipped to the view volume itself, not to the guard band. Outlines draw the edges that
    /// clipping makes, and captures report its result. A wide line ends where its middle leaves the volume.
    bool clips_to_view_volume() const {
        return has_outlines() || is_capturing() || clips_wide_lines_;
    }
    /// The planes to clip by; bit i: plane i. `flags`: the flags of all corners of a primitive, together.
    unsigned clip_planes(unsigned flags) const {
        return clips_to_view_volume() ? flags & outside_mask : (flags & beyond_mask) >> beyond_shift;
    }

    static void set_normal([[maybe_unused]] ObjectVertex& v, [[maybe_unused]] const Real (&normal)[3]) {
#if SPANGLE_FEATURE_LIGHTING || SPANGLE_FEATURE_TEXGEN
        for (int c = 0; c < 3; ++c)
            v.normal[c] = normal[c];
#endif
    }

    template <int N> static bool equal_words(const Real* a, const Real* b) {
        std::uint32_t differ = 0;
        for (int i = 0; i < N; ++i)
            differ |= a[i].bits ^ b[i].bits;
        return differ == 0;
    }

    /// Vertices of lines and strips that are not drawn yet. The fresh ones among them have clip coordinates,
    /// in `projections`, but are not divided by w yet.
    struct Pending {
        Vertex *vertex[pending_vertices], *fresh[line_batch];
        typename M::template Projections<line_batch> projections;
        int count = 0, unprojected_count = 0;
        Pending() { vertex[0] = vertex[1] = nullptr; } // may be asked for while count is 0
    };

    struct Corner {
        const Vertex& vertex;
        const Window& window; ///< the window vertex of the side that is seen
    };
    /// The corners of a polygon whose front or back is seen. Only a back has window vertices of its own.
    struct VisibleFace {
        Vertex* const* corners;
        const Window* back = nullptr;
        const Window& operator()(int i) const { return back != nullptr ? back[i] : corners[i]->window; }
    };

    // pipeline_vertex.hpp
    [[gnu::noinline]] void transform_vertex(Vertex& v) const;
    [[gnu::noinline]] void process_common(Vertex& v, const std::uint8_t* words) const;
    SPANGLE_INLINE void divide(Vertex& v) const;
    SPANGLE_INLINE void set_flags(Vertex& v, bool divided, unsigned planes) const;
    SPANGLE_INLINE void set_attributes_of(const CurrentState& current, Vertex& v);
    SPANGLE_INLINE void set_unlit_color(const CurrentState& current);
    [[gnu::noinline]] typename M::Eye texture_of(const CurrentState& current, const Vertex& v,
                                                 int unit) const;
    bool has_texgen(int unit) const;
    [[gnu::noinline]] void generate_texture_coords(const CurrentState& current, Vertex& v, int unit);
    [[gnu::noinline]] void set_texture_coords(const CurrentState& current, Vertex& v);
    [[gnu::noinline]] unsigned undivided_flags(const Vertex& v) const;
    template <class Point> [[gnu::noinline]] static unsigned flags_of(const Point& clip);
    [[gnu::noinline]] void light(const Vertex& v, int side, Window& out);
    [[gnu::noinline]] void take_vertex_state(const CurrentState& current, Vertex& v);
    [[gnu::noinline]] unsigned outside(const Vertex& v) const;
    void color(Vertex& v);
    [[gnu::noinline]] void light(Vertex& v);
    void color_back(Vertex& v);
    void light_back(const Vertex& v, Window& out);
    [[gnu::noinline]] bool project(Vertex& v);

    // pipeline_position_cache.hpp
#if SPANGLE_VERTEX_CACHE != 1
    [[gnu::noinline]] void cache_positions();
    [[gnu::noinline]] void cache_elements();
    [[gnu::noinline]] void clear_cache();
    [[gnu::noinline]] void transform_with_cache(Vertex& v);
    static std::uint32_t cached_position_index(const Real* position);
#endif

    // pipeline_elements.hpp
    void draw_cached_elements(Context& context, const ElementReader& reader, std::uint32_t count,
                              const Indices& indices);
    void grow_cache(Context& context, std::uint32_t count);
    void arrays_begin(const ElementReader& reader, const CurrentState& current, bool textured);
    bool draws_lines() const;
    bool is_common(const ElementReader& reader) const;
    bool is_common_texture(const ElementReader& reader) const;
    Vertex& cached(std::uint32_t index);
    void next_element(const CurrentState& current, Vertex& kept, const Real (&position)[4]);
    Vertex& element(const ElementReader& reader, std::uint32_t index);
    SPANGLE_INLINE Vertex& general_element(Context& context, const ElementReader& reader,
                                           std::uint32_t index);
    template <class Place, class Finish>
    SPANGLE_INLINE Vertex& common_element(const ElementReader& reader, std::uint32_t index, bool normals,
                                          bool textured, const Place& transform_with_cache,
                                          const Finish& finish);
    SPANGLE_INLINE static void read_position(const std::uint8_t* words, Vertex& v);
    [[gnu::noinline]] void read_texture(const std::uint8_t* words, Vertex& v);
    SPANGLE_INLINE static bool equal(const Real* v, const std::uint8_t* words);
    SPANGLE_INLINE static bool equal_texture(const Vertex& v, const std::uint8_t* words);
    void draw_line_elements(const ElementReader& reader, std::uint32_t count, const Indices& indices,
                            bool normals);
    bool draws_places() const;
    template <class I> void draw_line_strip(const ElementReader& reader, std::uint32_t count, I indices);
    template <class I>
    [[gnu::noinline]] std::uint32_t draw_visible_strip(const ElementReader& reader, std::uint32_t count,
                                                       I indices, const raster::DrawState::Area& area) const;
    template <class I>
    [[gnu::noinline]] void draw_lines_of_elements(const ElementReader& reader, std::uint32_t count, I indices,
                                                  bool normals);
    void draw_strip_elements(const ElementReader& reader, std::uint32_t count, const Indices& indices,
                             bool normals, bool textured);
    template <class I>
    [[gnu::noinline]] void draw_strip_of_elements(const ElementReader& reader, std::uint32_t count, I indices,
                                                  bool normals, bool textured);
    template <class I>
    [[gnu::noinline]] void draw_strip_batches(const ElementReader& reader, std::uint32_t count, I indices,
                                              bool normals, bool textured);
    [[gnu::noinline]] void draw_strip(Pending& p, std::uint32_t first);
    void release_drawn(Pending& p, int left);
    SPANGLE_INLINE void add_unprojected(Pending& p, Vertex& v, const std::uint8_t* words);
    void divide(Pending& lines);
    [[gnu::noinline]] void draw_pending(Pending& p);
    SPANGLE_INLINE Vertex& slot_for_vertex(Vertex& cached);
    [[gnu::noinline]] Vertex* free_slot();
    int repeated_elements() const;
    void draw_elements(Context& context, const ElementReader& reader, std::uint32_t count,
                       const Indices& indices);
    template <class... V> bool is_outside_rows(const V&... corner) const;
    [[gnu::noinline]] void draw_elements_immediate(Context& context, const ElementReader& reader,
                                                   std::uint32_t count, const Indices& indices);

    // pipeline_assembly.hpp
    static int corners_of(GLenum mode);
    void swap(int i, int j);
    [[gnu::noinline]] void primitive();
    [[gnu::noinline]] void begin_polygon();
    [[gnu::noinline]] void end_polygon();
    [[gnu::noinline]] void outlined_fan(bool last);
    void flag_edges(Vertex* const* corners, int n);
    int first_corner(int n) const;
    template <int N> SPANGLE_INLINE void draw_face(Vertex* const* c, int provoking);

    // pipeline_primitives.hpp
    void point(Vertex& v);
    void draw_point(const Vertex& v, const Window& window);
    [[gnu::noinline]] void draw_special_point(const Vertex& v, const Window& window);
#if SPANGLE_FEATURE_POINT_PARAMETERS
    Real attenuated_size(const Vertex& v) const;
    Real fade_point(Real size, Window& point) const;
    void draw_sprite(const raster::Surface& target, const Window& point, std::int32_t eighths);
#endif
    void draw_line(const Vertex& a, const Window& at_a, const Vertex& b, const Window& at_b,
                   const Window& provoking);
    [[gnu::noinline]] void draw_special_line(const Window& a, const Window& b, const Window& provoking);
    void line(Vertex& a, Vertex& b);
    [[gnu::noinline]] void lines(Vertex* const* vertex, int n, int step, bool one_color);
    [[gnu::noinline]] void draw_visible_line(Vertex& a, Vertex& b);
    [[gnu::noinline]] void clip_and_draw_line(Vertex& a, Vertex& b);
    static std::int64_t area_of(const Window& a, const Window& b, const Window& c);
    static std::int64_t area_of(Vertex* const* corners, int n);
    [[gnu::noinline]] void triangle(Vertex& a, Vertex& b, Vertex& c);
    SPANGLE_INLINE void draw_common_triangle(Vertex& a, Vertex& b, Vertex& c, bool whole);
    void draw_quad(Vertex& a, Vertex& b, Vertex& c, Vertex& d, Vertex& provoking);
    [[gnu::noinline]] void polygon(Vertex* const* corners, int n, Vertex& provoking);
    /// `part` has room for n areas. `whole` has the sign of the area before the polygon was cut, or is 0.
    void draw_visible(Vertex* const* corners, int n, Vertex& provoking, std::int64_t* part,
                      std::int64_t whole);
    SPANGLE_INLINE void draw(const VisibleFace& at, int n, const Window& provoking, int side,
                             const std::int64_t* part);
    [[gnu::noinline]] void fill_whole_polygon(const VisibleFace& at, int n, const Window& provoking,
                                              const std::int64_t* part);
    [[gnu::noinline]] void fill_polygon(const Window* const* corner, int n, const Window& provoking,
                                        const std::int64_t* part);
    [[gnu::noinline]] void set_offset(const VisibleFace& at, int n, GLenum mode, const std::int64_t* part);
    [[gnu::noinline]] void outline(const VisibleFace& at, int n, const Window& provoking, GLenum mode);
    [[gnu::noinline]] void draw_back(Vertex* const* corners, int n, const Vertex& provoking,
                                     const std::int64_t* part);

    // pipeline_capture.hpp
    [[gnu::noinline]] void capture_line(const Corner& a, const Corner& b, const Window& provoking);
    [[gnu::noinline]] void begin_capture(GLenum token, int n);
    [[gnu::noinline]] void capture_vertex(const Corner& corner);
#if SPANGLE_FEATURE_FEEDBACK
    void write_feedback_vertex(const Corner& corner);
#endif
    [[gnu::noinline]] void capture_clipped_line(Vertex& a, Vertex& b);

    // pipeline_gather.hpp
    bool gathers_polygons() const;
    bool has_gathered() const;
    [[gnu::noinline]] void gather(Vertex& v);
    [[gnu::noinline]] void draw_gathered();
    void clip_gathered(Vertex** work, int room, std::int64_t* part);
    void free_gathered();

    // pipeline_reach.hpp
    [[gnu::noinline]] void record_draw_reach() const;
    [[gnu::noinline]] void record_vertex_reach(const CurrentState& current, const Vertex& v) const;
    void record_clip_reach(unsigned flags) const;

    // pipeline_clip.hpp
    bool needs_eye() const;
    [[gnu::noinline]] ClippedVertex& to_clip_vertex(Vertex& v, ClippedVertex& out);
    [[gnu::noinline]] void mix(const ClippedVertex& a, const ClippedVertex& b, const typename M::Parameter& t,
                               ClippedVertex& out);
    int clip_volume_scale() const;
    static bool needs_clipping(unsigned flags);
    bool refuse_clipping(unsigned flags);
    bool is_inside_plane(int plane, const ClippedVertex& v) const;
    void clip_edge(int plane, const ClippedVertex& inside, const ClippedVertex& outside, ClippedVertex& out);
#if SPANGLE_FEATURE_CLIP_PLANES
    void clip_by_user_plane(const typename M::Plane& plane, const ClippedVertex& inside,
                            const ClippedVertex& outside, ClippedVertex& out);
#endif
    bool clip_line(Vertex* (&ends)[2]);
    ClippedVertex* free_clipped_vertex();
    void keep_clipped_vertices(Vertex* const* corners, int n);
    int clip_polygon(Vertex** corners, Vertex** work, int room, int n, unsigned planes);
};

} // namespace spangle::gl

#include "gl/vertex/pipeline_assembly.hpp"
#include "gl/vertex/pipeline_capture.hpp"
#include "gl/vertex/pipeline_clip.hpp"
#include "gl/vertex/pipeline_elements.hpp"
#include "gl/vertex/pipeline_gather.hpp"
#include "gl/vertex/pipeline_line_strips.hpp"
#include "gl/vertex/pipeline_points.hpp"
#include "gl/vertex/pipeline_position_cache.hpp"
#include "gl/vertex/pipeline_primitives.hpp"
#include "gl/vertex/pipeline_reach.hpp"
#include "gl/vertex/pipeline_vertex.hpp"
