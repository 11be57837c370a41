// A texture of any target, format and size, with any parameters, bound to the active unit.
#pragma once

#include "tests/oracle/mesa/random_values.hpp"
#include "tests/oracle/mesa/state_families.hpp"

namespace spangle::oracle {

class RandomTexture {
  public:
    struct Wishes {
        bool mipmaps = false, linear = true, borders = true;
        bool depths = false;
        bool plane = false;     ///< wants a texture of two dimensions
        bool same_bits = false; ///< wants a format with as many bits in Mesa as in Spangle
    };
    RandomTexture(test::Random& random, const Wishes& wishes);
    RandomTexture(const RandomTexture&) = delete;
    RandomTexture& operator=(const RandomTexture&) = delete;
    ~RandomTexture();

    GLenum target = GL_TEXTURE_2D;
    GLenum base = GL_RGBA;   ///< base format
    int size[3] = {1, 1, 1}; ///< of level 0, without border
    int levels = 1;
    bool linear = false;   ///< true: the texture is magnified by LINEAR
    bool few_bits = false; ///< true: components have less than 8 bits
    GLenum min = GL_NEAREST;

    int dimensions() const { return target == GL_TEXTURE_1D ? 1 : target == GL_TEXTURE_3D ? 3 : 2; }
    bool cube() const { return target == GL_TEXTURE_CUBE_MAP; }

  private:
    GLuint name_ = 0;
    GLenum format_ = GL_RGBA8;
    bool two_values_ = false; ///< components are 0 and 1 only
    int border_ = 0;
    GLubyte border_color_[4] = {};

    void choose_format(test::Random& random, const Wishes& wishes);
    void choose_size(test::Random& random, const Wishes& wishes);
    void image(test::Random& random, GLenum face, int level);
    void parameters(test::Random& random, const Wishes& wishes);
};

} // namespace spangle::oracle
