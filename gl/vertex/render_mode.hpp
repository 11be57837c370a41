// The part of selection that RenderMode calls when it ends render mode SELECT.
#pragma once

#include "gl/vertex/render_state.hpp"

namespace spangle::gl {

/// Writes a record of the hits since the last record, if there are any (GL 1.3, 5.2).
void end_hit_record(SelectState& select);

} // namespace spangle::gl
