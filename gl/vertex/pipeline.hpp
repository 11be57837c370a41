// The vertex pipeline turns vertices as given into primitives in window space. Its steps are: transform,
// assemble, clip, cull, light and draw. It is one template for all numeric policies: M supplies the
// arithmetic and L the lighting. This header has what all parts of the pipeline share. A comment above each
// group of member functions names the file that defines them.
//
// The order of steps is that of GL 1.3, figure 2.8, as far as a program can see it. Colours are computed
// late, only for vertices of primitives that survive culling. The pictures are the same, since no step in
// between changes the colour of a vertex.
#pragma once

#include <bit>
#include <new>
#include <type_traits>

#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "gl/pixel/targets.hpp"
#include "gl/vertex/capture.hpp"
#include "gl/vertex/current_element.hpp"
#include "gl/vertex/draw_modes.hpp"
#include "gl/vertex/primitive_assembler.hpp"
#include "gl/vertex/texgen.hpp"
#include "gl/vertex/user_planes.hpp"
#include "gl/vertex/vertex_cache.hpp"
#include "gl/vertex/vertex_kinds.hpp"
#include "raster/band/batch_rows.hpp"
#include "raster/primitive/draw.hpp"
#include "raster/primitive/line_end.hpp"
#include "raster/primitive/line_stipple.hpp"
#include "raster/primitive/polygon_offset.hpp"

namespace spangle::gl {

/// Draws the fragments that `source` places, with colour, depth and texture coordinates of the current raster
/// position.
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
    using Vertex = gl::Vertex<M>;
    using ClippedVertex = gl::ClippedVertex<M, L>;

    void begin(Context& context, GLenum mode) {
        context_ = &context;
        assembler_.begin(mode, vertex_slot_);
        restarts_stipple_ = true;
        if (begins_outside_band(context))
            return;
        derive(context, mode);
        if (tells_reach && is_told(context)) [[unlikely]]
            record_draw_reach();
        if (mode == GL_POLYGON && modes_.gathers_polygons())
            assembler_.set_form(PolygonForm::gathered);
        else if (mode == GL_POLYGON && modes_.has_outlines())
            assembler_.set_form(PolygonForm::outlined);
        const PrimitiveKind drawn = mode == GL_POINTS       ? PrimitiveKind::points
                                    : mode <= GL_LINE_STRIP ? PrimitiveKind::lines
                                                            : PrimitiveKind::polygons;
        state_ = &draw_state(context, drawn);
        context.fragments.primitive.stippled = drawn == PrimitiveKind::polygons;
    }

    SPANGLE_INLINE void vertex(Context& context, Real x, Real y, Real z, Real w) {
        if (is_outside_band())
            return;
        Vertex& v = assembler_.next();
        const CurrentState& current = context.current;
        v.position[0] = x;
        v.position[1] = y;
        v.position[2] = z;
        v.position[3] = w;
        v.set_normal(current.normal);
        if constexpr (caches_window_positions)
            transform_with_cache(v);
        else
            transform_vertex(v);
        set_attributes_of(current, v);
        if (modes_.needs_vertex_state())
            take_vertex_state(current, v);
        if (assembler_.take_next())
            primitive();
    }

    /// Takes elements of the enabled arrays, as if ArrayElement gave them one by one.
    void elements(Context& context, std::uint32_t count, const Indices& indices);

    void end() {
        if (!is_outside_band())
            assembler_.end(*this);
        if constexpr (skips_batches)
            if (batches_ != nullptr)
                batches_->end_batch();
    }

    /// Sets the current raster position from a vertex that is not drawn (RasterPos; GL 1.3, 2.12). If the
    /// vertex is outside of the clip volume, only `valid` changes.
    void raster_position(Context& context, const Real (&position)[4]);

    /// Lights the vertices given so far with the old material. It is called before a material changes.
    void settle_colors();

  private:
    /// True if vertices of line strips bypass the cache. A small cache forgets a vertex before the next strip
    /// asks for it.
    static constexpr bool skips_cache_for_strips =
        vertex_cache < 1024 && raster::has_shortcuts && std::is_same_v<Window, raster::FixedVertex>;
    /// Number of vertices that a Pending holds. A line strip of line_batch lines has one vertex more than
    /// lines.
    static constexpr int pending_vertices = (numeric::cheap_branches ? 1 : 4) * line_batch + 1;
    /// True if triangles and quads are drawn as polygons, as all builds without shortcuts do.
    static constexpr bool faces_are_polygons = has_polygons && !raster::has_shortcuts;
    static constexpr int slot_count = PrimitiveAssembler<Vertex>::slot_count;
    /// Number of corners that a quad may have while it is clipped. Each plane of the view volume and of the
    /// user adds at most one corner, and clip_polygon() wants room for two more at every edge. A
    /// ClippedVertex that one plane cut off is used again for the next plane.
    static constexpr int clip_vertices = slot_count + 6 +
                                         (SPANGLE_FEATURE_CLIP_PLANES ? max_clip_planes : 0) + 2 + clip_spare,
                         clipped_vertex_count = clip_vertices + clip_spare;
    static_assert(clipped_vertex_count <= 32);
    static_assert(has_clipping || !(SPANGLE_FEATURE_CLIP_PLANES || SPANGLE_FEATURE_POLYGON_MODE ||
                                    SPANGLE_FEATURE_SELECTION || SPANGLE_GATHERS_POLYGONS),
                  "user's planes, outlines, selection, feedback and antialiasing need SPANGLE_CLIPPING");
    static_assert(raster::has_perspective || !has_clipping, "what SPANGLE_CLIPPING cuts has a w of its own");

