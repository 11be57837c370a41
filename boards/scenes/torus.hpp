// A torus around the z axis as an indexed grid, computed by the compiler.
#pragma once

#include <array>

#include "boards/scenes/trig.hpp"

namespace spangle::scenes {

struct TorusVertex {
    float position[3];
    float normal[3];
    float texcoord[2];
};

/// A grid of (Around + 1) x (Tube + 1) vertices; vertex (u, v) has index u * (Tube + 1) + v. The first and
/// last vertex of a ring share a position but no texture coordinates, so these need not wrap.
template <int Around, int Tube> struct TorusMesh {
    static constexpr int columns = Tube + 1;
    std::array<TorusVertex, (Around + 1) * columns> vertices;
};

template <int Around, int Tube>
constexpr TorusMesh<Around, Tube> make_torus(double ring, double radius, double repeat_s, double repeat_t) {
    TorusMesh<Around, Tube> mesh{};
    for (int u = 0; u <= Around; ++u) {
        const double a = turn * (u % Around) / Around; // both ends of the seam are the same point, to the bit
        const double ca = cosine(a), sa = sine(a);
        for (int v = 0; v <= Tube; ++v) {
            const double b = turn * (v % Tube) / Tube;
            const double cb = cosine(b), sb = sine(b);
            TorusVertex& out = mesh.vertices[static_cast<unsigned>(u * (Tube + 1) + v)];
            out.position[0] = static_cast<float>((ring + radius * cb) * ca);
            out.position[1] = static_cast<float>((ring + radius * cb) * sa);
            out.position[2] = static_cast<float>(radius * sb);
            out.normal[0] = static_cast<float>(cb * ca);
            out.normal[1] = static_cast<float>(cb * sa);
            out.normal[2] = static_cast<float>(sb);
            out.texcoord[0] = static_cast<float>(repeat_s * u / Around);
            out.texcoord[1] = static_cast<float>(repeat_t * v / Tube);
        }
    }
    return mesh;
}

/// Returns the 2 * (Tube + 1) indices of each strip. Strip u holds the quads between rings u and u + 1; their
/// outer faces are counter-clockwise.
template <int Around, int Tube> constexpr auto make_torus_strips() {
    std::array<std::array<unsigned short, 2 * (Tube + 1)>, Around> strips{};
    for (int u = 0; u < Around; ++u)
        for (int v = 0; v <= Tube; ++v) {
            auto& strip = strips[static_cast<unsigned>(u)];
            strip[static_cast<unsigned>(2 * v)] = static_cast<unsigned short>(u * (Tube + 1) + v);
            strip[static_cast<unsigned>(2 * v + 1)] = static_cast<unsigned short>((u + 1) * (Tube + 1) + v);
        }
    return strips;
}

} // namespace spangle::scenes
