// Prints the proof obligations with the numbers of the headers: errors of tables, widths, bounds. `generate
// NAME` writes one Gappa script to stdout, `generate --list` all names.
#include <cstdio>
#include <cstring>

#include "tests/oracle/gappa/obligations.hpp"

int main(int argc, char** argv) {
    using namespace spangle::gappa;
    const bool list = argc == 2 && std::strcmp(argv[1], "--list") == 0;
    bool found = list;
    for (const auto* all : {&vertex_obligations(), &primitive_obligations(), &color_obligations()})
        for (const Obligation& o : *all) {
            if (list)
                std::printf("%s\n", o.name);
            else if (argc == 2 && std::strcmp(argv[1], o.name) == 0)
                o.print(), found = true;
        }
    if (!found)
        std::fprintf(stderr, "usage: generate NAME | --list\n");
    return found ? 0 : 2;
}
