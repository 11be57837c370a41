// Parts of which the questions are made.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "boards/scenes/gl.hpp"
#include "tests/oracle/mesa/answers.hpp"

namespace spangle::oracle {

class Asker {
  public:
    Answers answers;

    void note(std::string question, std::vector<double> values);
    void error(const std::string& question);
    /// Asks for `count` values in all four types. Asked for integers, Mesa scales matrices like colours; GL
    /// 1.3, 6.1.2 does not.
    void state(GLenum name, int count);
    /// Asks what `draw` feeds back.
    void feedback(const std::string& question, GLenum type, const std::function<void()>& draw,
                  std::size_t size = 8192);
    void selection(const std::string& question, const std::function<void()>& draw, std::size_t size = 256);
};

/// Sets a camera in front of the origin.
void perspective();
/// Draws eight vertices around the origin, each with a colour and texture coordinates.
void ring(GLenum mode, int n, float size);
/// Enables a texture, because Mesa transforms texture coordinates only with a texture.
void texture();

// The questions, each asked in a fresh context.
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