    /// Draws of many elements are divided into pieces of this number of elements. Each band draws or skips a
    /// piece as a whole.
    static constexpr std::uint32_t piece = 12;
    static constexpr bool skips_batches = SPANGLE_FEATURE_BANDS != 0;

    Context* context_ = nullptr;
    /// Batches of the drawable while a callback draws its bands, else null. It is null in render modes SELECT
    /// and FEEDBACK, too.
    raster::BatchRows* batches_ = nullptr;
    const raster::DrawState* state_ = nullptr;
    DrawModes modes_;
    /// Bit u is set if unit u needed r when the cached vertices were made.
    unsigned units_with_r_ = 0;
    bool restarts_stipple_ = false; ///< true if the next line starts the stipple pattern anew
    PrimitiveAssembler<Vertex> assembler_;
    ObjectVertex object_vertex_; ///< position and normal of the current element
    raster::LineStipple stipple_;
    typename M::Transforms transforms_;
    L lighting_;
    UserPlanes<M> planes_;
    TexGen<M> texgen_;
    Window unlit_{};           ///< the current colour as the rasterizer takes it
    Real unlit_color_[4] = {}; ///< the current colour from which unlit_ was made
    bool has_unlit_color_ = false;
#if SPANGLE_CLIPPING
    /// Bit i is set if clipped_vertex_[i] is free: it is no corner of the polygon that is being clipped.
    std::uint32_t free_clipped_vertices_ = 0;
#endif
#if SPANGLE_GATHERS_POLYGONS
    /// Corners of a polygon that is drawn when it ends, allocated in the arena.
    ClippedVertex* gathered_ = nullptr;
    int gathered_count_ = 0, gathered_capacity_ = 0;
    /// Room for the corners that clipping leaves of the gathered polygon.
    const Window** gathered_windows_ = nullptr;
    bool gathering_failed_ = false; ///< true if the arena had no room for all corners
#endif
    Vertex vertex_slot_[slot_count];
#if SPANGLE_TWO_SIDES
    /// Colours of the backs of vertex_slot_, set where the flags have back_known.
    typename M::Colors back_colors_[slot_count];
#endif
#if SPANGLE_FEATURE_FEEDBACK
    /// Texture coordinates of unit 0 of vertex_slot_, set in render mode FEEDBACK.
    typename M::Eye texture_coords_[slot_count];
#endif
    VertexCache<M> cache_;
#if SPANGLE_CLIPPING
    ClippedVertex clipped_vertex_[clipped_vertex_count];
#endif

    /// Begins a batch if a callback draws bands. True: no part of the batch reaches the current band.
    bool begins_outside_band([[maybe_unused]] const Context& context) {
        if constexpr (skips_batches) {
            batches_ = context.render.draws() ? context.drawable.batches : nullptr;
            return batches_ != nullptr && !batches_->begin_batch();
        }
        return false;
    }
    /// True from begin() to end() of a batch that is left out of the current band.
    bool is_outside_band() const {
        return skips_batches && batches_ != nullptr && batches_->is_skipped();
    }

    void derive(Context& context, GLenum mode) {
        if (const unsigned dirty = context.dirty & dirty_vertex; dirty != 0) {
            if ((dirty & (dirty_matrices | dirty_others)) != 0) {
                M::derive(context.transform, transforms_);
                planes_.derive(context.transform);
                texgen_.derive(context);
            }
            lighting_.derive(context, dirty);
            context.dirty = static_cast<std::uint8_t>(context.dirty & ~dirty_vertex);
            cache_.invalidate();
        }
        modes_.derive(context, mode, {lighting_.two_sided(), lighting_.tracks_color(), planes_.any()});
        if (modes_.has_color_sum())
            has_unlit_color_ = false;
        if (const unsigned thirds = modes_.units() >> third_coordinate; thirds != units_with_r_) {
            units_with_r_ = thirds;
            cache_.invalidate();
        }
#if SPANGLE_FEATURE_STIPPLE
        stipple_.pattern = context.polygon.stipple_pattern;
        stipple_.factor = static_cast<std::uint32_t>(context.polygon.stipple_factor);
#endif
    }

