// What the process that reads a model hands over, unpacked and baked, under libFuzzer.
#include "tests/bake/packed_model.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t bytes) {
    bake_test::run_packed_model(data, bytes);
    return 0;
}
