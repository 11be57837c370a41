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
/// Becomes true within two seconds: what the kernel does in a process of its own. Else throws, saying `what`.
void await(const char* what, const std::function<bool()>& done);

} // namespace kernel_test
