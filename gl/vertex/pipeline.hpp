// From a vertex as given to primitives in window space: transform, assemble, clip, cull, light, draw. One
// template for every numeric policy; M supplies the arithmetic and L the lighting.
//
// Order (GL 1.3, figure 2.8) as far as it can be seen. Colours are computed late, for vertices of primitives
// that survive culling: a vertex's colour depends on nothing that happens in between.
#pragma once

#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "gl/vertex/capture.hpp"
#include "gl/vertex/current_element.hpp"
#include "gl/vertex/texgen.hpp"
#include "gl/vertex/user_planes.hpp"
#include "raster/primitive/draw.hpp"

namespace spangle::gl {

template <class M, class L> class Pipeline {
  public:
    using Window = typename M::Window;

    void begin(Context& context, GLenum mode) {
        context_ = &context;
        mode_ = mode;
        full_ = corners_of(mode);
        held_ = 0;
        odd_ = false;
        stipple_starts_ = true;
        for (int i = 0; i < slot_count; ++i)
            corner_[i] = &slot_[i];
        derive(context);
        if (outlined() && mode == GL_POLYGON)
            full_ = 4; // the last triangle has an edge more than those before
        state_ = &draw_state(context);
    }

    void vertex(Context& context, Real x, Real y, Real z, Real w) {
        Vertex& v = *corner_[held_];
        const CurrentState& current = context.current;
        v.position[0] = x;
        v.position[1] = y;
        v.position[2] = z;
        v.position[3] = w;
        for (int c = 0; c < 3; ++c)
            v.normal[c] = current.normal[c];
        process(v);
        attributes(current, v);
        if (each_vertex_)
            given(current, v);
        if (++held_ == full_)
            primitive();
    }

    /// Elements of the arrays that are on, as ArrayElement gives them one by one.
    void elements(Context& context, std::uint32_t count, const Indices& indices) {
        const ElementReader reader(context.arrays);
        CurrentState& current = context.current;
        if (each_vertex_ || reader.seldom != nullptr || !reader.vertex.on())
            return elements_in_turn(context, reader, count, indices);
        const bool textured = is_usual_texture(reader), normals = lit_ && reader.normal.on();
        arrays_begin(reader, current, textured);
        if (!lit_)
            set_unlit_color(current);
        const auto next = [&](Vertex& v) {
            corner_[held_] = &v;
            if (++held_ == full_)
                primitive();
        };
        if (!is_usual(reader) || (reader.textured || units_ != 0) != textured)
            for (std::uint32_t i = 0; i < count; ++i)
                next(unusual_element(context, reader, indices.at(i)));
        else if (has_lines())
            line_elements(reader, count, indices, normals);
        else if (mode_ == GL_TRIANGLE_STRIP)
            strip_elements(reader, count, indices, normals, textured);
        else
            for (std::uint32_t i = 0; i < count; ++i)
                next(corner_element(reader, indices.at(i), normals, textured,
                                    [this](Vertex& cached) -> Vertex& { return place_of(cached); }));
        if (count == 0)
            return;
        if (reader.normal.on())
            reader.normal.read(indices.at(count - 1), current.normal);
        set_texture(current, reader, indices.at(count - 1));
    }

    void end() {
        if (mode_ == GL_LINE_LOOP && held_ == 2)
            line(*corner_[1], *corner_[0]);
        if (outlined() && mode_ == GL_POLYGON && held_ == 3)
            outlined_fan(true);
    }

    /// RasterPos: a vertex that is not drawn. Outside of the clip volume only `valid` changes.
    void raster_position(Context& context, const Real (&position)[4]) {
        context_ = &context;
        derive(context);
        const CurrentState& current = context.current;
        Vertex& v = slot_[0];
        for (int c = 0; c < 4; ++c)
            v.position[c] = position[c];
        for (int c = 0; c < 3; ++c)
            v.normal[c] = current.normal[c];
        const typename M::Clip clip = M::to_clip(transforms_, v.position);
        RasterPosition& out = context.current.raster;
        out.valid =
            (flags_of(clip) & outside_mask) == 0 && M::in_front(clip) && (!planes_.any() || outside(v) == 0);
        if (!out.valid)
            return;
        Real eye[4];
        M::reals(M::to_eye(transforms_, v.position), eye);
        M::window_of(transforms_, clip, out.position);
        out.distance = numeric::abs(eye[2]);
        out.index = current.index;
        v.flags = 0;
        if (lit_)
            light(v, 0, v.window);
        for (int c = 0; c < 4; ++c)
            out.color[c] = numeric::clamp01(current.color[c]);
        if (lit_)
            M::color_of(v.window, out.color);
        for (int u = 0; u < texture_units; ++u)
            M::reals(texture_of(current, v, u), out.tex_coord[u].v);
#if SPANGLE_FEATURE_SELECTION
        if (context.render.mode == GL_SELECT) {
            M::project(transforms_, clip, v.window);
            record_hit(context, M::depth_word(v.window), M::depth_word(v.window));
        }
#endif
    }

    /// A material is about to change: vertices given so far get their colours from the old one.
    void settle_colors() {
        for (int i = 0; i < held_; ++i)
            color(*corner_[i]);
        lighting_.materials_changed();
    }

  private:
    /// Vertex::flags: bits 0..5 the view-volume planes it lies outside of, from bit 8 on the planes (guard
    /// band, near, far) it must be clipped by, then what is still to be done.
    static constexpr int user_shift = 6; ///< the user's planes behind those of the view volume
    static constexpr unsigned outside_mask = 0x3F, beyond_shift = 8, beyond_mask = 0x3F << beyond_shift,
                              unprojected = 1 << 14, ///< has no window coordinates yet
        uncolored = 1 << 15,
                              is_cut = 1 << 16, ///< it is a Cut
        edge_flag = 1 << 17,                    ///< as the vertex was given
        boundary = 1 << 18,   ///< of the polygon at hand: the edge that starts here is drawn in outlines
        is_pending = 1 << 19; ///< lines that it is an end of are still to be drawn

    struct Given {
        Real position[4]{numeric::zero, numeric::zero, numeric::zero, numeric::one}, normal[3]{};
    };
    struct Vertex : Given {
        std::uint32_t flags = 0;
        std::uint32_t time = 0; ///< in the cache: good while this is now_
        Real st[2]{};           ///< what read_texture() made window.tex of
        Window window{};
    };
    /// A vertex while it is clipped, or one that clipping made: what the others compute when they need it.
    struct Cut : Vertex {
        typename M::Clip clip{};
        typename M::Depth eye_z{}; ///< with its sign: clipping mixes it, fog takes its size
        typename M::Eye eye{};
        typename L::Input light{};
#if SPANGLE_FEATURE_FEEDBACK
        typename M::Eye texture{}; ///< while primitives are fed back
#endif
    };
    /// A quad gets a corner more at each plane of the volume and of the user; those a plane took away stay
    /// among the Cuts.
    static constexpr int slot_count = 4, clip_vertices = SPANGLE_FEATURE_CLIP_PLANES ? 20 : 16,
                         cut_count = SPANGLE_FEATURE_CLIP_PLANES ? 28 : 20;
    static constexpr int line_batch = numeric::cheap_branches ? 8 : 16; ///< lines under way, even

    Context* context_ = nullptr;
    const raster::DrawState* state_ = nullptr;
    GLenum mode_ = GL_POINTS;
    int held_ = 0, full_ = 1; ///< corners held, and how many make a primitive
    bool odd_ = false;        ///< number of triangles of the strip so far
    bool fog_ = false, lit_ = false, flat_ = false, two_sided_ = false;
    unsigned units_ = 0;                       ///< bit u: texture unit u is on
    bool each_vertex_ = false;                 ///< something more happens to vertices when they are given
    bool whole_polygons_ = false;              ///< triangles, too, go the way of polygons
    bool outlines_ = false;                    ///< PolygonMode makes lines or points of some face
    bool captures_ = false;                    ///< primitives are selected or fed back, not drawn
    bool stipple_starts_ = true;               ///< no line since the pattern was to start anew
    GLenum face_mode_[2] = {GL_FILL, GL_FILL}; ///< of front and back
    bool front_is_ccw_ = true, culls_ccw_ = false, culls_cw_ = false;
    Vertex* corner_[slot_count] = {}; ///< of the primitive being assembled
    unsigned layout_ = 0;             ///< of the arrays that the cached vertices came from
    Given given_;                     ///< the element at hand
    Real given_color_[4] = {};        ///< current during the last draw of elements
    std::uint32_t now_ = 1;           ///< of cached vertices; another one when their results would differ
    std::int32_t point_size_ = 1, line_width_ = 1;
    typename M::Transforms transforms_;
    L lighting_;
    UserPlanes<M> planes_;
    TexGen<M> texgen_;
    Window unlit_{};           ///< holds the current colour in the rasterizer's units
    Real unlit_color_[4] = {}; ///< of which this was converted
    bool has_unlit_color_ = false;
    Vertex slot_[slot_count];
    Vertex cache_[SPANGLE_VERTEX_CACHE]; ///< of elements, by their index
    Cut cut_[cut_count];
#if SPANGLE_FEATURE_FEEDBACK
    typename M::Eye texture_[slot_count]; ///< of slot_, while primitives are fed back
#endif

    void derive(Context& context) {
        if ((context.dirty & dirty_vertex) != 0) {
            M::derive(context.transform, transforms_);
            lighting_.derive(context);
            planes_.derive(context.transform);
            texgen_.derive(context);
            context.dirty = static_cast<std::uint8_t>(context.dirty & ~dirty_vertex);
            forget();
        }
        fog_ = context.fog.fog;
        lit_ = context.lighting.lighting;
        two_sided_ = lighting_.two_sided();
        units_ = 0;
        for (int u = 0; u < texture_units; ++u)
            units_ |= context.texture.unit[u].texture_2d ? 1u << u : 0u;
        const PolygonState& polygon = context.polygon;
        flat_ = polygon.shade_model == GL_FLAT;
        front_is_ccw_ = polygon.front_face == GL_CCW;
        culls_ccw_ = culls(polygon, front_is_ccw_);
        culls_cw_ = culls(polygon, !front_is_ccw_);
        for (int side = 0; side < 2; ++side)
            face_mode_[side] = polygon.mode[side];
        captures_ = !context.render.draws();
        outlines_ =
            (face_mode_[0] != GL_FILL || face_mode_[1] != GL_FILL) && context.render.mode != GL_SELECT;
        each_vertex_ = lighting_.tracks_color() || outlined() || captures();
        whole_polygons_ = two_sided_ || exactly_clipped() || planes_.any();
        point_size_ = whole(polygon.point_size);
        line_width_ = whole(polygon.line_width);
    }

    /// No cached vertex is good any more.
    void forget() {
        if (++now_ != 0)
            return;
        for (Vertex& v : cache_)
            v.time = 0;
        now_ = 1;
    }

    static bool culls(const PolygonState& p, bool front) {
        if (!p.cull_face)
            return false;
        return p.cull_face_mode == GL_FRONT_AND_BACK || (p.cull_face_mode == GL_FRONT) == front;
    }

    /// Aliased sizes are rounded, 0 counts as 1 (GL 1.3, 3.3, 3.4.2); the largest is 64.
    static std::int32_t whole(Real size) {
        return numeric::clamp<std::int32_t>(numeric::to_i32_round(size), 1, 64);
    }

    bool outlined() const {
        return SPANGLE_FEATURE_POLYGON_MODE && outlines_;
    }
    bool captures() const {
        return (SPANGLE_FEATURE_SELECTION || SPANGLE_FEATURE_FEEDBACK) && captures_;
    }
    /// The edges that the view volume cuts are seen, or what is left of the primitive is.
    bool exactly_clipped() const {
        return outlined() || captures();
    }
    /// Of flags: the planes to clip by, by number.
    unsigned clip_planes(unsigned flags) const {
        return exactly_clipped() ? flags & outside_mask : (flags & beyond_mask) >> beyond_shift;
    }

    // --- one vertex

    /// Position and normal are set: its place in the window, or what is known of it.
    SPANGLE_INLINE void process(Vertex& v) {
        unsigned planes = 0;
        const bool divided = to_window(v, planes);
        set_flags(v, divided, planes);
    }
    [[gnu::noinline]] bool to_window(Vertex& v, unsigned& planes) const {
        typename M::template Projections<1> projection;
        projection.add(0, transforms_, v.position, v.window, fog_);
        projection.finish();
        return projection.divide(0, transforms_, v.position, v.window, planes);
    }
    SPANGLE_INLINE void set_flags(Vertex& v, bool divided, unsigned planes) {
        v.flags = divided ? planes : flags_of(M::to_clip(transforms_, v.position));
        if (lit_)
            v.flags |= uncolored;
    }

    /// What is current goes with the vertex.
    SPANGLE_INLINE void attributes(const CurrentState& current, Vertex& v) {
        if (units_ != 0)
            textures(current, v);
        if (lit_)
            return;
        set_unlit_color(current);
        M::copy_color(unlit_, v.window);
    }

    SPANGLE_INLINE void set_unlit_color(const CurrentState& current) {
        if (has_unlit_color_ && same<4>(unlit_color_, current.color))
            return;
        M::set_color(unlit_, current.color);
        for (int c = 0; c < 4; ++c)
            unlit_color_[c] = current.color[c];
        has_unlit_color_ = true;
    }

    /// The coordinates that a unit has behind its matrix, all four.
    [[gnu::noinline]] typename M::Eye texture_of(const CurrentState& current, const Vertex& v,
                                                 int unit) const {
        const Real(&given)[4] = current.tex_coord[unit].v;
        typename M::Scalar strq[4] = {M::scalar(given[0]), M::scalar(given[1]), M::scalar(given[2]),
                                      M::scalar(given[3])};
        if (generates(unit))
            texgen_.generate(transforms_, unit, v.position, v.normal, given, strq);
        return M::texture_of(transforms_, strq, unit);
    }

    bool generates(int unit) const {
        return (texgen_.units() >> unit & 1) != 0;
    }

    [[gnu::noinline]] void generated(const CurrentState& current, Vertex& v, int unit) {
        const Real(&given)[4] = current.tex_coord[unit].v;
        typename M::Scalar strq[4];
        texgen_.generate(transforms_, unit, v.position, v.normal, given, strq);
        M::set_texture(transforms_, strq, unit, texgen_.keeps_q(unit) && given[3] == numeric::one, v.window);
    }

    [[gnu::noinline]] void textures(const CurrentState& current, Vertex& v) {
        for (int u = 0; u < texture_units; ++u) {
            if ((units_ >> u & 1) == 0)
                continue;
            if (generates(u))
                generated(current, v, u);
            else
                M::set_texture(transforms_, current.tex_coord[u].v, u, v.window);
        }
    }

    template <int N> static bool same(const Real* a, const Real* b) {
        std::uint32_t differ = 0;
        for (int i = 0; i < N; ++i)
            differ |= a[i].bits ^ b[i].bits;
        return differ == 0;
    }

    /// Cached vertices do not say how many components their arrays had, nor which normal and colour, current
    /// ones, went with all.
    void arrays_begin(const ElementReader& reader, const CurrentState& current, bool textured) {
        const unsigned layout = reader.vertex.components() << 8 | reader.normal.components() << 4 |
                                (textured ? 4u : 0u) | (reader.color.on() ? 2u : 0u) |
                                (reader.textured ? 1u : 0u);
        if (layout != layout_ || !same<4>(given_color_, current.color) ||
            (!reader.normal.on() && !same<3>(given_.normal, current.normal)))
            forget();
        layout_ = layout;
        given_.position[2] = numeric::zero; // what the array leaves out
        given_.position[3] = numeric::one;
        for (int c = 0; c < 3; ++c)
            given_.normal[c] = current.normal[c];
        for (int c = 0; c < 4; ++c)
            given_color_[c] = current.color[c];
    }

    bool has_lines() const {
        return mode_ >= GL_LINES && mode_ <= GL_LINE_STRIP;
    }

    /// Three floats each, and everything else, texture coordinates apart, is current.
    bool is_usual(const ElementReader& reader) const {
        return reader.vertex.is_floats(3) && (!lit_ || !reader.normal.on() || reader.normal.is_floats(3)) &&
               !reader.color.on();
    }

    /// Two floats for the first texture unit, and no other is on.
    bool is_usual_texture(const ElementReader& reader) const {
        bool others = false;
        for (int u = 1; u < texture_units; ++u)
            others = others || reader.tex_coord[u].on();
        return units_ == 1 && reader.tex_coord[0].is_floats(2) && !others && !generates(0) && !has_lines();
    }

    Vertex& cached(std::uint32_t index) {
        return cache_[index % SPANGLE_VERTEX_CACHE];
    }

    /// The vertex of an element, all but its colour and texture coordinates: as it was processed before, if
    /// the arrays still say the same of it.
    Vertex& element(const ElementReader& reader, std::uint32_t index) {
        Vertex& v = cached(index);
        reader.vertex.read(index, given_.position);
        if (reader.normal.on())
            reader.normal.read(index, given_.normal);
        if (v.time == now_ && same<4>(v.position, given_.position) && same<3>(v.normal, given_.normal))
            return v;
        Vertex& fresh = place_of(v);
        static_cast<Given&>(fresh) = given_;
        process(fresh);
        return fresh;
    }

    /// The same with its colour and texture coordinates.
    SPANGLE_INLINE Vertex& unusual_element(Context& context, const ElementReader& reader,
                                           std::uint32_t index) {
        Vertex& v = element(reader, index);
        set_color_and_texture(context, reader, index);
        attributes(context.current, v);
        return v;
    }

    /// The same where is_usual(), and with its colour: all vertices of this time have the same where they are
    /// not lit.
    /// If it is new `place` says where it goes, and `finish` does what process() does.
    template <class Place, class Finish>
    SPANGLE_INLINE Vertex& usual_element(const ElementReader& reader, std::uint32_t index, bool normals,
                                         const Place& place, const Finish& finish) {
        Vertex& v = cached(index);
        const bool of_now = v.time == now_;
        if (of_now && equal(v.position, reader.vertex.words(index)) &&
            (!normals || equal(v.normal, reader.normal.words(index))))
            return v;
        Vertex& fresh = place(v);
        fresh.time = now_;
        reader.vertex.read3(index, fresh.position);
        fresh.position[3] = numeric::one;
        if (normals)
            reader.normal.read3(index, fresh.normal);
        else if (lit_)
            for (int c = 0; c < 3; ++c)
                fresh.normal[c] = given_.normal[c];
        finish(fresh);
        if (!lit_ && !(of_now && &fresh == &v))
            M::copy_color(unlit_, fresh.window);
        return fresh;
    }

    /// The same with the coordinates of is_usual_texture(), if `textured`: kept, too, while the array says
    /// the same.
    template <class Place>
    SPANGLE_INLINE Vertex& corner_element(const ElementReader& reader, std::uint32_t index, bool normals,
                                          bool textured, const Place& place) {
        Vertex& v = usual_element(reader, index, normals, place, [&](Vertex& fresh) {
            process(fresh);
            if (textured)
                read_texture(reader.tex_coord[0].words(index), fresh);
        });
        if (textured) {
            const std::uint8_t* const words = reader.tex_coord[0].words(index);
            if (v.st[0].bits != ArrayReader::word(words, 0) || v.st[1].bits != ArrayReader::word(words, 1))
                read_texture(words, v);
        }
        return v;
    }

    [[gnu::noinline]] void read_texture(const std::uint8_t* words, Vertex& v) {
        for (int i = 0; i < 2; ++i)
            v.st[i] = numeric::from_float_bits(ArrayReader::word(words, i));
        const Real given[4] = {v.st[0], v.st[1], numeric::zero, numeric::one};
        M::set_texture(transforms_, given, 0, v.window);
    }

    SPANGLE_INLINE static bool equal(const Real* v, const std::uint8_t* words) {
        return v[0].bits == ArrayReader::word(words, 0) && v[1].bits == ArrayReader::word(words, 1) &&
               v[2].bits == ArrayReader::word(words, 2);
    }

    /// Lines on their way: vertices, those among them that are still to be divided by w, and clip coordinates
    /// of these.
    struct Pending {
        Vertex *vertex[line_batch + 1], *fresh[line_batch];
        typename M::template Projections<line_batch> projections;
        int count = 0, fresh_count = 0;
    };

    /// Lines of elements, several at a time: transform, division, then what the rasterizer makes of them, so
    /// that none waits for another.
    void line_elements(const ElementReader& reader, std::uint32_t count, const Indices& indices,
                       bool normals) {
        Pending lines;
        const auto place = [&](Vertex& cached) -> Vertex& {
            if ((cached.flags & is_pending) != 0) [[unlikely]]
                draw(lines);
            if ((cached.flags & is_pending) == 0) [[likely]]
                return cached;
            return lines.vertex[0] == &slot_[0] ? slot_[1] : slot_[0]; // the one that is left has its place
        };
        const auto begin = [&](Vertex& v) {
            lines.fresh[lines.fresh_count] = &v;
            lines.projections.add(lines.fresh_count++, transforms_, v.position, v.window, fog_);
        };
        for (std::uint32_t i = 0; i < count; ++i) {
            Vertex& v = usual_element(reader, indices.at(i), normals, place, begin);
            v.flags |= is_pending;
            lines.vertex[lines.count++] = &v;
            if (mode_ == GL_LINE_LOOP && i == 0) {
                divide(lines);
                slot_[2] = v;
            }
            if (lines.fresh_count == line_batch || lines.count == line_batch + 1)
                draw(lines);
        }
        draw(lines);
        if (lines.count == 0)
            return;
        lines.vertex[0]->flags &= ~is_pending;
        if (mode_ == GL_LINE_LOOP && count > 1) { // end() closes it
            corner_[0] = &slot_[2];
            corner_[1] = lines.vertex[0];
            held_ = 2;
        }
    }

    /// A strip of elements: its corners stay in registers.
    void strip_elements(const ElementReader& reader, std::uint32_t count, const Indices& given, bool normals,
                        bool textured) {
        const Indices indices = given; // in registers
        Vertex *older = nullptr, *old = nullptr;
        const auto place = [&](Vertex& cached) -> Vertex& {
            Vertex* v = &cached;
            for (Vertex* slot = slot_; v == older || v == old; ++slot) // of three, one is free
                v = slot;
            return *v;
        };
        for (std::uint32_t i = 0; i < count; ++i) {
            Vertex* const v = &corner_element(reader, indices.at(i), normals, textured, place);
            if (i >= 2)
                usual_triangle((i & 1) == 0 ? *older : *old, (i & 1) == 0 ? *old : *older, *v);
            older = old;
            old = v;
        }
    }

    void divide(Pending& lines) {
        lines.projections.finish();
        for (int i = 0; i < lines.fresh_count; ++i) {
            Vertex& v = *lines.fresh[i];
            unsigned planes = 0;
            const bool divided = lines.projections.divide(i, transforms_, v.position, v.window, planes);
            set_flags(v, divided, planes);
            v.flags |= is_pending;
        }
        lines.fresh_count = 0;
    }

    /// Draws the lines and lets go of their vertices, but for the last where the next line starts from it.
    [[gnu::noinline]] void draw(Pending& p) {
        divide(p);
        const int step = mode_ == GL_LINES ? 2 : 1, left = step == 2 ? p.count & 1 : p.count != 0 ? 1 : 0;
        lines(p.vertex, p.count, step);
        for (int i = 0; i < p.count - left; ++i)
            p.vertex[i]->flags &= ~is_pending;
        if (left != 0) {
            p.vertex[0] = p.vertex[p.count - 1];
            p.vertex[0]->flags |= is_pending;
        }
        p.count = left;
    }

    /// Where a new vertex goes that belongs into `cached`.
    SPANGLE_INLINE Vertex& place_of(Vertex& cached) {
        Vertex* v = &cached;
        for (int i = 0; i < held_; ++i)
            if (corner_[i] == v)
                v = free_slot(); // another corner of this primitive has its place
        v->time = now_;
        return *v;
    }

    /// One of four that none of the corners held, three at most, is in.
    [[gnu::noinline]] Vertex* free_slot() {
        for (Vertex& v : slot_) {
            bool held = false;
            for (int i = 0; i < held_; ++i)
                held = held || corner_[i] == &v;
            if (!held)
                return &v;
        }
        return slot_;
    }

    /// Colours that materials follow, or no vertex array: element by element.
    [[gnu::noinline]] void elements_in_turn(Context& context, const ElementReader& reader,
                                            std::uint32_t count, const Indices& indices) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t index = indices.at(i);
            set_attributes(context, reader, index);
            if (!reader.vertex.on())
                continue;
            Real v[4] = {numeric::zero, numeric::zero, numeric::zero, numeric::one};
            reader.vertex.read(index, v);
            vertex(context, v[0], v[1], v[2], v[3]);
        }
    }

    /// Flags of a vertex that is to be projected only if it is seen.
    [[gnu::noinline]] static unsigned flags_of(const typename M::Clip& clip) {
        unsigned flags = unprojected;
        for (unsigned plane = 0; plane < 6; ++plane) {
            const int p = static_cast<int>(plane);
            flags |= M::distance(clip, p, 1) < 0 ? 1u << plane : 0u;
            flags |= M::distance(clip, p, M::guard_band) < 0 ? 1u << (plane + beyond_shift) : 0u;
        }
        return flags;
    }

    /// Side 0 is the front, 1 the back.
    [[gnu::noinline]] void light(const Vertex& v, int side, Window& out) {
        if ((v.flags & is_cut) != 0) {
            const Cut& cut = static_cast<const Cut&>(v);
            return lighting_.light(*context_, cut.light, cut.eye, side, out);
        }
        typename M::Eye eye{};
        if (lighting_.needs_eye())
            eye = M::to_eye(transforms_, v.position);
        lighting_.light(*context_, L::input(v.normal), eye, side, out);
    }

    /// What is known only now: the edge flag, and the colour where the material is the current colour.
    [[gnu::noinline]] void given(const CurrentState& current, Vertex& v) {
        if (current.edge_flag)
            v.flags |= edge_flag;
#if SPANGLE_FEATURE_FEEDBACK
        if (captures())
            texture_[&v - slot_] = texture_of(current, v, 0);
#endif
        if (lighting_.tracks_color())
            color(v);
    }

    /// The user's planes that a vertex, as it was given, is outside of.
    [[gnu::noinline]] unsigned outside(const Vertex& v) const {
        return planes_.outside(M::to_eye(transforms_, v.position));
    }

    void color(Vertex& v) {
        if ((v.flags & uncolored) != 0)
            light(v);
    }
    [[gnu::noinline]] void light(Vertex& v) {
        static constexpr typename M::Eye unseen{};
        if ((v.flags & is_cut) != 0 || lighting_.needs_eye())
            light(v, 0, v.window);
        else
            lighting_.light(*context_, L::input(v.normal), unseen, 0, v.window);
        v.flags &= ~uncolored;
    }

    /// False: not in front, never drawn.
    [[gnu::noinline]] bool project(Vertex& v) {
        if ((v.flags & unprojected) == 0)
            return true;
        const typename M::Clip clip =
            (v.flags & is_cut) != 0 ? static_cast<const Cut&>(v).clip : M::to_clip(transforms_, v.position);
        if (!M::in_front(clip))
            return false;
        M::project(transforms_, clip, v.window);
        v.flags &= ~unprojected;
        return true;
    }

    // --- assembly (GL 1.3, 2.6.1); provoking vertices by table 2.11

    static int corners_of(GLenum mode) {
        constexpr std::int8_t corners[] = {1, 2, 2, 2, 3, 3, 3, 4, 4, 3}; // POINTS .. POLYGON
        return corners[mode];
    }

    void swap(int i, int j) {
        Vertex* const v = corner_[i];
        corner_[i] = corner_[j];
        corner_[j] = v;
    }

    /// All corners are there: draws, and leaves those that the next primitive shares in front.
    [[gnu::noinline]] void primitive() {
        Vertex* const* const c = corner_;
        switch (mode_) {
        case GL_POINTS:
            held_ = 0;
            return point(*c[0]);
        case GL_LINES:
            held_ = 0;
            return line(*c[0], *c[1]);
        case GL_LINE_STRIP:
            held_ = 1;
            swap(0, 1);
            return line(*c[1], *c[0]);
        case GL_LINE_LOOP: // the first vertex stays in front
            held_ = 2;
            if (full_ == 2) {
                full_ = 3;
                return line(*c[0], *c[1]);
            }
            swap(1, 2);
            return line(*c[2], *c[1]);
        case GL_TRIANGLES:
            held_ = 0;
            return triangle(*c[0], *c[1], *c[2]);
        case GL_TRIANGLE_STRIP:
            return strip();
        case GL_TRIANGLE_FAN:
            held_ = 2;
            swap(1, 2);
            return triangle(*c[0], *c[2], *c[1]);
        case GL_POLYGON: {
            if (outlined())
                return outlined_fan(false);
            held_ = 2;
            swap(1, 2);
            Vertex* const corners[3] = {c[0], c[2], c[1]};
            return polygon(corners, 3, *c[0]);
        }
        case GL_QUADS:
            held_ = 0;
            return quad(*c[0], *c[1], *c[2], *c[3], *c[3]);
        default: // QUAD_STRIP: v0 v1 v3 v2
            held_ = 2;
            swap(0, 2);
            swap(1, 3);
            return quad(*c[2], *c[3], *c[1], *c[0], *c[1]);
        }
    }

    /// The oldest triangle of a polygon that may be drawn as its outline: v0, vi, vi+1. Only the edges of the
    /// polygon are drawn: v0 v1 is in the first triangle, vn v0 in the last.
    [[gnu::noinline]] void outlined_fan(bool last) {
        const auto flag = [](Vertex& v, bool is_edge) {
            v.flags = is_edge && (v.flags & edge_flag) != 0 ? v.flags | boundary : v.flags & ~boundary;
        };
        flag(*corner_[0], !odd_);
        flag(*corner_[1], true);
        flag(*corner_[2], last);
        odd_ = true;
        polygon(corner_, 3, *corner_[0]);
        swap(1, 2);
        swap(2, 3);
        held_ = 3;
    }

    /// Which edges of any other polygon are drawn: those of strips and fans all (GL 1.3, 2.6.2).
    void flag_edges(Vertex* const* corners, int n) {
        if (mode_ == GL_POLYGON)
            return;
        const bool by_flag = mode_ == GL_TRIANGLES || mode_ == GL_QUADS;
        for (int i = 0; i < n; ++i) {
            std::uint32_t& flags = corners[i]->flags;
            flags = !by_flag || (flags & edge_flag) != 0 ? flags | boundary : flags & ~boundary;
        }
    }

    /// Triangle i of a strip is i, i+1, i+2, with the first two exchanged when i is odd, so all face one way.
    void strip() {
        Vertex *const oldest = corner_[0], *const middle = corner_[1], *const last = corner_[2];
        corner_[0] = middle;
        corner_[1] = last;
        corner_[2] = oldest;
        held_ = 2;
        odd_ = !odd_;
        triangle(odd_ ? *oldest : *middle, odd_ ? *middle : *oldest, *last);
    }

    // --- primitives

    void point(Vertex& v) {
        if ((v.flags & outside_mask) != 0 || (planes_.any() && outside(v) != 0) || !project(v))
            return;
        color(v);
        draw_point(v, v.window);
    }

    void draw_point(const Vertex& v, const Window& window) {
        if (captures())
            return capture(
                GL_POINT_TOKEN,
                [&](int) {
                    return Corner{v, window};
                },
                1);
        raster::draw_point(*state_, context_->drawable.surface, window, point_size_);
    }

    void draw_line(const Vertex& a, const Window& at_a, const Vertex& b, const Window& at_b,
                   const Window& provoking) {
        if (captures())
            return capture_line({a, at_a}, {b, at_b}, provoking);
        raster::draw_line(*state_, context_->drawable.surface, at_a, at_b, provoking, line_width_);
    }

    // --- primitives that are selected or fed back (GL 1.3, 5.2 and 5.3)

    struct Corner {
        const Vertex& vertex;
        const Window& window; ///< of the side that is seen
    };

    [[gnu::noinline]] void capture_line(const Corner& a, const Corner& b, const Window& provoking) {
        const GLenum token = stipple_starts_ ? GL_LINE_RESET_TOKEN : GL_LINE_TOKEN;
        stipple_starts_ = mode_ == GL_LINES;
        capture(
            token,
            [&](int i) {
                return Corner{(i == 0 ? a : b).vertex, flat_ ? provoking : (i == 0 ? a : b).window};
            },
            2);
    }

    /// corner(i): what is left of the primitive's corners after clipping, with their windows.
    template <class At>
    void capture([[maybe_unused]] GLenum token, [[maybe_unused]] At corner, [[maybe_unused]] int n) {
#if SPANGLE_FEATURE_SELECTION
        if (context_->render.mode == GL_SELECT) {
            std::uint32_t nearest = 0xFFFFFFFF, farthest = 0;
            for (int i = 0; i < n; ++i) {
                const std::uint32_t depth = M::depth_word(corner(i).vertex.window);
                nearest = depth < nearest ? depth : nearest;
                farthest = depth > farthest ? depth : farthest;
            }
            return record_hit(*context_, nearest, farthest);
        }
#endif
#if SPANGLE_FEATURE_FEEDBACK
        feed_token(*context_, token);
        if (token == GL_POLYGON_TOKEN)
            feed_count(*context_, n);
        for (int i = 0; i < n; ++i)
            feed(corner(i));
#endif
    }

