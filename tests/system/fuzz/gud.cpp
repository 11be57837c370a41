// Runs the host of GUD displays under libFuzzer, against devices that answer whatever they like.
#include "tests/unit/hal_usb/gud_stream.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t bytes) {
    gud_test::run_gud_stream(data, bytes);
    return 0;
}
