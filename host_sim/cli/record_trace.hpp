// Runs the tools of apitrace for a bounded time: the tracer that records a program, and others.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace spangle::cli {

/// How a tool ended. A `problem` says that the tool is not installed, or took too long. The status then has
/// no meaning.
struct ToolResult {
    int status = 0;
    std::string problem;
};

/// Runs a tool to its end; `words` takes what it prints.
ToolResult run_bounded(const std::vector<std::string>& command, const std::filesystem::path& words);

/// The first function that a tracer or retracer could not find, according to its output. The result is empty
/// if it found all functions.
std::string unavailable_function(const std::filesystem::path& words);

/// Runs a program on the drop-in pair with windows of this size, for `frames` frames. Records its calls of
/// "gl" (with GLX) or "egl" into a file. Returns why there is no file, or an empty string.
std::string record_trace(const std::vector<std::string>& program, const std::string& api, int width,
                         int height, int frames, const std::filesystem::path& folder,
                         const std::filesystem::path& to);

} // namespace spangle::cli
