// What the questions are put together from.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "boards/scenes/gl.hpp"
#include "tests/oracle/answers.hpp"

namespace spangle::oracle {

class Asker {
  public:
    Answers answers;

    void note(std::string question, std::vector<double> values);
    void error(const std::string& question);
    /// In all four types, `count` values. Mesa scales matrices as if they were colours when asked for
    /// integers; GL 1.3, 6.1.2 does not.
    void state(GLenum name, int count);
    /// What `draw` feeds back.
    void feedback(const std::string& question, GLenum type, const std::function<void()>& draw,
                  std::size_t size = 8192);
    void selection(const std::string& question, const std::function<void()>& draw, std::size_t size = 256);
};

/// A camera in front of the origin.
void perspective();
/// Eight corners of it around the origin, each with a colour and texture coordinates.
void ring(GLenum mode, int n, float size);
/// Texture coordinates pass the matrix in Mesa only where there is a texture.
void texture();

// The questions; each in a fresh context.
Answers initial_state();
Answers state_that_was_set();
Answers attribute_groups();
Answers selection();
Answers feedback();
Answers evaluators();
Answers lists();
Answers raster_positions();
Answers lighting();
Answers generated_coordinates();
Answers clip_planes();
Answers buffers();
Answers multi_draw();
Answers fog_coordinates();
Answers secondary_colors();
Answers primitive_restart();
Answers vertex_array_objects();
Answers texture_images();
Answers texture_parameters();
Answers pixel_paths();
Answers fragment_operations();

} // namespace spangle::oracle
