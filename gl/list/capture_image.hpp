// Client images in display lists: the pixels are copied while the list is compiled, through the unpack state
// of that moment, and played with a state that describes the copy (GL 1.3, 3.6.1 and 5.4).
#pragma once

#include "gl/context/types.hpp"
#include "gl/list/record.hpp"
#include "gl/pixel/pixel_layout.hpp"

namespace spangle::gl::list {

/// Images whose sides are above `most`, or that no command takes, are kept without their pixels: the command
/// refuses them when it is played.
void capture_image(Context& context, const Player* player, const ImageCommand& image, GLsizei most);

/// Calls run(context, image) unless between Begin and End.
const Word* play_image(Context& context, const Word* words, const CommandText* text,
                       void (*run)(Context&, const ImageCommand&));

} // namespace spangle::gl::list
