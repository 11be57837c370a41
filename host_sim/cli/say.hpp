// Where the output of the command line goes: words to standard output, problems to standard error.
#pragma once

#include <string>
#include <utility>

#include <fmt/format.h>

#include <spangle/sim/image.hpp>

#include "host_sim/output/output.hpp"

namespace spangle::cli {

/// Exit statuses. bad_input: the request makes no sense. not_done: the request could not be done, or its
/// result could not be written or shown.
inline constexpr int bad_input = 2, not_done = 1;

/// Prints on standard error. Failures are ignored, because there is nobody to tell them to.
void tell(const std::string& text);
/// Prints "spangle: WHY" on standard error, and returns the status to exit with.
int refuse(const std::string& why, int status = bad_input);

/// Prints words for people, and figures for programs. They go to standard output, or to standard error where
/// a file takes standard output.
void print_text(const std::string& text);
template <class... Values> void print(fmt::format_string<Values...> format, Values&&... values) {
    print_text(fmt::format(format, std::forward<Values>(values)...));
}

/// Notes a file that an option names. Only one file may be standard output, and words go to standard error
/// from then on. Returns the rule that is broken, or an empty string.
std::string claim_output(const char* option, const std::string& path);
/// The option whose file is standard output; empty: none is.
const std::string& claiming_option();
/// Notes the file and opens it, unless `path` is empty.
std::string open(sim::Output& file, const char* option, const std::string& path);
/// Writes the picture into the file, as PNG. Returns what went wrong, or an empty string.
std::string finish(sim::Output& file, const sim::Image& picture);

} // namespace spangle::cli
