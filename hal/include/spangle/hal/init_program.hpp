// An initialisation list that reads like the datasheet's table and lies in flash as bytes:
//     constexpr auto setup = init_program(cmd(PWCTR1, 0x23), cmd(VMCTR1, 0x3E, 0x28), delay_ms(120));
// Encoding: command, parameter count, parameters; a count of 0xFF marks a delay, and the "command" is its
// tens of ms.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace spangle::hal {

/// The bytes of a program.
template <std::size_t N> using ProgramBytes = std::array<std::uint8_t, N>;

/// The parameter count that marks a delay.
inline constexpr std::uint8_t program_delay_mark = 0xFF;

/// One command with its parameters, which are cut to bytes; at most 254 of them.
template <class... Params>
constexpr ProgramBytes<2 + sizeof...(Params)> cmd(unsigned command, Params... params) {
    static_assert(sizeof...(Params) < program_delay_mark);
    return {static_cast<std::uint8_t>(command), static_cast<std::uint8_t>(sizeof...(Params)),
            static_cast<std::uint8_t>(params)...};
}

/// A delay, rounded up to 10 ms; at most 2550 ms.
consteval ProgramBytes<2> delay_ms(unsigned ms) {
    return {static_cast<std::uint8_t>((ms + 9) / 10), program_delay_mark};
}

/// Joins steps of cmd() and delay_ms() to the bytes of a program.
template <std::size_t... N> constexpr auto init_program(const ProgramBytes<N>&... steps) {
    ProgramBytes<(N + ... + 0)> bytes{};
    std::size_t at = 0;
    const auto append = [&](const auto& step) {
        for (std::uint8_t byte : step)
            bytes[at++] = byte;
    };
    (append(steps), ...);
    return bytes;
}

/// A program as a panel names it, and a cursor over it.
struct Program {
    /// The next step, in memory that outlives the program.
    const std::uint8_t* at = nullptr;
    /// Bytes that are left.
    std::size_t size = 0;

    /// The empty program.
    constexpr Program() = default;
    /// A program over these bytes, which must outlive it.
    template <std::size_t N> constexpr Program(const ProgramBytes<N>& bytes) : at(bytes.data()), size(N) {}

    /// One step: a command with its parameters, or a delay.
    struct Step {
        /// The command byte.
        const std::uint8_t* command;
        /// The `count` parameters of the command, in the program's memory.
        const std::uint8_t* params;
        /// The number of parameters.
        std::uint8_t count;
        std::uint32_t delay_micros; ///< above 0 in a delay, which has no command
    };

    /// Whether no step is left.
    constexpr bool empty() const { return size == 0; }

    /// Takes the first step off. The program must not be empty.
    constexpr Step next() {
        const std::uint8_t* const first = at;
        const bool delays = first[1] == program_delay_mark;
        const auto count = delays ? std::uint8_t{0} : first[1];
        at += 2u + count;
        size -= 2u + count;
        return {first, first + 2, count, delays ? first[0] * 10000u : 0};
    }
};

/// True when every step ends inside the program.
constexpr bool well_formed(Program program) {
    while (!program.empty()) {
        if (program.size < 2)
            return false;
        if (program.at[1] != program_delay_mark && program.size < 2u + program.at[1])
            return false;
        program.next();
    }
    return true;
}

} // namespace spangle::hal
