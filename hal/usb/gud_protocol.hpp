// The wire format of GUD (include/drm/gud.h): numbers are little-endian, structures are packed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spangle::hal::gud {

enum Request : std::uint8_t {
    GET_STATUS = 0x00,
    GET_DESCRIPTOR = 0x01,
    GET_FORMATS = 0x40,
    GET_PROPERTIES = 0x41,
    GET_CONNECTORS = 0x50,
    GET_CONNECTOR_PROPERTIES = 0x51,
    SET_CONNECTOR_FORCE_DETECT = 0x53,
    GET_CONNECTOR_STATUS = 0x54,
    GET_CONNECTOR_MODES = 0x55,
    GET_CONNECTOR_EDID = 0x56,
    SET_BUFFER = 0x60,
    SET_STATE_CHECK = 0x61,
    SET_STATE_COMMIT = 0x62,
    SET_CONTROLLER_ENABLE = 0x63,
    SET_DISPLAY_ENABLE = 0x64,
};
const char* name_of(std::uint8_t request);
/// The text for a status that GET_STATUS returned.
const char* status_text(std::uint8_t status);

inline constexpr std::uint32_t magic = 0x1d50614d;
enum : std::uint32_t { STATUS_ON_SET = 1u << 0, FULL_UPDATE = 1u << 1 }; ///< flags of a descriptor
enum : std::uint8_t { COMPRESSION_LZ4 = 1u << 0 };
enum : std::uint32_t { POLL_STATUS = 1u << 0 };     ///< flags of a connector
enum : std::uint32_t { MODE_PREFERRED = 1u << 10 }; ///< flags of a mode
enum : std::uint16_t { BACKLIGHT_BRIGHTNESS = 12 }; ///< property of a connector, from 0 to 100

inline constexpr std::size_t descriptor_bytes = 30, most_formats = 32, mode_bytes = 24, most_modes = 128,
                             connector_bytes = 5, most_connectors = 32, property_bytes = 10,
                             most_properties = 32, edid_block = 128, most_edid = 2048;

struct Descriptor {
    std::uint32_t flags = 0, max_buffer_size = 0;
    std::uint8_t compression = 0;
    std::uint32_t min_width = 0, max_width = 0, min_height = 0, max_height = 0;
};
/// Parses a descriptor; false if it is not one of version 1.
bool parse(Descriptor& into, const std::uint8_t* bytes, std::size_t count);

struct Mode {
    std::uint32_t clock_khz = 0;
    /// Pixels or lines from the start: the displayed ones, start and end of sync, and all.
    std::uint16_t horizontal[4] = {}, vertical[4] = {};
    std::uint32_t flags = 0;
};
Mode parse_mode(const std::uint8_t* bytes);
/// The first detailed timing of an EDID, which is its preferred mode. A mode without a clock: there is none.
Mode edid_mode(const std::uint8_t* edid, std::size_t count);

struct Property {
    std::uint16_t id = 0;
    std::uint64_t value = 0;
};
Property parse_property(const std::uint8_t* bytes);

using Bytes = std::vector<std::uint8_t>;
void append(Bytes& to, std::uint64_t value, int bytes);
/// The data of SET_STATE_CHECK: mode, format, connector, every property.
Bytes state(const Mode& mode, std::uint8_t format, std::uint8_t connector,
            const std::vector<Property>& properties);

struct Buffer {
    std::uint32_t x = 0, y = 0, width = 0, height = 0, length = 0, compressed_length = 0;
};
/// The data of SET_BUFFER. `compressed_length` 0: not compressed.
Bytes buffer(const Buffer& b);

} // namespace spangle::hal::gud
