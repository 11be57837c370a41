#include "hal/linux/persist.hpp"

#include <ctime>

namespace spangle::hal {

void pause_micros(std::uint32_t micros) {
    timespec left{static_cast<std::time_t>(micros / 1000000), static_cast<long>(micros % 1000000) * 1000};
    while (clock_nanosleep(CLOCK_MONOTONIC, 0, &left, &left) == EINTR) {
    }
}

} // namespace spangle::hal
