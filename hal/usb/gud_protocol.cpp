#include "hal/usb/gud_protocol.hpp"

namespace spangle::hal::gud {
namespace {

std::uint64_t read_number(const std::uint8_t* from, int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i)
        value |= std::uint64_t{from[i]} << 8 * i;
    return value;
}

std::uint32_t read_u32(const std::uint8_t* from) {
    return static_cast<std::uint32_t>(read_number(from, 4));
}

std::uint16_t read_u16(const std::uint8_t* from) {
    return static_cast<std::uint16_t>(read_number(from, 2));
}

/// A number of a detailed timing: twelve bits, the upper four in another byte (VESA E-EDID 1.4, 3.10.2).
std::uint16_t join_12_bits(unsigned low, unsigned high_nibble) {
    return static_cast<std::uint16_t>(low | (high_nibble & 0xF) << 8);
}

} // namespace

const char* name_of(std::uint8_t request) {
    switch (request) {
    case GET_STATUS:
        return "GET_STATUS";
    case GET_DESCRIPTOR:
        return "GET_DESCRIPTOR";
    case GET_FORMATS:
        return "GET_FORMATS";
    case GET_PROPERTIES:
        return "GET_PROPERTIES";
    case GET_CONNECTORS:
        return "GET_CONNECTORS";
    case GET_CONNECTOR_PROPERTIES:
        return "GET_CONNECTOR_PROPERTIES";
    case SET_CONNECTOR_FORCE_DETECT:
        return "SET_CONNECTOR_FORCE_DETECT";
    case GET_CONNECTOR_STATUS:
        return "GET_CONNECTOR_STATUS";
    case GET_CONNECTOR_MODES:
        return "GET_CONNECTOR_MODES";
    case GET_CONNECTOR_EDID:
        return "GET_CONNECTOR_EDID";
    case SET_BUFFER:
        return "SET_BUFFER";
    case SET_STATE_CHECK:
        return "SET_STATE_CHECK";
    case SET_STATE_COMMIT:
        return "SET_STATE_COMMIT";
    case SET_CONTROLLER_ENABLE:
        return "SET_CONTROLLER_ENABLE";
    default:
        return "SET_DISPLAY_ENABLE";
    }
}

const char* status_text(std::uint8_t status) {
    static constexpr const char* texts[] = {
        "nothing is wrong", "busy", "request not supported", "protocol error", "invalid parameter", "error"};
    return status < sizeof texts / sizeof texts[0] ? texts[status] : "an unknown status";
}

bool parse(Descriptor& into, const std::uint8_t* bytes, std::size_t count) {
    if (count != descriptor_bytes || read_u32(bytes) != magic || bytes[4] != 1)
        return false;
    into.flags = read_u32(bytes + 5);
    into.compression = bytes[9];
    into.max_buffer_size = read_u32(bytes + 10);
    into.min_width = read_u32(bytes + 14);
    into.max_width = read_u32(bytes + 18);
    into.min_height = read_u32(bytes + 22);
    into.max_height = read_u32(bytes + 26);
    return true;
}

Mode parse_mode(const std::uint8_t* bytes) {
    Mode mode;
    mode.clock_khz = read_u32(bytes);
    for (int i = 0; i < 4; ++i) {
        mode.horizontal[i] = read_u16(bytes + 4 + 2 * i);
        mode.vertical[i] = read_u16(bytes + 12 + 2 * i);
    }
    mode.flags = read_u32(bytes + 20);
    return mode;
}

Mode edid_mode(const std::uint8_t* edid, std::size_t count) {
    Mode mode;
    if (count < edid_block)
        return mode;
    const std::uint8_t* const d = edid + 54; // the first descriptor of the EDID
    mode.clock_khz = read_u16(d) * 10u;
    const std::uint16_t sizes[2] = {join_12_bits(d[2], d[4] >> 4u), join_12_bits(d[5], d[7] >> 4u)};
    const std::uint16_t blanks[2] = {join_12_bits(d[3], d[4]), join_12_bits(d[6], d[7])};
    const unsigned front[2] = {d[8] | (d[11] >> 6u & 3u) << 8, (d[10] >> 4u) | (d[11] >> 2u & 3u) << 4};
    const unsigned sync[2] = {d[9] | (d[11] >> 4u & 3u) << 8, (d[10] & 0xFu) | (d[11] & 3u) << 4};
    for (int axis = 0; axis < 2; ++axis) {
        std::uint16_t* const timing = axis == 0 ? mode.horizontal : mode.vertical;
        timing[0] = sizes[axis];
        timing[1] = static_cast<std::uint16_t>(sizes[axis] + front[axis]);
        timing[2] = static_cast<std::uint16_t>(timing[1] + sync[axis]);
        timing[3] = static_cast<std::uint16_t>(sizes[axis] + blanks[axis]);
    }
    mode.flags = MODE_PREFERRED;
    return mode;
}

Property parse_property(const std::uint8_t* bytes) {
    return {read_u16(bytes), read_number(bytes + 2, 8)};
}

void append(Bytes& to, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i)
        to.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

Bytes state(const Mode& mode, std::uint8_t format, std::uint8_t connector,
            const std::vector<Property>& properties) {
    Bytes bytes;
    append(bytes, mode.clock_khz, 4);
    for (const std::uint16_t v : mode.horizontal)
        append(bytes, v, 2);
    for (const std::uint16_t v : mode.vertical)
        append(bytes, v, 2);
    append(bytes, mode.flags, 4);
    append(bytes, format, 1);
    append(bytes, connector, 1);
    for (const Property& p : properties) {
        append(bytes, p.id, 2);
        append(bytes, p.value, 8);
    }
    return bytes;
}

Bytes buffer(const Buffer& b) {
    Bytes bytes;
    for (const std::uint32_t v : {b.x, b.y, b.width, b.height, b.length})
        append(bytes, v, 4);
    append(bytes, b.compressed_length != 0 ? COMPRESSION_LZ4 : 0, 1);
    append(bytes, b.compressed_length, 4);
    return bytes;
}

} // namespace spangle::hal::gud
