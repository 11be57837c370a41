// Pieces of programs that draw: consistent states, complete textures, and arrays and images whose memory ends
// where GL may read no further.
#pragma once

#include <cstdint>

#include <spangle/GL/gl.h>

#include "tests/system/streams/stream_client.hpp"

namespace spangle::test {

class Scenes {
  public:
    Scenes(Bytes& in, Memory& memory) : in_(in), memory_(memory) {}

    /// Takes the size of the surface that is drawn to.
    void resize(std::int32_t width, std::int32_t height) {
        width_ = width;
        height_ = height;
    }
    /// Runs the piece with this number, with data from the stream. Returns how often the piece may touch each
    /// pixel.
    int one(unsigned number);

  private:
    using Piece = void (Scenes::*)();

    Bytes& in_;
    Memory& memory_;
    std::int32_t width_ = 1, height_ = 1;

    void plain();
    void camera();
    void view();
    void fragments();
    void lights();
    void texture();
    void environment();
    void generated_coordinates();
    void vertices();
    void blit();
    void arrays();
    void buffers();
    void images();
    void copies();
    void clears();
    void lists();
    void curves();
    void usual();
    void answers();
    void questions();
    void stacks();

    void vertex();
    void draw_arrays(int count, bool in_buffers);
    void image_source(int width, int height, int depth, bool pack, GLenum& format, GLenum& type,
                      std::uint8_t*& pixels);
    void reset_pixel_store();
};

} // namespace spangle::test
