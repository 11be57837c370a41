// Unpacks and bakes under libFuzzer what the process that reads a model hands over.
#include "tests/tools/bake/packed_model.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t bytes) {
    bake_test::run_packed_model(data, bytes);
    return 0;
}
