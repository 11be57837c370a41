#include "gl/context/tokens.hpp"

namespace spangle::gl {

unsigned place_in(const std::uint16_t* table, unsigned count, GLenum token) {
    unsigned place = 0;
    while (place < count && table[place] != token)
        ++place;
    return place;
}

} // namespace spangle::gl
