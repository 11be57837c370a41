// Writes what a fuzzer's corpus starts from.
// usage: fuzz_seeds NAME FOLDER
#include <cstdio>
#include <string>
#include <vector>

#include <spangle/sim/image.hpp>

#include "tests/gl/api/command_seeds.hpp"
#include "tests/system/sim/controller_stream.hpp"
#include "tests/system/streams/egl_stream.hpp"
#include "tests/tools/bake/packed_model.hpp"
#include "tests/unit/hal_usb/gud_stream.hpp"

namespace {

using Seeds = std::vector<std::vector<std::uint8_t>>;

/// Returns pictures with alpha and without.
Seeds pictures() {
    Seeds out;
    for (const std::uint8_t alpha : {255, 90}) {
        spangle::sim::Image image(9, 5);
        image.rgba[3] = alpha;
        std::string bytes;
        spangle::sim::encode_png(image, bytes);
        out.emplace_back(bytes.begin(), bytes.end());
    }
    return out;
}

struct Fuzzer {
    const char* name;
    Seeds (*seeds)();
};
constexpr Fuzzer fuzzers[] = {{"gl_commands", spangle::test::command_seeds},
                              {"egl", spangle::test::egl_seeds},
                              {"gud", gud_test::gud_seeds},
                              {"controller", sim_test::controller_seeds},
                              {"model", bake_test::packed_models},
                              {"picture", pictures}};

int write(const Seeds& seeds, const std::string& folder) {
    int number = 0;
    for (const auto& seed : seeds) {
        const std::string path = folder + "/seed-" + std::to_string(number++);
        std::FILE* const file = std::fopen(path.c_str(), "wb");
        const bool good = file != nullptr && std::fwrite(seed.data(), 1, seed.size(), file) == seed.size();
        if (file == nullptr || std::fclose(file) != 0 || !good) {
            std::fprintf(stderr, "fuzz_seeds: cannot write '%s'\n", path.c_str());
            return 1;
        }
    }
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    for (const Fuzzer& fuzzer : fuzzers)
        if (argc == 3 && std::string(argv[1]) == fuzzer.name)
            return write(fuzzer.seeds(), argv[2]);
    std::fputs("usage: fuzz_seeds gl_commands|egl|gud|controller|model|picture FOLDER\n", stderr);
    return 2;
}
