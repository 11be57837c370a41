// Which colour buffers a context draws to.
#pragma once

namespace spangle::gl {

struct Context;

/// DrawBuffer names the front buffer, alone or beside others.
bool draws_to_front(const Context& context);

} // namespace spangle::gl
