// Rows of state that vertices use: current values, matrices, viewport, lighting and evaluators (GL 1.3,
// tables 6.5 to 6.12 and 6.22).
#pragma once

#include "gl/context/state_row.hpp"

// Builds without an optional system may have no member for its state.
#if SPANGLE_FEATURE_CLIP_PLANES
#define PLANE(I) SWITCH(GL_CLIP_PLANE0 + I, transform.clip_plane_on[I])
#define PLANES HELD(transform.clip_plane)
#else
#define PLANE(I) of_clip_planes(absent_switch(GL_CLIP_PLANE0 + I))
#define PLANES in(Group::transform)
#endif
#if SPANGLE_FEATURE_LIGHTING
#define LIGHTING_ROW(NAME, MEMBER) STORED(NAME, lighting.MEMBER)
#define LIGHTING_SWITCH(NAME, MEMBER) SWITCH(NAME, lighting.MEMBER)
#define LIGHT(I) light_switch(I)
#define LIGHTS HELD(lighting.light)
#define MATERIALS HELD(lighting.material)
#else
#define LIGHTING_ROW(NAME, MEMBER) of_lighting(constant(NAME, 0))
#define LIGHTING_SWITCH(NAME, MEMBER) of_lighting(absent_switch(NAME))
#define LIGHT(I) of_lighting(absent_switch(GL_LIGHT0 + I))
#define LIGHTS in(Group::lighting)
#define MATERIALS in(Group::lighting)
#endif
#if SPANGLE_FEATURE_EVALUATORS
#define EVAL_ROW(NAME, MEMBER) STORED(NAME, eval.MEMBER)
#define EVAL_SWITCH(NAME, MEMBER) SWITCH(NAME, eval.MEMBER)
#else
#define EVAL_ROW(NAME, MEMBER) of_evaluators(constant(NAME, 0))
#define EVAL_SWITCH(NAME, MEMBER) of_evaluators(absent_switch(NAME))
#endif
#define MAP_SWITCH(TARGET, INDEX)                                                                            \
    EVAL_SWITCH(GL_MAP1_##TARGET, enabled[0][INDEX]), EVAL_SWITCH(GL_MAP2_##TARGET, enabled[1][INDEX])

namespace spangle::gl {

#if SPANGLE_FEATURE_LIGHTING
/// Makes the row of light i's switch. A light beyond the limit has no switch.
constexpr WrittenRow light_switch(unsigned i) {
    if (i >= max_lights)
        return in(Group::lighting);
    return stored_row<bool>(GL_LIGHT0 + i, offsetof(Context, lighting.light_enabled) + i * sizeof(bool),
                            Switch::server);
}
#endif

inline constexpr auto vertex_rows = std::to_array<WrittenRow>({
    in(Group::current),
    linear(STORED(GL_CURRENT_COLOR, current.color)),
    of_secondary_color(linear(STORED(GL_CURRENT_SECONDARY_COLOR, current.secondary_color))),
    linear(STORED(GL_CURRENT_NORMAL, current.normal)),
    of_color_index(STORED(GL_CURRENT_INDEX, current.index)),
    of_polygon_mode(STORED(GL_EDGE_FLAG, current.edge_flag)),
    of_fog(STORED(GL_CURRENT_FOG_COORDINATE, current.fog_coord)),
    of_unit(sizeof(CurrentState::TexCoord), STORED(GL_CURRENT_TEXTURE_COORDS, current.tex_coord[0].v)),
    of_raster_pos(STORED(GL_CURRENT_RASTER_POSITION, current.raster.position)),
    of_raster_pos(STORED(GL_CURRENT_RASTER_POSITION_VALID, current.raster.valid)),
    of_raster_pos(STORED(GL_CURRENT_RASTER_DISTANCE, current.raster.distance)),
    of_raster_pos(linear(STORED(GL_CURRENT_RASTER_COLOR, current.raster.color))),
    of_raster_pos(STORED(GL_CURRENT_RASTER_INDEX, current.raster.index)),
    of_raster_pos(of_unit(sizeof(RasterPosition::TexCoord),
                          STORED(GL_CURRENT_RASTER_TEXTURE_COORDS, current.raster.tex_coord[0].v))),
    in(Group::none),
    computed<computed_state::matrix>(GL_MODELVIEW_MATRIX, Kind::real, 16),
    computed<computed_state::matrix>(GL_PROJECTION_MATRIX, Kind::real, 16),
    computed<computed_state::matrix>(GL_TEXTURE_MATRIX, Kind::real, 16),
    computed<computed_state::transposed_matrix>(GL_TRANSPOSE_MODELVIEW_MATRIX, Kind::real, 16),
    computed<computed_state::transposed_matrix>(GL_TRANSPOSE_PROJECTION_MATRIX, Kind::real, 16),
    computed<computed_state::transposed_matrix>(GL_TRANSPOSE_TEXTURE_MATRIX, Kind::real, 16),
    computed<computed_state::depth_of_stack>(GL_MODELVIEW_STACK_DEPTH, Kind::integer, 1),
    computed<computed_state::depth_of_stack>(GL_PROJECTION_STACK_DEPTH, Kind::integer, 1),
    computed<computed_state::depth_of_stack>(GL_TEXTURE_STACK_DEPTH, Kind::integer, 1),
    in(Group::transform),
    STORED(GL_MATRIX_MODE, transform.matrix_mode),
    of_feature(has_full_lighting, SPANGLE_TEXT("this build makes no normals unit (SPANGLE_FULL_LIGHTING)"),
               SWITCH(GL_NORMALIZE, transform.normalize)),
    of_feature(has_full_lighting,
               SPANGLE_TEXT("this build gives normals no other length (SPANGLE_FULL_LIGHTING)"),
               SWITCH(GL_RESCALE_NORMAL, transform.rescale_normal)),
    PLANE(0),
    PLANE(1),
    PLANE(2),
    PLANE(3),
    PLANE(4),
    PLANE(5),
    PLANES,
    in(Group::viewport),
    STORED(GL_VIEWPORT, transform.viewport),
    linear(STORED(GL_DEPTH_RANGE, transform.depth_range)),
    in(Group::lighting),
    STORED(GL_SHADE_MODEL, polygon.shade_model),
    LIGHTING_SWITCH(GL_LIGHTING, lighting),
    of_feature(has_color_material,
               SPANGLE_TEXT("this build has no materials that follow colours (SPANGLE_LIGHT_KINDS)"),
               LIGHTING_SWITCH(GL_COLOR_MATERIAL, color_material)),
    LIGHTING_ROW(GL_COLOR_MATERIAL_PARAMETER, color_material_parameter),
    LIGHTING_ROW(GL_COLOR_MATERIAL_FACE, color_material_face),
    linear(LIGHTING_ROW(GL_LIGHT_MODEL_AMBIENT, model_ambient)),
    LIGHTING_ROW(GL_LIGHT_MODEL_LOCAL_VIEWER, local_viewer),
    LIGHTING_ROW(GL_LIGHT_MODEL_TWO_SIDE, two_side),
    LIGHTING_ROW(GL_LIGHT_MODEL_COLOR_CONTROL, color_control),
    LIGHT(0),
    LIGHT(1),
    LIGHT(2),
    LIGHT(3),
    LIGHT(4),
    LIGHT(5),
    LIGHT(6),
    LIGHT(7),
    LIGHTS,
    MATERIALS,
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
});

#undef PLANE
#undef PLANES
#undef LIGHTING_ROW
#undef LIGHTING_SWITCH
#undef LIGHT
#undef LIGHTS
#undef MATERIALS
#undef EVAL_ROW
#undef EVAL_SWITCH
#undef MAP_SWITCH

} // namespace spangle::gl
