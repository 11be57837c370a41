// Writes what a fuzzer's corpus starts from.
// usage: fuzz_seeds gl_commands|controller FOLDER
#include <cstdio>
#include <string>

#include "tests/gl_api/command_seeds.hpp"
#include "tests/sim/controller_stream.hpp"

int main(int argc, char** argv) {
    const std::string what = argc == 3 ? argv[1] : "";
    if (what != "gl_commands" && what != "controller") {
        std::fputs("usage: fuzz_seeds gl_commands|controller FOLDER\n", stderr);
        return 2;
    }
    int number = 0;
    for (const auto& seed :
         what == "controller" ? sim_test::controller_seeds() : spangle::test::command_seeds()) {
        const std::string path = std::string(argv[2]) + "/seed-" + std::to_string(number++);
        std::FILE* const file = std::fopen(path.c_str(), "wb");
        const bool good = file != nullptr && std::fwrite(seed.data(), 1, seed.size(), file) == seed.size();
        if (file == nullptr || std::fclose(file) != 0 || !good) {
            std::fprintf(stderr, "fuzz_seeds: cannot write '%s'\n", path.c_str());
            return 1;
        }
    }
    return 0;
}
