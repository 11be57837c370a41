// The host of GUD displays against devices that answer what they like, under libFuzzer.
#include "tests/hal_usb/gud_stream.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t bytes) {
    gud_test::run_gud_stream(data, bytes);
    return 0;
}
