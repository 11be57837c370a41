// Client images in display lists. Pixels are copied with the unpack state of the compilation, and played with
// an unpack state that describes the copy (GL 1.3, 3.6.1 and 5.4).
#pragma once

#include "gl/context/types.hpp"
#include "gl/list/record.hpp"
#include "gl/pixel/pixel_layout.hpp"

namespace spangle::gl::list {

/// Records a command with an image. An image that no command accepts, or with a side above `most`, is stored
/// without its pixels. Its command raises the error when it is played.
void capture_image(Context& context, const Player* player, const ImageCommand& image, GLsizei most);

/// Plays an image by run(context, image). Between Begin and End, it raises an error in which `text` names the
/// command. Returns the next record.
const Word* play_image(Context& context, const Word* words, const CommandText* text,
                       void (*run)(Context&, const ImageCommand&));

} // namespace spangle::gl::list
