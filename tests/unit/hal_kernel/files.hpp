// Reads and writes the kernel's small text files: /sys, /sys/kernel/config, /sys/kernel/tracing.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace kernel_test {

/// Throws an error with the file's name and the kernel's reason.
void write_text(const std::string& path, const std::string& text);
/// Returns the text without the newline at its end.
std::string read_text(const std::string& path);
bool exists(const std::string& path);
/// Waits for something that the kernel does in its own time. Throws an error that says `what` if it does not
/// happen.
void await(const char* what, const std::function<bool()>& done,
           std::chrono::seconds patience = std::chrono::seconds(5));

} // namespace kernel_test
