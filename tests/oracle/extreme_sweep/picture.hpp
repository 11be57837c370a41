// Draws beside the extreme calls: primitives in whatever state there is, and a picture that sets its own
// state.
#pragma once

namespace spangle::test {

/// Draws a triangle, a quad, a line and a point with changing attributes, in the current state.
void draw_primitives();

/// Ends what is open, leaves every level of the stacks, and makes every matrix the identity.
void leave_everything();

/// Clears, and draws with a texture of its own, depth test, fog and light. The state must be the initial one.
void draw_picture();

} // namespace spangle::test
