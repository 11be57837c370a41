// Repeats system calls that were interrupted, or whose device was not ready.
#pragma once

#include <cerrno>
#include <cstdint>

namespace spangle::hal {

/// Sleeps at least this long, whatever signals arrive.
void pause_micros(std::uint32_t micros);

inline constexpr int most_interruptions = 1000;
inline constexpr int most_patience = 100; ///< how often a call waits for 1 ms

/// Repeats a call while a signal interrupts it (EINTR) or the device is not ready (EAGAIN), within these
/// bounds. Returns its last answer, which is negative on an error in errno.
template <class Call> auto retry_interrupted(Call call) {
    int interrupted = 0, waited = 0;
    for (;;) {
        const auto answer = call();
        if (answer >= 0)
            return answer;
        if (errno == EINTR && ++interrupted < most_interruptions)
            continue;
        if (errno != EAGAIN || ++waited >= most_patience)
            return answer;
        pause_micros(1000);
    }
}

} // namespace spangle::hal