#if SPANGLE_FEATURE_FEEDBACK
    [[gnu::noinline]] void feed(const Corner& corner) {
        const Vertex& v = corner.vertex;
        const bool cut = (v.flags & is_cut) != 0;
        FeedbackVertex out;
        M::window_of(transforms_, cut ? static_cast<const Cut&>(v).clip : M::to_clip(transforms_, v.position),
                     out.window);
        M::color_of(corner.window, out.color);
        M::reals(cut ? static_cast<const Cut&>(v).texture : texture_[&v - slot_], out.texture);
        feed_vertex(*context_, out);
    }
#endif

    [[gnu::noinline]] void captured_line(Vertex& a, Vertex& b) {
        const unsigned both = a.flags & b.flags;
        if ((both & outside_mask) != 0)
            return;
        color(a);
        color(b);
        cut_line(a, b);
    }

    // --- lines and polygons

    void line(Vertex& a, Vertex& b) {
        if (captures())
            return captured_line(a, b);
        Vertex* const ends[2] = {&a, &b};
        lines(ends, 2, 1);
    }

    /// From vertices i to i + 1, with i = 0, step, ...
    [[gnu::noinline]] void lines(Vertex* const* vertex, int n, int step) {
        unsigned any = 0;
        const Window* window[line_batch + 1];
        for (int i = 0; i < n; ++i) {
            any |= vertex[i]->flags;
            window[i] = &vertex[i]->window;
        }
        if ((any & (outside_mask | beyond_mask | unprojected)) != 0 || planes_.any()) [[unlikely]] {
            for (int i = 0; i + 1 < n; i += step)
                seen_line(*vertex[i], *vertex[i + 1]);
            return;
        }
        if ((any & uncolored) != 0)
            for (int i = flat_ ? 1 : 0; i < n; i += flat_ ? step : 1)
                color(*vertex[i]);
        raster::draw_lines(*state_, context_->drawable.surface, window, n, step, line_width_);
    }

    /// A line that may be out of sight.
    [[gnu::noinline]] void seen_line(Vertex& a, Vertex& b) {
        if ((a.flags & b.flags & outside_mask) != 0)
            return;
        if (!flat_)
            color(a);
        color(b);
        cut_line(a, b);
    }

    /// A line that may be beyond a plane, or whose ends may have no window coordinates yet.
    [[gnu::noinline]] void cut_line(Vertex& a, Vertex& b) {
        Vertex* ends[2] = {&a, &b};
        if ((clip_planes(a.flags | b.flags) != 0 || planes_.any()) && !clip_line(ends))
            return;
        if (((ends[0]->flags | ends[1]->flags) & unprojected) != 0 &&
            (!project(*ends[0]) || !project(*ends[1])))
            return;
        draw_line(*ends[0], ends[0]->window, *ends[1], ends[1]->window, b.window);
    }

    static std::int64_t area_of(const Window& a, const Window& b, const Window& c) {
        const raster::Position at_a = raster::position(a), at_b = raster::position(b),
                               at_c = raster::position(c);
        return raster::signed_area(at_a.x, at_a.y, at_b.x, at_b.y, at_c.x, at_c.y);
    }

    /// The usual triangle, whose last corner is the provoking one; what must be clipped, or lit from behind,
    /// goes the way of polygons.
    [[gnu::noinline]] void triangle(Vertex& a, Vertex& b, Vertex& c) {
        usual_triangle(a, b, c);
    }
    SPANGLE_INLINE void usual_triangle(Vertex& a, Vertex& b, Vertex& c) {
        const unsigned any = a.flags | b.flags | c.flags;
        if ((a.flags & b.flags & c.flags & outside_mask) != 0)
            return;
        if ((any & (beyond_mask | unprojected)) != 0 || whole_polygons_) {
            Vertex* const corners[3] = {&a, &b, &c};
            return polygon(corners, 3, c);
        }
        const std::int64_t area = area_of(a.window, b.window, c.window);
        if (area == 0 || (area > 0 ? culls_ccw_ : culls_cw_))
            return;
        if ((any & uncolored) != 0) {
            if (!flat_)
                color(a), color(b);
            color(c);
        }
        raster::draw_triangle(*state_, context_->drawable.surface, a.window, b.window, c.window, c.window,
                              area);
    }

    /// Two triangles with one facing: that of the whole quad.
    void quad(Vertex& a, Vertex& b, Vertex& c, Vertex& d, Vertex& provoking) {
        Vertex* corners[4] = {&a, &b, &c, &d};
        polygon(corners, 4, provoking);
    }

    [[gnu::noinline]] void polygon(Vertex* const* corners, int n, Vertex& provoking) {
        unsigned all = outside_mask, any = 0;
        for (int i = 0; i < n; ++i) {
            all &= corners[i]->flags;
            any |= corners[i]->flags;
        }
        if (all != 0)
            return;
        if (outlined())
            flag_edges(corners, n);
        unsigned planes = clip_planes(any);
        if (planes_.any()) {
            unsigned all_user = ~0u, any_user = 0;
            for (int i = 0; i < n; ++i) {
                const unsigned user = outside(*corners[i]);
                all_user &= user;
                any_user |= user;
            }
            if (all_user != 0)
                return;
            planes |= any_user << user_shift;
        }
        if (planes == 0)
            return visible(corners, n, provoking);
        Vertex* work[2][clip_vertices];
        for (int i = 0; i < n; ++i)
            work[0][i] = &to_be_cut(*corners[i], i);
        const int left = clip_polygon(work, n, planes);
        if (left >= 3)
            visible(work[0], left, provoking);
    }

    void visible(Vertex* const* corners, int n, Vertex& provoking) {
        std::int64_t area = 0, part[clip_vertices]; // of triangle 0, i, i + 1
        for (int i = 0; i < n; ++i)
            if (!project(*corners[i]))
                return;
        for (int i = 1; i + 1 < n; ++i) {
            part[i] = area_of(corners[0]->window, corners[i]->window, corners[i + 1]->window);
            area += part[i];
        }
        if (area == 0 && n == 3 && !captures())
            return;
        const bool ccw = area > 0;
        if (ccw ? culls_ccw_ : culls_cw_)
            return;
        if (ccw != front_is_ccw_ && two_sided_)
            return draw_back(corners, n, provoking, part);
        for (int i = 0; i < n && !flat_; ++i)
            color(*corners[i]);
        color(provoking);
        draw([corners](int i) -> Window& { return corners[i]->window; }, corners, n, provoking.window,
             ccw == front_is_ccw_ ? 0 : 1, part);
    }

    /// The polygon as the mode of its side says. at(i): the window vertex of corner i, coloured.
    template <class At>
    SPANGLE_INLINE void draw(At at, Vertex* const* corners, int n, const Window& provoking, int side,
                             const std::int64_t* part) {
        if (outlined() && face_mode_[side] != GL_FILL)
            return outline(at, corners, n, provoking, face_mode_[side]);
        if (captures())
            return capture(
                GL_POLYGON_TOKEN,
                [&](int i) {
                    return Corner{*corners[i], flat_ ? provoking : at(i)};
                },
                n);
        for (int i = 1; i + 1 < n; ++i)
            if (part[i] != 0)
                raster::draw_triangle(*state_, context_->drawable.surface, at(0), at(i), at(i + 1), provoking,
                                      part[i]);
    }

    /// Boundary edges as lines, or the vertices that start them as points (GL 1.3, 3.5.4).
    template <class At>
    [[gnu::noinline]] void outline(At at, Vertex* const* corners, int n, const Window& provoking,
                                   GLenum mode) {
        stipple_starts_ = true;
        for (int i = 0; i < n; ++i) {
            if ((corners[i]->flags & boundary) == 0)
                continue;
            if (mode == GL_LINE) {
                const int next = i + 1 < n ? i + 1 : 0;
                draw_line(*corners[i], at(i), *corners[next], at(next), provoking);
                continue;
            }
            Window v = at(i);
            if (flat_)
                M::copy_color(provoking, v);
            draw_point(*corners[i], v);
        }
    }

    /// The same triangles lit from behind: back material, normals turned (GL 1.3, 2.13.1). A vertex that
    /// clipping made is lit from its mixed normal and position.
    void draw_back(Vertex* const* corners, int n, const Vertex& provoking, const std::int64_t* part) {
        Window back[clip_vertices];
        for (int i = 0; i < n; ++i) {
            back[i] = corners[i]->window;
            light(*corners[i], 1, back[i]);
        }
        Window flat = provoking.window;
        light(provoking, 1, flat);
        draw([&back](int i) -> Window& { return back[i]; }, corners, n, flat, 1, part);
    }

    // --- clipping (GL 1.3, 2.11)

    bool needs_eye() const {
        return planes_.any() || (lit_ && lighting_.needs_eye());
    }

    /// The vertex with all that clipping mixes; colours come first.
    [[gnu::noinline]] Cut& to_be_cut(Vertex& v, int i) {
        color(v);
        Cut& out = cut_[i];
        static_cast<Vertex&>(out) = v;
        out.flags |= is_cut;
        out.clip = M::to_clip(transforms_, v.position);
        if (fog_)
            out.eye_z = M::depth(transforms_, v.position);
        if (needs_eye())
            out.eye = M::to_eye(transforms_, v.position);
        out.light = L::input(v.normal);
#if SPANGLE_FEATURE_FEEDBACK
        if (captures())
            out.texture = texture_[&v - slot_];
#endif
        return out;
    }

    /// A vertex at t of the edge from a to b.
    [[gnu::noinline]] void mix(const Cut& a, const Cut& b, const typename M::Parameter& t, Cut& out) {
        M::mix(a.window, b.window, t, units_, out.window);
        if (fog_) {
            out.eye_z = M::mix(a.eye_z, b.eye_z, t);
            M::set_fog(out.eye_z, out.window);
        }
        if (needs_eye())
            out.eye = M::mix(a.eye, b.eye, t);
        L::mix(a.light, b.light, t, out.light);
#if SPANGLE_FEATURE_FEEDBACK
        if (captures())
            out.texture = M::mix(a.texture, b.texture, t);
#endif
        out.clip = M::mix(a.clip, b.clip, t);
        out.flags = flags_of(out.clip) | is_cut;
    }

    int band() const {
        return exactly_clipped() ? 1 : M::guard_band;
    }

    /// Planes are numbered: those of the view volume, from user_shift on the user's. These come last, so that
    /// they cut the same polygon as their complements do.
    bool keeps(int plane, const Cut& v) const {
        if (plane < user_shift)
            return M::distance(v.clip, plane, band()) >= 0;
        const typename M::Plane& user = planes_[plane - user_shift];
        return !M::outside(user, M::distance(user, v.eye));
    }

    /// A new vertex on the edge from inside to outside; the same integers whichever polygon asks.
    void cut(int plane, const Cut& inside, const Cut& outside, Cut& out) {
        if (plane >= user_shift)
            return cut_by_user(planes_[plane - user_shift], inside, outside, out);
        mix(inside, outside, M::intersect(inside.clip, outside.clip, plane, band()), out);
        // Rounding must not leave it outside of the plane it lies on.
        out.flags &= ~(1u << plane | 1u << (static_cast<unsigned>(plane) + beyond_shift));
    }
    /// From the side where distances are positive, whichever is kept: the same integers for a plane and its
    /// complement.
    void cut_by_user(const typename M::Plane& plane, const Cut& inside, const Cut& outside, Cut& out) {
        const Cut &a = M::turned(plane) ? outside : inside, &b = M::turned(plane) ? inside : outside;
        mix(a, b, M::intersect(M::distance(plane, a.eye), M::distance(plane, b.eye)), out);
    }

    bool clip_line(Vertex* (&ends)[2]) {
        int made = 2;
        Cut* end[2] = {&to_be_cut(*ends[0], 0), &to_be_cut(*ends[1], 1)};
        for (int plane = 0; plane < user_shift + planes_.count(); ++plane) {
            const bool first_in = keeps(plane, *end[0]), second_in = keeps(plane, *end[1]);
            if (!first_in && !second_in)
                return false;
            if (first_in && second_in)
                continue;
            Cut& fresh = cut_[made++];
            cut(plane, first_in ? *end[0] : *end[1], first_in ? *end[1] : *end[0], fresh);
            end[first_in ? 1 : 0] = &fresh;
        }
        ends[0] = end[0];
        ends[1] = end[1];
        return true;
    }

    /// Sutherland and Hodgman, plane by plane; the polygon ends up in work[0].
    int clip_polygon(Vertex* (&work)[2][clip_vertices], int n, unsigned planes) {
        int used = n;
        for (int plane = 0; plane < user_shift + planes_.count(); ++plane) {
            if ((planes >> plane & 1) == 0)
                continue;
            int m = 0;
            for (int i = 0; i < n; ++i) {
                // A convex polygon meets a plane twice. A quad that crosses itself, or one that rounding bent
                // at the limits of the mantissas, may do so more often; it may be left out (GL 1.3, 2.6.1).
                if (used == cut_count || m + 2 > clip_vertices)
                    return 0;
                Cut& here = static_cast<Cut&>(*work[0][i]);
                Cut& next = static_cast<Cut&>(*work[0][i + 1 == n ? 0 : i + 1]);
                const bool here_in = keeps(plane, here), next_in = keeps(plane, next);
                if (here_in)
                    work[1][m++] = &here;
                if (here_in == next_in)
                    continue;
                Cut& fresh = cut_[used++];
                cut(plane, here_in ? here : next, here_in ? next : here, fresh);
                // On the way out an edge along the plane starts, a boundary; on the way in goes on what was
                // cut (GL 1.3, 2.11).
                fresh.flags |= here_in ? unsigned{boundary} : here.flags & boundary;
                work[1][m++] = &fresh;
            }
            n = m;
            for (int i = 0; i < n; ++i)
                work[0][i] = work[1][i];
            if (n < 3)
                return 0;
        }
        return n;
    }
};

} // namespace spangle::gl
