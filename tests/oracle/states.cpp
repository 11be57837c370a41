#include "tests/oracle/states.hpp"

#include "tests/oracle/state_families.hpp"

namespace spangle::oracle {

const std::vector<Family>& all_families() {
    static const std::vector<Family> families = [] {
        std::vector<Family> all;
        add_fragment_families(all);
        add_pixel_families(all);
        return all;
    }();
    return families;
}

Planes draw_state(const Family& family, int n) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, state_size, 0, state_size, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glViewport(0, 0, state_size, state_size);
    glDisable(GL_DITHER);
    test::Random random{static_cast<std::uint32_t>(n) * 7919u + 17u};
    family.draw(random);
    glPopClientAttrib();
    glPopAttrib();
    constexpr std::size_t pixels = std::size_t{state_size} * state_size;
    std::vector<GLubyte> color(4 * pixels), stencil(pixels);
    std::vector<GLfloat> depth(pixels); // how Mesa rounds to bytes is no question of ours
    glReadPixels(0, 0, state_size, state_size, GL_RGBA, GL_UNSIGNED_BYTE, color.data());
    glReadPixels(0, 0, state_size, state_size, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil.data());
    glReadPixels(0, 0, state_size, state_size, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
    Planes planes;
    for (std::size_t i = 0; i < pixels; ++i) {
        planes.insert(planes.end(), &color[4 * i], &color[4 * i] + 4);
        planes.push_back(stencil[i]);
        planes.push_back(static_cast<GLubyte>(depth[i] * 255 + 0.5f));
    }
    return planes;
}

} // namespace spangle::oracle
