// What the command line says, and to whom: words on standard output, problems on standard error.
#pragma once

#include <string>
#include <utility>

#include <fmt/format.h>

#include <spangle/sim/image.hpp>

#include "host_sim/output/output.hpp"

namespace spangle::cli {

/// Exit statuses: what was asked for makes no sense; and it was done, but could not be written or shown.
inline constexpr int bad_input = 2, not_done = 1;

/// On standard error. Where nobody takes that there is nobody to tell.
void tell(const std::string& text);
/// "spangle: WHY", and the status to exit with.
int refuse(const std::string& why, int status = bad_input);

/// Words for people, and figures for programs: on standard output, unless a file takes it.
void print_text(const std::string& text);
template <class... Values> void print(fmt::format_string<Values...> format, Values&&... values) {
    print_text(fmt::format(format, std::forward<Values>(values)...));
}

/// A file that an option names. Where that is standard output, no other file may be, and words go to standard
/// error from then on. Empty, or the rule that is broken.
std::string claim(const char* option, const std::string& path);
/// What took standard output, as an option; empty: nothing.
const std::string& claimed();
/// Opens it as well, unless `path` is empty.
std::string open(sim::Output& file, const char* option, const std::string& path);
/// The file is this picture, as PNG. Empty, or what went wrong.
std::string finish(sim::Output& file, const sim::Image& picture);

} // namespace spangle::cli
