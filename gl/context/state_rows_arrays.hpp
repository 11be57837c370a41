// Vertex arrays, which are the client's (GL 1.3, tables 6.6 and 6.7).
#pragma once

#include "gl/context/state_row.hpp"

namespace spangle::gl {

inline constexpr auto arrays_rows = std::to_array<StateRow>({
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
    of_fog(of_buffers(STORED(GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING, arrays.fog_coord.buffer))),
    of_polygon_mode(of_buffers(STORED(GL_EDGE_FLAG_ARRAY_BUFFER_BINDING, arrays.edge_flag.buffer))),
    of_buffers(of_client_unit(STORED(GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, arrays.tex_coord[0].buffer))),
});

} // namespace spangle::gl
