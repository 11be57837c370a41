// Which colour buffers a context draws to.
#pragma once

namespace spangle::gl {

struct Context;

/// Whether the current DrawBuffer includes the front buffer.
bool draws_to_front(const Context& context);

} // namespace spangle::gl
