// State that queries compute, because no member of the context holds it in the form that queries return.
#pragma once

#include "gl/context/types.hpp"

namespace spangle::gl {

struct Context;

namespace computed_state {

void matrix(const Context& context, GLenum name, Param* out);
void transposed_matrix(const Context& context, GLenum name, Param* out);
void depth_of_stack(const Context& context, GLenum name, Param* out);
void element_limit(const Context& context, GLenum name, Param* out);
void viewport_limits(const Context& context, GLenum name, Param* out);
void render_mode(const Context& context, GLenum name, Param* out);
void saved_depth(const Context& context, GLenum name, Param* out);
void buffer_binding(const Context& context, GLenum name, Param* out);
void size_range(const Context& context, GLenum name, Param* out);
void size_granularity(const Context& context, GLenum name, Param* out);
void binding(const Context& context, GLenum name, Param* out);
void compressed_texture_formats(const Context& context, GLenum name, Param* out);
void active_unit(const Context& context, GLenum name, Param* out);
void size_of_pixel_map(const Context& context, GLenum name, Param* out);
void index_mode(const Context& context, GLenum name, Param* out);
void bits(const Context& context, GLenum name, Param* out);
void samples(const Context& context, GLenum name, Param* out);
void accum_bits(const Context& context, GLenum name, Param* out);

} // namespace computed_state

} // namespace spangle::gl
