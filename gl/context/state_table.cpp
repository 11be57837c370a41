#include "gl/context/state_table.hpp"

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "gl/context/context.hpp"
#include "gl/context/hooks.hpp"
#include "gl/context/limits.hpp"

namespace spangle::gl {

namespace {

template <class T> constexpr Source source_of_type() {
    using Element = std::remove_all_extents_t<T>;
    return std::is_same_v<Element, bool>          ? Source::boolean
           : std::is_same_v<Element, Real>        ? Source::real
           : std::is_same_v<Element, const void*> ? Source::pointer
                                                  : Source::integer;
}

template <class T> constexpr StateRow stored(GLenum name, std::size_t offset, Switch toggle = Switch::none) {
    constexpr Source source = source_of_type<T>();
    static_assert(source != Source::integer || sizeof(std::remove_all_extents_t<T>) == 4);
    return {name,
            source == Source::real ? Kind::real : Kind::integer,
            source,
            toggle,
            static_cast<std::uint8_t>(sizeof(T) / sizeof(std::remove_all_extents_t<T>)),
            static_cast<std::uint32_t>(offset),
            nullptr,
            nullptr,
            false};
}

/// Integers convert linearly: colours, normals, depths (GL 1.3, 6.1.2).
constexpr StateRow linear(StateRow row) {
    row.kind = Kind::color;
    return row;
}

constexpr StateRow constant(GLenum name, std::int32_t value) {
    return {
        name,    Kind::integer, Source::constant, Switch::none, 1, static_cast<std::uint32_t>(value), nullptr,
        nullptr, false};
}

[[maybe_unused]] constexpr StateRow absent_switch(GLenum name) {
    StateRow row = constant(name, 0);
    row.toggle = Switch::server;
    return row;
}

constexpr StateRow computed(GLenum name, Kind kind, std::uint8_t count,
                            void (*compute)(const Context&, GLenum, Param*)) {
    return {name, kind, Source::computed, Switch::none, count, 0, compute, nullptr, false};
}

/// Bytes that are saved with their group and asked for by a command of their own (GetLight...).
constexpr StateRow held(std::size_t offset, std::size_t bytes) {
    return {0,
            Kind::integer,
            Source::held,
            Switch::none,
            0,
            static_cast<std::uint32_t>(offset | bytes << 16),
            nullptr,
            nullptr,
            false};
}

/// The rows up to the next one of these belong to `group`.
constexpr StateRow in(Group group) {
    return {0, Kind::integer, Source::section, Switch::none, 0, 0, nullptr, nullptr, false, group};
}

/// A row of an optional system: INVALID_OPERATION and a message in a build without it.
constexpr StateRow of_feature(bool present, const char* text, StateRow row) {
    if (!present) {
        row.left_out = true;
        row.missing = text;
    }
    return row;
}
#define FEATURE(function, name)                                                                              \
    [[maybe_unused]] constexpr StateRow function(StateRow row) {                                             \
        return of_feature(SPANGLE_FEATURE_##name != 0,                                                       \
                          SPANGLE_TEXT("this build has no SPANGLE_FEATURE_" #name), row);                    \
    }
FEATURE(of_lighting, LIGHTING)
FEATURE(of_fog, FOG)
FEATURE(of_polygon_mode, POLYGON_MODE)
FEATURE(of_color_index, COLOR_INDEX)
FEATURE(of_texgen, TEXGEN)
FEATURE(of_raster_pos, RASTER_POS)
FEATURE(of_buffers, BUFFERS)
FEATURE(of_pixel_transfer, PIXEL_TRANSFER)
FEATURE(of_clip_planes, CLIP_PLANES)
FEATURE(of_attrib_stacks, ATTRIB_STACKS)
FEATURE(of_selection, SELECTION)
FEATURE(of_evaluators, EVALUATORS)
FEATURE(of_feedback, FEEDBACK)
FEATURE(of_lists, LISTS)
#undef FEATURE

/// One of each texture unit.
constexpr StateRow of_unit(PerUnit which, std::size_t step, StateRow row) {
    row.per_unit = which;
    row.unit_step = static_cast<std::uint16_t>(step);
    return row;
}
constexpr StateRow of_client_unit(StateRow row) {
    return of_unit(PerUnit::client, sizeof(ClientArray), row);
}

Param integer(std::int32_t value) {
    return Param::from_integer(static_cast<std::uint32_t>(value));
}

void matrix(const Context& context, GLenum name, Param* out) {
    const Matrix16 top = top_matrix(context, name);
    for (int i = 0; i < 16; ++i)
        out[i] = Param::from(top.m[i]);
}

/// The tokens of both forms stand in one order.
void transposed_matrix(const Context& context, GLenum name, Param* out) {
    const Matrix16 top = top_matrix(context, name - GL_TRANSPOSE_MODELVIEW_MATRIX + GL_MODELVIEW_MATRIX);
    for (int i = 0; i < 16; ++i)
        out[i] = Param::from(top.m[i / 4 + i % 4 * 4]);
}

void depth_of_stack(const Context& context, GLenum name, Param* out) {
    out[0] = integer(stack_depth(context, name));
}

void viewport_limits(const Context&, GLenum, Param* out) {
    out[0] = out[1] = integer(max_viewport_dim);
}

void render_mode(const Context& context, GLenum, Param* out) {
    out[0] = Param::from_integer(context.render.mode);
}

void saved_depth(const Context& context, GLenum name, Param* out) {
    out[0] = integer(saved_attributes(context, name == GL_CLIENT_ATTRIB_STACK_DEPTH));
}

void size_range(const Context&, GLenum name, Param* out) {
    const bool point = name == GL_POINT_SIZE_RANGE || name == GL_ALIASED_POINT_SIZE_RANGE;
    out[0] = integer(1);
    out[1] = integer(point ? max_point_size : max_line_width);
}

void binding(const Context& context, GLenum, Param* out) {
    out[0] = Param::from_integer(texture_binding_2d(context));
}

void active_unit(const Context& context, GLenum name, Param* out) {
    out[0] = Param::from_integer(
        GL_TEXTURE0 + (name == GL_ACTIVE_TEXTURE ? context.texture.active : context.arrays.client_active));
}

#if SPANGLE_FEATURE_PIXEL_TRANSFER
void size_of_pixel_map(const Context& context, GLenum name, Param* out) {
    out[0] = integer(pixel_map_size(context, name));
}
#endif

void bits(const Context& context, GLenum name, Param* out) {
    const raster::Surface& surface = context.drawable.surface;
    const FormatInfo format = format_info(surface.format);
    const std::uint8_t colors[] = {format.red_bits, format.green_bits, format.blue_bits, format.alpha_bits};
    if (name == GL_DEPTH_BITS)
        out[0] = integer(surface.depth_format == DepthFormat::none  ? 0
                         : surface.depth_format == DepthFormat::z16 ? 16
                                                                    : 24);
    else if (name == GL_STENCIL_BITS)
        out[0] = integer(surface.depth_format == DepthFormat::z24s8 ? 8 : 0);
    else
        out[0] = integer(colors[name - GL_RED_BITS]);
}

#define STORED(NAME, MEMBER)                                                                                 \
    stored<std::remove_reference_t<decltype(std::declval<Context&>().MEMBER)>>(NAME,                         \
                                                                               offsetof(Context, MEMBER))
#define SWITCH(NAME, MEMBER) stored<bool>(NAME, offsetof(Context, MEMBER), Switch::server)
#define CLIENT_SWITCH(NAME, MEMBER) stored<bool>(NAME, offsetof(Context, MEMBER), Switch::client)
#define HELD(MEMBER) held(offsetof(Context, MEMBER), sizeof(std::declval<Context&>().MEMBER))
#define TEXGEN(NAME, I)                                                                                      \
    of_texgen(of_unit(PerUnit::active, sizeof(TextureUnitState), SWITCH(NAME, texture.unit[0].gen_on[I])))
#define PLANE(I) of_clip_planes(SWITCH(GL_CLIP_PLANE0 + I, transform.clip_plane_on[I]))
#define LIGHT(I) of_lighting(SWITCH(GL_LIGHT0 + I, lighting.light_enabled[I]))

// Builds without a system may have no member for it.
#if SPANGLE_FEATURE_SELECTION
#define SELECTION_ROW(NAME, MEMBER) STORED(NAME, render.select.MEMBER)
#else
#define SELECTION_ROW(NAME, MEMBER) of_selection(constant(NAME, 0))
#endif
#if SPANGLE_FEATURE_FEEDBACK
#define FEEDBACK_ROW(NAME, MEMBER) STORED(NAME, render.feedback.MEMBER)
#else
#define FEEDBACK_ROW(NAME, MEMBER) of_feedback(constant(NAME, 0))
#endif

#if SPANGLE_FEATURE_EVALUATORS
#define EVAL_ROW(NAME, MEMBER) STORED(NAME, eval.MEMBER)
#define EVAL_SWITCH(NAME, MEMBER) SWITCH(NAME, eval.MEMBER)
#else
#define EVAL_ROW(NAME, MEMBER) of_evaluators(constant(NAME, 0))
#define EVAL_SWITCH(NAME, MEMBER) of_evaluators(absent_switch(NAME))
#endif
#if SPANGLE_FEATURE_PIXEL_TRANSFER
#define TRANSFER_ROW(NAME, MEMBER) STORED(NAME, pixel_mode.MEMBER)
#define PIXEL_MAP(NAME) computed(GL_PIXEL_MAP_##NAME##_SIZE, Kind::integer, 1, size_of_pixel_map)
#else
#define TRANSFER_ROW(NAME, MEMBER) of_pixel_transfer(constant(NAME, 0))
#define PIXEL_MAP(NAME) of_pixel_transfer(constant(GL_PIXEL_MAP_##NAME##_SIZE, 1))
#endif
#define MAP_SWITCH(TARGET, INDEX)                                                                            \
    EVAL_SWITCH(GL_MAP1_##TARGET, enabled[0][INDEX]), EVAL_SWITCH(GL_MAP2_##TARGET, enabled[1][INDEX])

// By attribute group (GL 1.3, 6.2).
constexpr auto unsorted = std::to_array<StateRow>({
    in(Group::current),
    linear(STORED(GL_CURRENT_COLOR, current.color)),
    linear(STORED(GL_CURRENT_NORMAL, current.normal)),
    of_color_index(STORED(GL_CURRENT_INDEX, current.index)),
    of_polygon_mode(STORED(GL_EDGE_FLAG, current.edge_flag)),
    of_unit(PerUnit::active, sizeof(CurrentState::TexCoord),
            STORED(GL_CURRENT_TEXTURE_COORDS, current.tex_coord[0].v)),
    of_raster_pos(STORED(GL_CURRENT_RASTER_POSITION, current.raster.position)),
    of_raster_pos(STORED(GL_CURRENT_RASTER_POSITION_VALID, current.raster.valid)),
    of_raster_pos(STORED(GL_CURRENT_RASTER_DISTANCE, current.raster.distance)),
    of_raster_pos(linear(STORED(GL_CURRENT_RASTER_COLOR, current.raster.color))),
    of_raster_pos(STORED(GL_CURRENT_RASTER_INDEX, current.raster.index)),
    of_raster_pos(of_unit(PerUnit::active, sizeof(RasterPosition::TexCoord),
                          STORED(GL_CURRENT_RASTER_TEXTURE_COORDS, current.raster.tex_coord[0].v))),
    in(Group::client_vertex_array),
    CLIENT_SWITCH(GL_VERTEX_ARRAY, arrays.vertex.enabled),
    STORED(GL_VERTEX_ARRAY_SIZE, arrays.vertex.size),
    STORED(GL_VERTEX_ARRAY_TYPE, arrays.vertex.type),
    STORED(GL_VERTEX_ARRAY_STRIDE, arrays.vertex.stride),
    STORED(GL_VERTEX_ARRAY_POINTER, arrays.vertex.pointer),
    CLIENT_SWITCH(GL_NORMAL_ARRAY, arrays.normal.enabled),
    STORED(GL_NORMAL_ARRAY_TYPE, arrays.normal.type),
    STORED(GL_NORMAL_ARRAY_STRIDE, arrays.normal.stride),
    STORED(GL_NORMAL_ARRAY_POINTER, arrays.normal.pointer),
    CLIENT_SWITCH(GL_COLOR_ARRAY, arrays.color.enabled),
    STORED(GL_COLOR_ARRAY_SIZE, arrays.color.size),
    STORED(GL_COLOR_ARRAY_TYPE, arrays.color.type),
    STORED(GL_COLOR_ARRAY_STRIDE, arrays.color.stride),
    STORED(GL_COLOR_ARRAY_POINTER, arrays.color.pointer),
    of_color_index(CLIENT_SWITCH(GL_INDEX_ARRAY, arrays.index.enabled)),
    of_color_index(STORED(GL_INDEX_ARRAY_TYPE, arrays.index.type)),
    of_color_index(STORED(GL_INDEX_ARRAY_STRIDE, arrays.index.stride)),
    of_color_index(STORED(GL_INDEX_ARRAY_POINTER, arrays.index.pointer)),
    of_polygon_mode(CLIENT_SWITCH(GL_EDGE_FLAG_ARRAY, arrays.edge_flag.enabled)),
    of_polygon_mode(STORED(GL_EDGE_FLAG_ARRAY_STRIDE, arrays.edge_flag.stride)),
    of_polygon_mode(STORED(GL_EDGE_FLAG_ARRAY_POINTER, arrays.edge_flag.pointer)),
    of_client_unit(CLIENT_SWITCH(GL_TEXTURE_COORD_ARRAY, arrays.tex_coord[0].enabled)),
    of_client_unit(STORED(GL_TEXTURE_COORD_ARRAY_SIZE, arrays.tex_coord[0].size)),
    of_client_unit(STORED(GL_TEXTURE_COORD_ARRAY_TYPE, arrays.tex_coord[0].type)),
    of_client_unit(STORED(GL_TEXTURE_COORD_ARRAY_STRIDE, arrays.tex_coord[0].stride)),
    of_client_unit(STORED(GL_TEXTURE_COORD_ARRAY_POINTER, arrays.tex_coord[0].pointer)),
    HELD(arrays.client_active),
    of_buffers(STORED(GL_ARRAY_BUFFER_BINDING, arrays.array_buffer)),
    of_buffers(STORED(GL_ELEMENT_ARRAY_BUFFER_BINDING, arrays.element_buffer)),
    of_buffers(STORED(GL_VERTEX_ARRAY_BUFFER_BINDING, arrays.vertex.buffer)),
    of_buffers(STORED(GL_NORMAL_ARRAY_BUFFER_BINDING, arrays.normal.buffer)),
    of_buffers(STORED(GL_COLOR_ARRAY_BUFFER_BINDING, arrays.color.buffer)),
    of_color_index(of_buffers(STORED(GL_INDEX_ARRAY_BUFFER_BINDING, arrays.index.buffer))),
    of_polygon_mode(of_buffers(STORED(GL_EDGE_FLAG_ARRAY_BUFFER_BINDING, arrays.edge_flag.buffer))),
    of_buffers(of_client_unit(STORED(GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, arrays.tex_coord[0].buffer))),
    in(Group::none),
    computed(GL_ACTIVE_TEXTURE, Kind::integer, 1, active_unit),
    computed(GL_CLIENT_ACTIVE_TEXTURE, Kind::integer, 1, active_unit),
    constant(GL_MAX_TEXTURE_UNITS, texture_units),
    computed(GL_MODELVIEW_MATRIX, Kind::real, 16, matrix),
    computed(GL_PROJECTION_MATRIX, Kind::real, 16, matrix),
    computed(GL_TEXTURE_MATRIX, Kind::real, 16, matrix),
    computed(GL_TRANSPOSE_MODELVIEW_MATRIX, Kind::real, 16, transposed_matrix),
    computed(GL_TRANSPOSE_PROJECTION_MATRIX, Kind::real, 16, transposed_matrix),
    computed(GL_TRANSPOSE_TEXTURE_MATRIX, Kind::real, 16, transposed_matrix),
    computed(GL_MODELVIEW_STACK_DEPTH, Kind::integer, 1, depth_of_stack),
    computed(GL_PROJECTION_STACK_DEPTH, Kind::integer, 1, depth_of_stack),
    computed(GL_TEXTURE_STACK_DEPTH, Kind::integer, 1, depth_of_stack),
    in(Group::transform),
    STORED(GL_MATRIX_MODE, transform.matrix_mode),
    SWITCH(GL_NORMALIZE, transform.normalize),
    SWITCH(GL_RESCALE_NORMAL, transform.rescale_normal),
    PLANE(0),
    PLANE(1),
    PLANE(2),
    PLANE(3),
    PLANE(4),
    PLANE(5),
    HELD(transform.clip_plane),
    in(Group::viewport),
    STORED(GL_VIEWPORT, transform.viewport),
    linear(STORED(GL_DEPTH_RANGE, transform.depth_range)),
    in(Group::fog),
    of_fog(linear(STORED(GL_FOG_COLOR, fog.color))),
    of_fog(STORED(GL_FOG_DENSITY, fog.density)),
    of_fog(STORED(GL_FOG_START, fog.start)),
    of_fog(STORED(GL_FOG_END, fog.end)),
    of_fog(STORED(GL_FOG_MODE, fog.mode)),
    of_fog(SWITCH(GL_FOG, fog.fog)),
    in(Group::lighting),
    STORED(GL_SHADE_MODEL, polygon.shade_model),
    of_lighting(SWITCH(GL_LIGHTING, lighting.lighting)),
    of_lighting(SWITCH(GL_COLOR_MATERIAL, lighting.color_material)),
    of_lighting(STORED(GL_COLOR_MATERIAL_PARAMETER, lighting.color_material_parameter)),
    of_lighting(STORED(GL_COLOR_MATERIAL_FACE, lighting.color_material_face)),
    of_lighting(linear(STORED(GL_LIGHT_MODEL_AMBIENT, lighting.model_ambient))),
    of_lighting(STORED(GL_LIGHT_MODEL_LOCAL_VIEWER, lighting.local_viewer)),
    of_lighting(STORED(GL_LIGHT_MODEL_TWO_SIDE, lighting.two_side)),
    of_lighting(STORED(GL_LIGHT_MODEL_COLOR_CONTROL, lighting.color_control)),
    LIGHT(0),
    LIGHT(1),
    LIGHT(2),
    LIGHT(3),
    LIGHT(4),
    LIGHT(5),
    LIGHT(6),
    LIGHT(7),
    of_lighting(HELD(lighting.light)),
    of_lighting(HELD(lighting.material)),
    in(Group::point),
    STORED(GL_POINT_SIZE, polygon.point_size),
    in(Group::line),
    STORED(GL_LINE_WIDTH, polygon.line_width),
    in(Group::polygon),
    SWITCH(GL_CULL_FACE, polygon.cull_face),
    STORED(GL_CULL_FACE_MODE, polygon.cull_face_mode),
    of_polygon_mode(STORED(GL_POLYGON_MODE, polygon.mode)),
    STORED(GL_FRONT_FACE, polygon.front_face),
    in(Group::texture),
    of_unit(PerUnit::active, sizeof(TextureUnitState), SWITCH(GL_TEXTURE_2D, texture.unit[0].texture_2d)),
    TEXGEN(GL_TEXTURE_GEN_S, 0),
    TEXGEN(GL_TEXTURE_GEN_T, 1),
    TEXGEN(GL_TEXTURE_GEN_R, 2),
    TEXGEN(GL_TEXTURE_GEN_Q, 3),
    of_unit(PerUnit::active, sizeof(TextureUnitState), HELD(texture.unit[0].gen)),
    HELD(texture.active),
    computed(GL_TEXTURE_BINDING_2D, Kind::integer, 1, binding),
    in(Group::scissor),
    SWITCH(GL_SCISSOR_TEST, fragment_ops.scissor_test),
    STORED(GL_SCISSOR_BOX, fragment_ops.scissor_box),
    in(Group::color_buffer),
    SWITCH(GL_ALPHA_TEST, fragment_ops.alpha_test),
    STORED(GL_ALPHA_TEST_FUNC, fragment_ops.alpha_func),
    linear(STORED(GL_ALPHA_TEST_REF, fragment_ops.alpha_ref)),
    in(Group::stencil_buffer),
    SWITCH(GL_STENCIL_TEST, fragment_ops.stencil_test),
    STORED(GL_STENCIL_FUNC, fragment_ops.stencil_func),
    STORED(GL_STENCIL_VALUE_MASK, fragment_ops.stencil_value_mask),
    STORED(GL_STENCIL_REF, fragment_ops.stencil_ref),
    STORED(GL_STENCIL_FAIL, fragment_ops.stencil_fail),
    STORED(GL_STENCIL_PASS_DEPTH_FAIL, fragment_ops.stencil_pass_depth_fail),
    STORED(GL_STENCIL_PASS_DEPTH_PASS, fragment_ops.stencil_pass_depth_pass),
    STORED(GL_STENCIL_WRITEMASK, fragment_ops.stencil_write_mask),
    STORED(GL_STENCIL_CLEAR_VALUE, fragment_ops.stencil_clear),
    in(Group::depth_buffer),
    SWITCH(GL_DEPTH_TEST, fragment_ops.depth_test),
    STORED(GL_DEPTH_FUNC, fragment_ops.depth_func),
    STORED(GL_DEPTH_WRITEMASK, fragment_ops.depth_mask),
    linear(STORED(GL_DEPTH_CLEAR_VALUE, fragment_ops.depth_clear)),
    in(Group::color_buffer),
    SWITCH(GL_BLEND, fragment_ops.blend),
    STORED(GL_BLEND_SRC, fragment_ops.blend_src),
    STORED(GL_BLEND_DST, fragment_ops.blend_dst),
    SWITCH(GL_DITHER, fragment_ops.dither),
    STORED(GL_DRAW_BUFFER, fragment_ops.draw_buffer),
    STORED(GL_COLOR_WRITEMASK, fragment_ops.color_mask),
    linear(STORED(GL_COLOR_CLEAR_VALUE, fragment_ops.color_clear)),
    in(Group::client_pixel_store),
    STORED(GL_UNPACK_SWAP_BYTES, pixel_store.unpack.swap_bytes),
    STORED(GL_UNPACK_LSB_FIRST, pixel_store.unpack.lsb_first),
    STORED(GL_UNPACK_IMAGE_HEIGHT, pixel_store.unpack.image_height),
    STORED(GL_UNPACK_SKIP_IMAGES, pixel_store.unpack.skip_images),
    STORED(GL_UNPACK_ROW_LENGTH, pixel_store.unpack.row_length),
    STORED(GL_UNPACK_SKIP_ROWS, pixel_store.unpack.skip_rows),
    STORED(GL_UNPACK_SKIP_PIXELS, pixel_store.unpack.skip_pixels),
    STORED(GL_UNPACK_ALIGNMENT, pixel_store.unpack.alignment),
    STORED(GL_PACK_SWAP_BYTES, pixel_store.pack.swap_bytes),
    STORED(GL_PACK_LSB_FIRST, pixel_store.pack.lsb_first),
    STORED(GL_PACK_IMAGE_HEIGHT, pixel_store.pack.image_height),
    STORED(GL_PACK_SKIP_IMAGES, pixel_store.pack.skip_images),
    STORED(GL_PACK_ROW_LENGTH, pixel_store.pack.row_length),
    STORED(GL_PACK_SKIP_ROWS, pixel_store.pack.skip_rows),
    STORED(GL_PACK_SKIP_PIXELS, pixel_store.pack.skip_pixels),
    STORED(GL_PACK_ALIGNMENT, pixel_store.pack.alignment),
    in(Group::pixel_mode),
    STORED(GL_READ_BUFFER, fragment_ops.read_buffer),
    TRANSFER_ROW(GL_MAP_COLOR, map_color),
    TRANSFER_ROW(GL_MAP_STENCIL, map_stencil),
    TRANSFER_ROW(GL_INDEX_SHIFT, index_shift),
    TRANSFER_ROW(GL_INDEX_OFFSET, index_offset),
    TRANSFER_ROW(GL_RED_SCALE, scale[0]),
    TRANSFER_ROW(GL_GREEN_SCALE, scale[1]),
    TRANSFER_ROW(GL_BLUE_SCALE, scale[2]),
    TRANSFER_ROW(GL_ALPHA_SCALE, scale[3]),
    TRANSFER_ROW(GL_RED_BIAS, bias[0]),
    TRANSFER_ROW(GL_GREEN_BIAS, bias[1]),
    TRANSFER_ROW(GL_BLUE_BIAS, bias[2]),
    TRANSFER_ROW(GL_ALPHA_BIAS, bias[3]),
    TRANSFER_ROW(GL_DEPTH_SCALE, depth_scale),
    TRANSFER_ROW(GL_DEPTH_BIAS, depth_bias),
    in(Group::none),
    PIXEL_MAP(I_TO_I),
    PIXEL_MAP(S_TO_S),
    PIXEL_MAP(I_TO_R),
    PIXEL_MAP(I_TO_G),
    PIXEL_MAP(I_TO_B),
    PIXEL_MAP(I_TO_A),
    PIXEL_MAP(R_TO_R),
    PIXEL_MAP(G_TO_G),
    PIXEL_MAP(B_TO_B),
    PIXEL_MAP(A_TO_A),
    of_pixel_transfer(constant(GL_MAX_PIXEL_MAP_TABLE, max_pixel_map_table)),
    in(Group::eval),
    EVAL_SWITCH(GL_AUTO_NORMAL, auto_normal),
    MAP_SWITCH(COLOR_4, eval_color),
    MAP_SWITCH(INDEX, eval_index),
    MAP_SWITCH(NORMAL, eval_normal),
    MAP_SWITCH(TEXTURE_COORD_1, eval_texture_1),
    MAP_SWITCH(TEXTURE_COORD_2, eval_texture_1 + 1),
    MAP_SWITCH(TEXTURE_COORD_3, eval_texture_1 + 2),
    MAP_SWITCH(TEXTURE_COORD_4, eval_texture_4),
    MAP_SWITCH(VERTEX_3, eval_vertex_3),
    MAP_SWITCH(VERTEX_4, eval_vertex_4),
    EVAL_ROW(GL_MAP1_GRID_DOMAIN, domain_1),
    EVAL_ROW(GL_MAP1_GRID_SEGMENTS, segments_1),
    EVAL_ROW(GL_MAP2_GRID_DOMAIN, domain_2),
    EVAL_ROW(GL_MAP2_GRID_SEGMENTS, segments_2),
    in(Group::list),
    of_lists(STORED(GL_LIST_BASE, list.base)),
    in(Group::none),
    of_lists(STORED(GL_LIST_INDEX, list.index)),
    of_lists(STORED(GL_LIST_MODE, list.mode)),
    of_lists(constant(GL_MAX_LIST_NESTING, max_list_nesting)),
    in(Group::hint),
    STORED(GL_PERSPECTIVE_CORRECTION_HINT, hint.perspective_correction),
    STORED(GL_POINT_SMOOTH_HINT, hint.point_smooth),
    STORED(GL_LINE_SMOOTH_HINT, hint.line_smooth),
    STORED(GL_POLYGON_SMOOTH_HINT, hint.polygon_smooth),
    STORED(GL_FOG_HINT, hint.fog),
    STORED(GL_TEXTURE_COMPRESSION_HINT, hint.texture_compression),
    in(Group::none), // the attribute stacks themselves, and limits
    computed(GL_RENDER_MODE, Kind::integer, 1, render_mode),
    SELECTION_ROW(GL_NAME_STACK_DEPTH, depth),
    SELECTION_ROW(GL_SELECTION_BUFFER_SIZE, size),
    SELECTION_ROW(GL_SELECTION_BUFFER_POINTER, buffer),
    of_evaluators(constant(GL_MAX_EVAL_ORDER, max_eval_order)),
    of_selection(constant(GL_MAX_NAME_STACK_DEPTH, name_stack_entries)),
    FEEDBACK_ROW(GL_FEEDBACK_BUFFER_SIZE, size),
    FEEDBACK_ROW(GL_FEEDBACK_BUFFER_TYPE, type),
    FEEDBACK_ROW(GL_FEEDBACK_BUFFER_POINTER, buffer),
    of_attrib_stacks(computed(GL_ATTRIB_STACK_DEPTH, Kind::integer, 1, saved_depth)),
    of_attrib_stacks(computed(GL_CLIENT_ATTRIB_STACK_DEPTH, Kind::integer, 1, saved_depth)),
    of_attrib_stacks(constant(GL_MAX_ATTRIB_STACK_DEPTH, attrib_stack_entries)),
    of_attrib_stacks(constant(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, attrib_stack_entries)),
    of_lighting(constant(GL_MAX_LIGHTS, max_lights)),
    of_clip_planes(constant(GL_MAX_CLIP_PLANES, max_clip_planes)),
    constant(GL_MAX_MODELVIEW_STACK_DEPTH, modelview_stack_entries),
    constant(GL_MAX_PROJECTION_STACK_DEPTH, projection_stack_entries),
    constant(GL_MAX_TEXTURE_STACK_DEPTH, texture_stack_entries),
    constant(GL_SUBPIXEL_BITS, 8),
    constant(GL_MAX_TEXTURE_SIZE, max_texture_size),
    computed(GL_MAX_VIEWPORT_DIMS, Kind::integer, 2, viewport_limits),
    computed(GL_POINT_SIZE_RANGE, Kind::integer, 2, size_range),
    computed(GL_ALIASED_POINT_SIZE_RANGE, Kind::integer, 2, size_range),
    computed(GL_LINE_WIDTH_RANGE, Kind::integer, 2, size_range),
    computed(GL_ALIASED_LINE_WIDTH_RANGE, Kind::integer, 2, size_range),
    constant(GL_POINT_SIZE_GRANULARITY, 1),
    constant(GL_LINE_WIDTH_GRANULARITY, 1),
    constant(GL_MAX_ELEMENTS_INDICES, 65536),
    constant(GL_MAX_ELEMENTS_VERTICES, 65536),
    constant(GL_AUX_BUFFERS, 0),
    constant(GL_RGBA_MODE, 1),
    constant(GL_INDEX_MODE, 0),
    STORED(GL_DOUBLEBUFFER, drawable.double_buffered),
    constant(GL_STEREO, 0),
    computed(GL_RED_BITS, Kind::integer, 1, bits),
    computed(GL_GREEN_BITS, Kind::integer, 1, bits),
    computed(GL_BLUE_BITS, Kind::integer, 1, bits),
    computed(GL_ALPHA_BITS, Kind::integer, 1, bits),
    constant(GL_INDEX_BITS, 0),
    computed(GL_DEPTH_BITS, Kind::integer, 1, bits),
    computed(GL_STENCIL_BITS, Kind::integer, 1, bits),
    constant(GL_ACCUM_RED_BITS, 0),
    constant(GL_ACCUM_GREEN_BITS, 0),
    constant(GL_ACCUM_BLUE_BITS, 0),
    constant(GL_ACCUM_ALPHA_BITS, 0),
});

#undef STORED
#undef SWITCH
#undef CLIENT_SWITCH
#undef HELD
#undef EVAL_ROW
#undef EVAL_SWITCH
#undef MAP_SWITCH
#undef TRANSFER_ROW
#undef PIXEL_MAP
#undef SELECTION_ROW
#undef FEEDBACK_ROW
#undef LIGHT
#undef PLANE
#undef TEXGEN

constexpr std::size_t count_sections() {
    std::size_t n = 0;
    for (const StateRow& row : unsorted)
        n += row.source == Source::section ? 1 : 0;
    return n;
}

constexpr auto sorted_by_name() {
    std::array<StateRow, unsorted.size() - count_sections()> rows{};
    Group group = Group::none;
    std::size_t used = 0;
    for (const StateRow& row : unsorted) {
        if (row.source == Source::section) {
            group = row.group;
            continue;
        }
        rows[used] = row;
        rows[used++].group = group;
    }
    for (std::size_t i = 1; i < rows.size(); ++i)
        for (std::size_t k = i; k > 0 && rows[k].name < rows[k - 1].name; --k)
            std::swap(rows[k], rows[k - 1]);
    return rows;
}

constexpr auto table = sorted_by_name();

constexpr bool names_differ() {
    for (std::size_t i = 1; i < table.size(); ++i)
        if (table[i].name == table[i - 1].name && table[i].name != 0)
            return false;
    return true;
}
static_assert(names_differ());
static_assert(sizeof(Context) <= 0x10000, "offsets of held bytes have 16 bits");

} // namespace

const StateRow* find_state(GLenum name) {
    std::size_t low = 0, high = table.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (table[middle].name == name)
            return &table[middle];
        (table[middle].name < name ? low : high) = table[middle].name < name ? middle + 1 : middle;
    }
    return nullptr;
}

std::span<const StateRow> all_state() {
    return table;
}

Kept kept_by(const StateRow& row) {
    switch (row.source) {
    case Source::boolean:
        return {row.where, row.count};
    case Source::integer:
    case Source::real:
        return {row.where, row.count * std::uint32_t{4}};
    case Source::pointer:
        return {row.where, sizeof(void*)};
    case Source::held:
        return {row.where & 0xFFFF, row.where >> 16};
    default:
        return {0, 0};
    }
}

std::uint32_t units_of(const StateRow& row) {
    return row.per_unit == PerUnit::no ? 1 : texture_units;
}

std::size_t offset_of(const Context& context, const StateRow& row) {
    const std::size_t unit = row.per_unit == PerUnit::active   ? context.texture.active
                             : row.per_unit == PerUnit::client ? context.arrays.client_active
                                                               : 0;
    return row.where + row.unit_step * unit;
}

void load_state(const Context& context, const StateRow& row, Param* out) {
    const auto* const from = reinterpret_cast<const unsigned char*>(&context) + offset_of(context, row);
    switch (row.source) {
    case Source::boolean:
        for (int i = 0; i < row.count; ++i)
            out[i] = integer(reinterpret_cast<const bool*>(from)[i]);
        break;
    case Source::integer:
        for (int i = 0; i < row.count; ++i)
            std::memcpy(&out[i].word, from + static_cast<std::size_t>(i) * sizeof(std::uint32_t),
                        sizeof(std::uint32_t));
        break;
    case Source::real:
        for (int i = 0; i < row.count; ++i)
            out[i] = Param::from(reinterpret_cast<const Real*>(from)[i]);
        break;
    case Source::constant:
        out[0] = Param::from_integer(row.where);
        break;
    case Source::computed:
        row.compute(context, row.name, out);
        break;
    default: // pointers and held bytes are no Params
        break;
    }
}

} // namespace spangle::gl