    /// Planes that a primitive must be clipped by; bit p stands for plane p. `flags` is the union of the
    /// flags of all corners.
    unsigned clip_planes(unsigned flags) const {
        return modes_.clips_to_view_volume() ? flags & outside_mask : (flags & beyond_mask) >> beyond_shift;
    }

    /// Vertices of lines and strips that are not drawn yet. `projections` holds the clip coordinates of
    /// `fresh`, the vertices among them that are not yet divided by w.
    struct Pending {
        Vertex *vertex[pending_vertices], *fresh[line_batch];
        typename M::template Projections<line_batch> projections;
        int count = 0, unprojected_count = 0;
        Pending() { vertex[0] = vertex[1] = nullptr; } // vertex[0] and [1] are read even while `count` is 0
    };

    struct Corner {
        const Vertex& vertex;
        const Window& window; ///< window vertex of the side that is seen
    };
    /// Corners of a polygon with the window vertices of the side that is seen. `back` holds those of a back
    /// face; it is null for a front face.
    struct VisibleFace {
        Vertex* const* corners;
        const Window* back = nullptr;
        const Window& operator()(int i) const { return back != nullptr ? back[i] : corners[i]->window; }
    };

    // Defined in pipeline_vertex.hpp:
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

    // Defined in pipeline_position_cache.hpp:
#if SPANGLE_VERTEX_CACHE != 1
    [[gnu::noinline]] void transform_with_cache(Vertex& v);
#endif

    // Defined in pipeline_elements.hpp:
    void draw_cached_elements(Context& context, const ElementReader& reader, std::uint32_t count,
                              const Indices& indices);
    void arrays_begin(const ElementReader& reader, const CurrentState& current, bool textured);
    bool draws_lines() const;
    bool is_common(const ElementReader& reader) const;
    bool is_common_texture(const ElementReader& reader) const;
    void next_element(const CurrentState& current, Vertex& kept, const Real (&position)[4]);
    Vertex& element(const ElementReader& reader, std::uint32_t index);
    SPANGLE_INLINE Vertex& general_element(Context& context, const ElementReader& reader,
                                           std::uint32_t index);
    template <class Place, class Finish>
    SPANGLE_INLINE Vertex& common_element(const ElementReader& reader, std::uint32_t index, bool normals,
                                          bool textured, const Place& place, const Finish& finish);
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
    int repeated_elements() const;
    void draw_elements(Context& context, const ElementReader& reader, std::uint32_t count,
                       const Indices& indices);
    template <class... V> bool is_outside_rows(const V&... corner) const;
    [[gnu::noinline]] void draw_elements_immediate(Context& context, const ElementReader& reader,
                                                   std::uint32_t count, const Indices& indices);

    // Defined in pipeline_assembly.hpp, as sink of the assembler:
    friend PrimitiveAssembler<Vertex>;
    [[gnu::noinline]] void primitive();
    SPANGLE_INLINE void triangle(Vertex* const* c);
    SPANGLE_INLINE void quad(Vertex* const* c);
    void fan(Vertex* const* c);
    void outlined_fan(Vertex* const* c, bool first, bool last);
    void gathered();
    void flag_edges(Vertex* const* corners, int n);
    int first_corner(int n) const;

    // Defined in pipeline_primitives.hpp:
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
    [[gnu::noinline]] void draw_triangle(Vertex& a, Vertex& b, Vertex& c);
    SPANGLE_INLINE void draw_common_triangle(Vertex& a, Vertex& b, Vertex& c, bool whole);
    void draw_quad(Vertex& a, Vertex& b, Vertex& c, Vertex& d, Vertex& provoking);
    [[gnu::noinline]] void polygon(Vertex* const* corners, int n, Vertex& provoking);
    /// Draws a polygon that clipping and culling left. `part` has room for n areas. `whole` has the sign of
    /// the polygon's area before clipping, or is 0.
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

    // Defined in pipeline_capture.hpp:
    [[gnu::noinline]] void capture_line(const Corner& a, const Corner& b, const Window& provoking);
    [[gnu::noinline]] void begin_capture(GLenum token, int n);
    [[gnu::noinline]] void capture_vertex(const Corner& corner);
#if SPANGLE_FEATURE_FEEDBACK
    void write_feedback_vertex(const Corner& corner);
#endif
    [[gnu::noinline]] void capture_clipped_line(Vertex& a, Vertex& b);

    // Defined in pipeline_gather.hpp:
    bool has_gathered() const;
    [[gnu::noinline]] void gather(Vertex& v);
    [[gnu::noinline]] void draw_gathered();
    void clip_gathered(Vertex** work, int room, std::int64_t* part);
    void free_gathered();

    // Defined in pipeline_reach.hpp:
    [[gnu::noinline]] void record_draw_reach() const;
    [[gnu::noinline]] void record_vertex_reach(const CurrentState& current, const Vertex& v) const;
    void record_clip_reach(unsigned flags) const;

    // Defined in pipeline_clip.hpp:
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
