// Executing display lists.
#pragma once

#include "gl/list/record.hpp"

namespace spangle::gl::list {

/// Executes the list of that name, if there is one, with all it calls.
void execute(Context& context, GLuint name);

/// Player of a run of vertices.
const Word* play_run(Context& context, const Word* words);

/// Player of a recorded CallList: argument, the name.
const Word* play_call(Context& context, const Word* words);

/// Player of one element of a recorded CallLists: argument, the offset to LIST_BASE as it is at execution.
const Word* play_call_offset(Context& context, const Word* words);

} // namespace spangle::gl::list
