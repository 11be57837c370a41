// Tells how much memory this process ever had at once.
#pragma once

#include <cstddef>
#include <cstdio>

namespace spangle::cli {

/// The largest resident size in bytes, as Linux counts it (VmHWM; getrusage would count the shell before
/// exec, too). 0 where Linux does not tell it.
inline std::size_t process_peak() {
    std::FILE* const status = std::fopen("/proc/self/status", "r");
    if (status == nullptr)
        return 0;
    char line[256];
    unsigned long kilobytes = 0;
    while (std::fgets(line, sizeof line, status) != nullptr)
        if (std::sscanf(line, "VmHWM: %lu kB", &kilobytes) == 1)
            break;
    std::fclose(status);
    return std::size_t{kilobytes} * 1024;
}

} // namespace spangle::cli
