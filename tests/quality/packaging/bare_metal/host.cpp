#include <cstdio>

#include "picture.hpp"

int main() {
    std::printf("%08x\n", static_cast<unsigned>(picture_hash()));
    return 0;
}
