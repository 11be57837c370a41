// What all processors do between reset and main().
#pragma once

#include <cstdint>

#include <spangle/mcu/panic.hpp>
#include <spangle/mcu/stack.hpp>

extern "C" {
extern std::uint32_t data_load, data_begin, data_end, bss_begin, bss_end;
extern void (*__init_array_start[])();
extern void (*__init_array_end[])();
int main();
}

namespace spangle::mcu {

/// Paints the stack up to a few words below its caller's frame, fills .data and .bss, runs constructors, then
/// main().
[[noreturn]] inline void start_program() {
    std::uint32_t here;
    for (volatile std::uint32_t* p = &stack_bottom; p + 16 < &here; ++p)
        *p = stack_paint;
    const std::uint32_t* from = &data_load;
    if (from != &data_begin)
        for (std::uint32_t* to = &data_begin; to < &data_end;)
            *to++ = *from++;
    for (std::uint32_t* to = &bss_begin; to < &bss_end;)
        *to++ = 0;
    for (auto constructor = __init_array_start; constructor != __init_array_end; ++constructor)
        (*constructor)();
    panic({Cause::returned, 0, static_cast<std::uint32_t>(main())});
}

} // namespace spangle::mcu
