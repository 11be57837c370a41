// Rows of lists, attribute stacks, selection, feedback, the drawable, and limits (GL 1.3, tables 6.23 to
// 6.29).
#pragma once

#include "gl/context/state_row.hpp"
#include "gl/texture/compressed_format.hpp"

// Builds without an optional system may have no member for its state.
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

namespace spangle::gl {

inline constexpr auto limits_rows = std::to_array<WrittenRow>({
    in(Group::list),
    of_lists(STORED(GL_LIST_BASE, list.base)),
    in(Group::none),
    of_lists(STORED(GL_LIST_INDEX, list.index)),
    of_lists(STORED(GL_LIST_MODE, list.mode)),
    of_lists(constant(GL_MAX_LIST_NESTING, max_list_nesting)),
    in(Group::none), // rows of attribute stacks and of limits follow
    computed<computed_state::render_mode>(GL_RENDER_MODE, Kind::integer, 1),
    SELECTION_ROW(GL_NAME_STACK_DEPTH, depth),
    SELECTION_ROW(GL_SELECTION_BUFFER_SIZE, size),
    SELECTION_ROW(GL_SELECTION_BUFFER_POINTER, buffer),
    of_evaluators(constant(GL_MAX_EVAL_ORDER, max_eval_order)),
    of_selection(constant(GL_MAX_NAME_STACK_DEPTH, name_stack_entries)),
    FEEDBACK_ROW(GL_FEEDBACK_BUFFER_SIZE, size),
    FEEDBACK_ROW(GL_FEEDBACK_BUFFER_TYPE, type),
    FEEDBACK_ROW(GL_FEEDBACK_BUFFER_POINTER, buffer),
    of_attrib_stacks(computed<computed_state::saved_depth>(GL_ATTRIB_STACK_DEPTH, Kind::integer, 1)),
    of_attrib_stacks(computed<computed_state::saved_depth>(GL_CLIENT_ATTRIB_STACK_DEPTH, Kind::integer, 1)),
    of_attrib_stacks(constant(GL_MAX_ATTRIB_STACK_DEPTH, attrib_stack_entries)),
    of_attrib_stacks(constant(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, attrib_stack_entries)),
    of_lighting(constant(GL_MAX_LIGHTS, max_lights)),
    of_clip_planes(constant(GL_MAX_CLIP_PLANES, max_clip_planes)),
    constant(GL_MAX_MODELVIEW_STACK_DEPTH, modelview_stack_entries),
    constant(GL_MAX_PROJECTION_STACK_DEPTH, projection_stack_entries),
    constant(GL_MAX_TEXTURE_STACK_DEPTH, texture_stack_entries),
    constant(GL_SUBPIXEL_BITS, 8),
    constant(GL_MAX_TEXTURE_SIZE, max_texture_size),
    constant(GL_MAX_TEXTURE_LOD_BIAS, max_texture_lod_bias),
    of_texture_3d(constant(GL_MAX_3D_TEXTURE_SIZE, max_3d_texture_size)),
    of_cube_map(constant(GL_MAX_CUBE_MAP_TEXTURE_SIZE, max_texture_size)),
    of_compressed(constant(GL_NUM_COMPRESSED_TEXTURE_FORMATS, compressed_formats)),
    of_compressed(computed<computed_state::compressed_texture_formats>(GL_COMPRESSED_TEXTURE_FORMATS,
                                                                       Kind::integer, compressed_formats)),
    computed<computed_state::viewport_limits>(GL_MAX_VIEWPORT_DIMS, Kind::integer, 2),
    computed<computed_state::size_range>(GL_POINT_SIZE_RANGE, Kind::integer, 2),
    computed<computed_state::size_range>(GL_ALIASED_POINT_SIZE_RANGE, Kind::integer, 2),
    computed<computed_state::size_range>(GL_LINE_WIDTH_RANGE, Kind::integer, 2),
    computed<computed_state::size_range>(GL_ALIASED_LINE_WIDTH_RANGE, Kind::integer, 2),
    computed<computed_state::size_granularity>(GL_POINT_SIZE_GRANULARITY, Kind::real, 1),
    computed<computed_state::size_granularity>(GL_LINE_WIDTH_GRANULARITY, Kind::real, 1),
    computed<computed_state::element_limit>(GL_MAX_ELEMENTS_INDICES, Kind::integer, 1),
    computed<computed_state::element_limit>(GL_MAX_ELEMENTS_VERTICES, Kind::integer, 1),
    constant(GL_AUX_BUFFERS, 0),
    computed<computed_state::samples>(GL_SAMPLE_BUFFERS, Kind::integer, 1),
    computed<computed_state::samples>(GL_SAMPLES, Kind::integer, 1),
    computed<computed_state::index_mode>(GL_RGBA_MODE, Kind::integer, 1),
    computed<computed_state::index_mode>(GL_INDEX_MODE, Kind::integer, 1),
    STORED(GL_DOUBLEBUFFER, drawable.double_buffered),
    constant(GL_STEREO, 0),
    computed<computed_state::bits>(GL_RED_BITS, Kind::integer, 1),
    computed<computed_state::bits>(GL_GREEN_BITS, Kind::integer, 1),
    computed<computed_state::bits>(GL_BLUE_BITS, Kind::integer, 1),
    computed<computed_state::bits>(GL_ALPHA_BITS, Kind::integer, 1),
    computed<computed_state::index_mode>(GL_INDEX_BITS, Kind::integer, 1),
    computed<computed_state::bits>(GL_DEPTH_BITS, Kind::integer, 1),
    computed<computed_state::bits>(GL_STENCIL_BITS, Kind::integer, 1),
    computed<computed_state::accum_bits>(GL_ACCUM_RED_BITS, Kind::integer, 1),
    computed<computed_state::accum_bits>(GL_ACCUM_GREEN_BITS, Kind::integer, 1),
    computed<computed_state::accum_bits>(GL_ACCUM_BLUE_BITS, Kind::integer, 1),
    computed<computed_state::accum_bits>(GL_ACCUM_ALPHA_BITS, Kind::integer, 1),
});

#undef SELECTION_ROW
#undef FEEDBACK_ROW

} // namespace spangle::gl
