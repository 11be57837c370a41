// Asks about evaluators: their maps, and the values that they make.
#include <array>
#include <initializer_list>

#include "tests/oracle/mesa/asker.hpp"

namespace spangle::oracle {

namespace {

constexpr GLenum map1[] = {GL_MAP1_COLOR_4,         GL_MAP1_INDEX,           GL_MAP1_NORMAL,
                           GL_MAP1_TEXTURE_COORD_1, GL_MAP1_TEXTURE_COORD_2, GL_MAP1_TEXTURE_COORD_3,
                           GL_MAP1_TEXTURE_COORD_4, GL_MAP1_VERTEX_3,        GL_MAP1_VERTEX_4};
constexpr int map_components[] = {4, 1, 3, 1, 2, 3, 4, 3, 4};
constexpr GLenum to_map2 = GL_MAP2_COLOR_4 - GL_MAP1_COLOR_4;

/// Returns 4 x 4 control points of a sheet within the view volume; w is at least 1.
std::array<GLfloat, 64> sheet(int components) {
    std::array<GLfloat, 64> out{};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const auto x = static_cast<float>(i), y = static_cast<float>(j);
            const float p[4] = {x / 2 - 0.75f, y / 2 - 0.75f, static_cast<float>((i * 5 + j * 3) % 4) / 4,
                                1 + static_cast<float>((i + j) % 3) / 4};
            for (int c = 0; c < components; ++c)
                out[static_cast<std::size_t>((i * 4 + j) * components + c)] = p[c];
        }
    return out;
}

} // namespace

Answers evaluators() {
    Asker asker;
    perspective();
    for (std::size_t t = 0; t < 9; ++t) {
        const int k = map_components[t];
        const auto points = sheet(k);
        glMap1f(map1[t], 0.25f, 2, 4 * k, 4, points.data());
        glMap2f(map1[t] + to_map2, -1, 1, 4 * k, 4, 0.5f, 2.5f, k, 4, points.data());
        for (const GLenum target : std::initializer_list<GLenum>{map1[t], map1[t] + to_map2})
            for (const GLenum query : std::initializer_list<GLenum>{GL_COEFF, GL_ORDER, GL_DOMAIN}) {
                GLdouble v[64] = {};
                GLint n[64] = {};
                glGetMapdv(target, query, v);
                glGetMapiv(target, query, n);
                asker.note("map", {v, v + 64});
                if (query != GL_COEFF)
                    asker.note("map as integers", {n, n + 4});
            }
    }
    glMapGrid1f(9, 0.25f, 2);
    glMapGrid2f(5, -1, 1, 4, 0.5f, 2.5f);
    for (const GLenum vertex : std::initializer_list<GLenum>{GL_MAP1_VERTEX_3, GL_MAP1_VERTEX_4}) {
        glEnable(vertex);
        glEnable(vertex + to_map2);
        for (const GLenum attribute : std::initializer_list<GLenum>{GL_MAP1_COLOR_4, GL_MAP1_TEXTURE_COORD_1,
                                                                    GL_MAP1_TEXTURE_COORD_3}) {
            glEnable(attribute);
            glEnable(attribute + to_map2);
            glColor4f(0.25f, 0.5f, 0.75f, 1); // Mesa's evaluators change the current values
            glTexCoord4f(0.5f, 0.25f, 0, 1);
            asker.feedback("curve", GL_4D_COLOR_TEXTURE, [] {
                glBegin(GL_LINE_STRIP);
                for (int i = 0; i <= 20; ++i)
                    glEvalCoord1f(0.25f + 0.0875f * static_cast<float>(i));
                glEnd();
                glEvalMesh1(GL_POINT, 0, 9);
                glEvalMesh1(GL_LINE, 2, 7);
            });
            asker.feedback("surface", GL_4D_COLOR_TEXTURE, [] {
                glEvalMesh2(GL_POINT, 0, 5, 0, 4);
                glEvalMesh2(GL_LINE, 1, 4, 0, 3);
                glBegin(GL_TRIANGLE_STRIP);
                for (int i = 0; i < 5; ++i) {
                    glEvalPoint2(i, 1);
                    glEvalPoint2(i, 2);
                }
                glEnd();
            });
            glDisable(attribute);
            glDisable(attribute + to_map2);
        }
        glEnable(GL_LIGHTING);
        glEnable(GL_LIGHT0);
        glEnable(GL_NORMALIZE);
        for (const GLenum normals : std::initializer_list<GLenum>{GL_AUTO_NORMAL, GL_MAP2_NORMAL}) {
            glEnable(normals);
            asker.feedback("normals", GL_3D_COLOR, [] { glEvalMesh2(GL_POINT, 0, 5, 0, 4); });
            glDisable(normals);
        }
        glDisable(GL_LIGHTING);
        glDisable(vertex);
        glDisable(vertex + to_map2);
    }
    const GLfloat p[4] = {};
    glMap1f(GL_MAP1_VERTEX_3, 1, 1, 3, 1, p);
    asker.error("empty domain");
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 2, 1, p);
    asker.error("stride");
    glMap1f(GL_MAP2_VERTEX_3, 0, 1, 3, 1, p);
    asker.error("target");
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 0, p);
    asker.error("order");
    glMapGrid1f(0, 0, 1);
    asker.error("grid");
    glEvalMesh1(GL_FILL, 0, 1);
    asker.error("mesh");
    return asker.answers;
}

} // namespace spangle::oracle
