// Runs the controller models at their pins and byte ports under libFuzzer.
#include "tests/system/sim/controller_stream.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t bytes) {
    sim_test::run_controller_stream(data, bytes);
    return 0;
}
