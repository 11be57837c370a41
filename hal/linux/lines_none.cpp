// A build without libgpiod: buses that need no line work, the others say what is missing.
#include <spangle/linux/lines.hpp>

#include <cerrno>

#include "hal/linux/line_names.hpp"

namespace spangle::hal {
namespace {

constexpr const char* missing = "this build has no libgpiod; install libgpiod-dev and configure again";

int refuse() {
    errno = EOPNOTSUPP;
    return -1;
}

} // namespace

struct Lines::Request {};
struct EdgeLine::Request {};

Lines::Lines() = default;
Lines::~Lines() = default;
void Lines::close() {}

Result<void> Lines::open(const char*, std::span<const unsigned>, const std::uint32_t*) {
    return error_.say(Fault::unsupported, name_, "request", missing);
}

int Lines::set_values(std::uint32_t) {
    return refuse();
}

int Lines::get_values(std::uint32_t&) {
    return refuse();
}

int Lines::make_outputs(std::uint32_t) {
    return refuse();
}

int Lines::make_inputs() {
    return refuse();
}

EdgeLine::EdgeLine() = default;
EdgeLine::~EdgeLine() = default;
void EdgeLine::close() {}

Result<void> EdgeLine::open(const LineRef& ref) {
    const unsigned offsets[] = {ref.offset};
    name_lines(name_, ref.chip, offsets);
    return error_.say(Fault::unsupported, name_, "request edges", missing);
}

int EdgeLine::wait(std::int64_t) {
    return refuse();
}

int EdgeLine::take(std::uint64_t&) {
    return refuse();
}

} // namespace spangle::hal
