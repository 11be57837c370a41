#include "host_sim/dropin/options.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <spangle/boards/boards.hpp>

#include "host_sim/capture/names.hpp"

namespace spangle::dropin {

namespace {

constexpr int bad_input = 2;
constexpr std::size_t megabyte = 1u << 20;
constexpr long usual_memory = 1024, most_memory = 1 << 16; ///< megabytes; pages are taken when first used

[[noreturn]] void refuse(const char* variable, const char* value, const char* takes) {
    std::fprintf(stderr, "spangle: %s=%s: it takes %s\n", variable, value, takes);
    std::_Exit(bad_input);
}

/// The value of an environment variable; null where it is not set, or empty.
const char* value_of(const char* variable) {
    const char* const value = std::getenv(variable);
    return value == nullptr || *value == '\0' ? nullptr : value;
}

std::string text_of(const char* variable) {
    const char* const value = value_of(variable);
    return value == nullptr ? "" : value;
}

/// The number in an environment variable; `usual` where it is not set. `base` is that of the digits; 0: a
/// prefix tells it, as in 0x3C.
long number_of(const char* variable, long least, long most, long usual, int base = 10) {
    const char* const value = value_of(variable);
    if (value == nullptr)
        return usual;
    char* end = nullptr;
    const long number = std::strtol(value, &end, base);
    if (*end != '\0' || number < least || number > most) {
        char takes[64];
        std::snprintf(takes, sizeof takes, "a number from %ld to %ld", least, most);
        refuse(variable, value, takes);
    }
    return number;
}

bool flag_of(const char* variable) {
    return number_of(variable, 0, 1, 0) == 1;
}

/// The value whose name an environment variable holds; `usual` where it is not set.
template <class Row, unsigned Count, class Value>
Value read_named_option(const char* variable, const Row (&table)[Count], Value usual) {
    const char* const value = value_of(variable);
    if (value == nullptr)
        return usual;
    if (const Row* const row = names::find(table, value); row != nullptr)
        return row->value;
    refuse(variable, value, names::listed(table).c_str());
}

const hal::Board* board_of(const char* variable) {
    const char* const value = value_of(variable);
    if (value == nullptr)
        return nullptr;
    const std::size_t length = std::strlen(value);
    for (const hal::Board* board : boards::all)
        if (std::strcmp(board->name, value) == 0 ||
            (std::strncmp(board->name, value, length) == 0 && board->name[length] == '-'))
            return board;
    refuse(variable, value, "the name of a board; `spangle boards` lists them");
}

void read_size(const char* variable, Options& out) {
    const char* const value = value_of(variable);
    char rest = 0;
    if (value != nullptr && (std::sscanf(value, "%dx%d%c", &out.width, &out.height, &rest) != 2 ||
                             out.width < 1 || out.height < 1 || out.width > 2048 || out.height > 2048))
        refuse(variable, value, "WIDTHxHEIGHT, each 1 to 2048");
}

bool panel_format(const char* variable) {
    const char* const value = value_of(variable);
    if (value == nullptr || std::strcmp(value, "rgba") == 0)
        return false;
    if (std::strcmp(value, "panel") != 0)
        refuse(variable, value, "rgba or panel");
    return true;
}

std::optional<PixelFormat> format_of(const char* variable) {
    return read_named_option(variable, names::formats, std::optional<PixelFormat>());
}

/// The bus of a real display, as the environment describes it.
bringup::BusOptions bus_of_environment() {
    constexpr long first_address = 0x03, usual_address = 0x3C, last_address = 0x77, most_hz = 1000000000;
    bringup::BusOptions out;
    out.spidev = text_of("SPANGLE_SPIDEV");
    out.dc = text_of("SPANGLE_DC");
    out.reset = text_of("SPANGLE_RESET");
    out.light = text_of("SPANGLE_LIGHT");
    out.te = text_of("SPANGLE_TE");
    out.i2c = text_of("SPANGLE_I2C");
    out.address =
        static_cast<unsigned>(number_of("SPANGLE_ADDRESS", first_address, last_address, usual_address, 0));
    out.ftdi = flag_of("SPANGLE_FTDI");
    out.gud = flag_of("SPANGLE_GUD");
    out.usb_file = text_of("SPANGLE_USB");
    out.hz = static_cast<std::uint32_t>(number_of("SPANGLE_HZ", 1, most_hz, 0));
    out.read_hz = static_cast<std::uint32_t>(number_of("SPANGLE_READ_HZ", 1, most_hz, 0));
    return out;
}

/// Sets the board, and the bus of a real display that replaces its simulation.
void read_board(Options& out) {
    out.board = board_of("SPANGLE_BOARD");
    out.bus = bus_of_environment();
    if (!out.bus.real())
        return;
    if (out.board == nullptr)
        out.board = bringup::find_board(out.bus.board_name());
    out.bus.board = out.board->name;
    if (const std::string problem = bringup::mismatch(out.bus, *out.board); !problem.empty()) {
        std::fprintf(stderr, "spangle: %s\n", problem.c_str());
        std::_Exit(bad_input);
    }
}

Options read() {
    Options out;
    read_board(out);
    read_size("SPANGLE_SIZE", out);
    out.precision =
        read_named_option("SPANGLE_PRECISION", names::precisions, EGLint{EGL_PRECISION_EXACT_SPANGLE});
    out.panel_format = panel_format("SPANGLE_FORMAT") && out.board != nullptr;
    out.shot = text_of("SPANGLE_SHOT");
    out.report = text_of("SPANGLE_REPORT");
    out.record = text_of("SPANGLE_RECORD");
    out.record_format = format_of("SPANGLE_RECORD_FORMAT");
    out.capture = text_of("SPANGLE_CAPTURE");
    out.capture_format = format_of("SPANGLE_CAPTURE_FORMAT");
    out.times_only = flag_of("SPANGLE_CAPTURE_TIMES");
    out.dither = number_of("SPANGLE_CAPTURE_DITHER", 0, 1, 1) == 1;
    out.frames = number_of("SPANGLE_FRAMES", 1, 1000000000, 0);
    out.memory =
        static_cast<std::size_t>(number_of("SPANGLE_MEMORY", 1, most_memory, usual_memory)) * megabyte;
    out.end_by_signal = flag_of("SPANGLE_SIGNAL");
    out.messages = flag_of("SPANGLE_MESSAGES");
    return out;
}

} // namespace

const Options& options() {
    static const Options* const read_once = new Options(read()); // never freed, because it is used to the end
    return *read_once;
}

} // namespace spangle::dropin
