// What is drawn beside the extreme calls: primitives in whatever state there is, and a picture that sets its
// own.
#pragma once

namespace spangle::test {

/// A triangle, a quad, a line and a point with current attributes that change. Takes the state as it is.
void draw_primitives();

/// Ends what is open, leaves every level of the stacks, and makes every matrix the identity.
void leave_everything();

/// Clears and draws with a texture of its own, depth test, fog and light. Expects the initial state.
void draw_picture();

} // namespace spangle::test
