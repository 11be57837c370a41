// The clock by which frames are timed.
#pragma once

#include <ctime>

namespace spangle::trade {

/// The microseconds that this thread has spent on a processor. Other programs on the machine add nothing.
inline double thread_microseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

} // namespace spangle::trade
