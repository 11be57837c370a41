// Executes display lists.
#pragma once

#include "gl/list/record.hpp"

namespace spangle::gl::list {

/// Executes the list of that name, if it exists, and all lists that it calls.
void execute(Context& context, GLuint name);

/// Plays a run of vertices.
const Word* play_run(Context& context, const Word* words);

/// Plays a recorded CallList. Its word is the name of the list.
const Word* play_call(Context& context, const Word* words);

/// Plays one element of a recorded CallLists. Its word is an offset that is added to the LIST_BASE of the
/// execution.
const Word* play_call_offset(Context& context, const Word* words);

} // namespace spangle::gl::list
