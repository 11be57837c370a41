// PCI Express configuration space (ECAM) of one bus, and base addresses for the device that is asked for.
// PCI Local Bus Specification 3.0, 6.1.
#pragma once

#include <cstdint>

#include <spangle/mcu/registers.hpp>

namespace spangle::mcu {

/// Finds the device's configuration space; 0: there is no such device.
inline std::uintptr_t find_pci(std::uintptr_t ecam, std::uint16_t vendor, std::uint16_t device) {
    constexpr unsigned devices = 32;
    for (unsigned i = 0; i < devices; ++i)
        if (const std::uintptr_t at = ecam + (std::uintptr_t{i} << 15);
            reg(at) == (std::uint32_t{device} << 16 | vendor))
            return at;
    return 0;
}

/// Sets base address register `bar`, 0 to 5, of a device's configuration space.
inline void set_pci_base(std::uintptr_t device, unsigned bar, std::uintptr_t address) {
    reg(device + 0x10 + 4 * bar) = static_cast<std::uint32_t>(address);
}

/// Lets the device answer at its base addresses.
inline void enable_pci_memory(std::uintptr_t device) {
    set_bits(device + 0x04, 1u << 1);
}

} // namespace spangle::mcu
