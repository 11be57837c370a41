// The kernel's small text files: /sys, /sys/kernel/config, /sys/kernel/tracing.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace kernel_test {

/// Throws with the file's name and the kernel's reason.
void write_text(const std::string& path, const std::string& text);
/// Without the newline at its end.
std::string read_text(const std::string& path);
bool exists(const std::string& path);
/// Waits for what the kernel does in its own time; throws, saying `what`, when it does not.
void await(const char* what, const std::function<bool()>& done,
           std::chrono::seconds patience = std::chrono::seconds(5));

} // namespace kernel_test
