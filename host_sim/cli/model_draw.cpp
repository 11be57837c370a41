#include <spangle/GL/gl.h>

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
    static constexpr GLfloat light[4] = {0.4f, 0.7f, 1.0f, 0.0f};
    const double h = static_cast<double>(height) / width;
    const double narrow = h < 1.0 ? h : 1.0; // the sphere fits the shorter side
    glViewport(0, 0, width, height);
    glClearColor(0.125f, 0.25f, 0.375f, 1.0f);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-0.36 / narrow, 0.36 / narrow, -0.36 * h / narrow, 0.36 * h / narrow, 1.0, 6.0);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    glEnable(GL_DEPTH_TEST);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    for (std::size_t i = 0; i < model.images.size(); ++i)
        upload(model.images[i], static_cast<GLuint>(i + 1));
}

void draw_model(const Model& model, int frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glLoadIdentity();
    glTranslatef(0.0f, 0.0f, -3.0f);
    glRotatef(18.0f, 1.0f, 0.0f, 0.0f);
    glRotatef(static_cast<float>(30 + 2 * (frame % 180)), 0.0f, 1.0f, 0.0f);
    // Opaque parts first, so that what shows through the others is there.
    for (const bool translucent : {false, true})
        for (const ModelPart& part : model.parts) {
            const bool see_through =
                part.diffuse[3] < 1.0f ||
                (part.image >= 0 && model.images[static_cast<std::size_t>(part.image)].translucent);
            if (see_through != translucent)
                continue;
            if (translucent)
                glEnable(GL_BLEND);
            else
                glDisable(GL_BLEND);
            draw_part(part);
        }
    glDisable(GL_BLEND);
}

} // namespace spangle::cli
