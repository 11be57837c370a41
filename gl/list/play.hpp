// Executing display lists.
#pragma once

#include "gl/list/record.hpp"

namespace spangle::gl::list {

/// Executes the list of that name, if there is one, with all it calls.
void execute(Context& context, GLuint name);

/// Executes the records from `at` to the one at `end`, which is left out. There are no calls of lists
/// between.
void play_up_to(Context& context, const Word* at, const Word* end);

/// Player of a run of vertices.
const Word* play_run(Context& context, const Word* words);

/// Player of a recorded CallList: argument, the name.
const Word* play_call(Context& context, const Word* words);

/// Player of one element of a recorded CallLists: argument, the offset to LIST_BASE as it is at execution.
const Word* play_call_offset(Context& context, const Word* words);

} // namespace spangle::gl::list
