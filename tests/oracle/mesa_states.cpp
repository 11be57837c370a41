// Draws a family of random states with Mesa and writes the planes of each drawing to a file.
//
// usage: mesa_states FAMILY FILE FIRST DRAWINGS
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <GL/osmesa.h>

#include "tests/oracle/states.hpp"

int main(int argc, char** argv) {
    using namespace spangle::oracle;
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 16, nullptr);
    std::vector<unsigned char> pixels(std::size_t{state_size} * state_size * 4);
    if (argc != 5 || context == nullptr ||
        OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, state_size, state_size) == 0)
        return 1;
    for (const Family& family : all_families()) {
        if (std::strcmp(family.id, argv[1]) != 0)
            continue;
        std::FILE* const out = std::fopen(argv[2], "wb");
        if (out == nullptr)
            return 1;
        for (int n = std::atoi(argv[3]); n < std::atoi(argv[3]) + std::atoi(argv[4]); ++n) {
            const Planes planes = draw_state(family, n).planes;
            std::fwrite(planes.data(), 1, planes.size(), out);
        }
        return std::fclose(out);
    }
    return 1;
}
