// Rows of vertex arrays, which are client state (GL 1.3, tables 6.6 and 6.7).
#pragma once

#include "gl/context/state_row.hpp"

// Builds without an optional system may have no member for its state.
#if SPANGLE_FEATURE_BUFFERS
#define BUFFER_BINDING(NAME) computed<computed_state::buffer_binding>(NAME, Kind::integer, 1)
#else
#define BUFFER_BINDING(NAME) of_buffers(constant(NAME, 0))
#endif
#if SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS
#define VERTEX_ARRAY_ROW STORED(GL_VERTEX_ARRAY_BINDING, array_bindings.vertex_array)
#else
#define VERTEX_ARRAY_ROW of_vertex_array_objects(constant(GL_VERTEX_ARRAY_BINDING, 0))
#endif

namespace spangle::gl {

inline constexpr auto arrays_rows = std::to_array<WrittenRow>({
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
    of_fog(CLIENT_SWITCH(GL_FOG_COORDINATE_ARRAY, arrays.fog_coord.enabled)),
    of_fog(STORED(GL_FOG_COORDINATE_ARRAY_TYPE, arrays.fog_coord.type)),
    of_fog(STORED(GL_FOG_COORDINATE_ARRAY_STRIDE, arrays.fog_coord.stride)),
    of_fog(STORED(GL_FOG_COORDINATE_ARRAY_POINTER, arrays.fog_coord.pointer)),
    of_secondary_color(CLIENT_SWITCH(GL_SECONDARY_COLOR_ARRAY, arrays.secondary_color.enabled)),
    of_secondary_color(STORED(GL_SECONDARY_COLOR_ARRAY_TYPE, arrays.secondary_color.type)),
    of_secondary_color(STORED(GL_SECONDARY_COLOR_ARRAY_STRIDE, arrays.secondary_color.stride)),
    of_secondary_color(STORED(GL_SECONDARY_COLOR_ARRAY_POINTER, arrays.secondary_color.pointer)),
    of_client_unit(CLIENT_SWITCH(GL_TEXTURE_COORD_ARRAY, arrays.tex_coord[0].enabled)),
    of_client_unit(STORED(GL_TEXTURE_COORD_ARRAY_SIZE, arrays.tex_coord[0].size)),
    of_client_unit(STORED(GL_TEXTURE_COORD_ARRAY_TYPE, arrays.tex_coord[0].type)),
    of_client_unit(STORED(GL_TEXTURE_COORD_ARRAY_STRIDE, arrays.tex_coord[0].stride)),
    of_client_unit(STORED(GL_TEXTURE_COORD_ARRAY_POINTER, arrays.tex_coord[0].pointer)),
    HELD(array_bindings.client_active),
    HELD(array_bindings.array_buffer),
    HELD(arrays.element_buffer),
    HELD(arrays.buffered),
    HELD(arrays.vertex.buffer),
    HELD(arrays.normal.buffer),
    HELD(arrays.color.buffer),
    HELD(arrays.index.buffer),
    HELD(arrays.edge_flag.buffer),
    HELD(arrays.fog_coord.buffer),
    HELD(arrays.secondary_color.buffer),
    of_client_unit(HELD(arrays.tex_coord[0].buffer)),
    of_primitive_restart(CLIENT_SWITCH(GL_PRIMITIVE_RESTART, array_bindings.restart)),
    of_primitive_restart(STORED(GL_PRIMITIVE_RESTART_INDEX, array_bindings.restart_index)),
    in(Group::none),
    of_secondary_color(constant(GL_SECONDARY_COLOR_ARRAY_SIZE, 3)),
    BUFFER_BINDING(GL_ARRAY_BUFFER_BINDING),
    BUFFER_BINDING(GL_ELEMENT_ARRAY_BUFFER_BINDING),
    BUFFER_BINDING(GL_VERTEX_ARRAY_BUFFER_BINDING),
    BUFFER_BINDING(GL_NORMAL_ARRAY_BUFFER_BINDING),
    BUFFER_BINDING(GL_COLOR_ARRAY_BUFFER_BINDING),
    of_color_index(BUFFER_BINDING(GL_INDEX_ARRAY_BUFFER_BINDING)),
    of_fog(BUFFER_BINDING(GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING)),
    of_secondary_color(BUFFER_BINDING(GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING)),
    of_polygon_mode(BUFFER_BINDING(GL_EDGE_FLAG_ARRAY_BUFFER_BINDING)),
    BUFFER_BINDING(GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING),
    VERTEX_ARRAY_ROW,
});

#undef BUFFER_BINDING
#undef VERTEX_ARRAY_ROW

} // namespace spangle::gl
