// What RenderMode asks of selection when it leaves it.
#pragma once

#include "gl/vertex/render_state.hpp"

namespace spangle::gl {

/// Writes the record of the hits since the last one, if there were any.
void end_hit_record(SelectState& select);

} // namespace spangle::gl
