#include "boards/scenes/model_view.hpp"
#include "host_sim/cli/model.hpp"

namespace spangle::cli {

namespace {

void upload(const ModelImage& image, GLuint name) {
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, image.translucent ? GL_RGBA : GL_RGB, image.width, image.height, 0,
                 GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
}

GLenum mode_of(ModelPart::Kind kind) {
    constexpr GLenum modes[] = {GL_POINTS, GL_LINES, GL_TRIANGLES};
    return modes[static_cast<unsigned>(kind)];
}

void draw_part(const ModelPart& part) {
    const bool textured = part.image >= 0;
    if (textured) {
        glEnable(GL_TEXTURE_2D);
        glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(part.image + 1));
    } else {
        glDisable(GL_TEXTURE_2D);
    }
    if (part.colored) {
        glEnable(GL_COLOR_MATERIAL);
        glEnableClientState(GL_COLOR_ARRAY);
    } else {
        glDisable(GL_COLOR_MATERIAL);
        glDisableClientState(GL_COLOR_ARRAY);
        glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, part.diffuse.data());
    }
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, part.specular.data());
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, part.emission.data());
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, part.shininess);
    const ModelVertex& v = part.vertices.front();
    glVertexPointer(3, GL_FLOAT, sizeof(ModelVertex), v.position);
    glNormalPointer(GL_FLOAT, sizeof(ModelVertex), v.normal);
    glTexCoordPointer(2, GL_FLOAT, sizeof(ModelVertex), v.texcoord);
    glColorPointer(4, GL_FLOAT, sizeof(ModelVertex), v.color);
    glDrawElements(mode_of(part.kind), static_cast<GLsizei>(part.indices.size()), GL_UNSIGNED_INT,
                   part.indices.data());
}

} // namespace

void setup_model(const Model& model, int width, int height) {
    const double h = static_cast<double>(height) / width;
    const double narrow = h < 1.0 ? h : 1.0; // the unit sphere fits the shorter side
    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-0.36 / narrow, 0.36 / narrow, -0.36 * h / narrow, 0.36 * h / narrow, 1.0, 6.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    scenes::light_model();
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    for (std::size_t i = 0; i < model.images.size(); ++i)
        upload(model.images[i], static_cast<GLuint>(i + 1));
}

void draw_model(const Model& model, int frame) {
    scenes::turn_model(frame);
    scenes::draw_opaque_first(
        model.parts.size(),
        [&](std::size_t i) {
            const ModelPart& part = model.parts[i];
            return part.diffuse[3] < 1.0f ||
                   (part.image >= 0 && model.images[static_cast<std::size_t>(part.image)].translucent);
        },
        [&](std::size_t i) { draw_part(model.parts[i]); });
}

} // namespace spangle::cli
