// Runs programs that others linked with the drop-in pair, in processes of their own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace spangle::cli::pair {

/// Makes programs that are run from here on find the pair before the system's GL. Returns why that fails, or
/// an empty string.
std::string use();

/// Sets an environment variable that the pair reads (docs/programs.md). An empty value unsets it.
void set(const char* variable, const std::string& value);

/// Runs a program to its end and returns its status, as process::run() does. `words` names a file that takes
/// what the program prints; empty: the output is not redirected.
int run(const std::vector<std::string>& program, const std::filesystem::path& words = {});

/// Why this file cannot be replayed, as a sentence without a name in front; empty if apitrace can read it.
std::string trace_problem(const std::string& trace);

/// Prepares a retracer that draws to pbuffers; each swapped pbuffer is shown. Returns the command that
/// replays the trace.
std::vector<std::string> retrace(const std::string& trace);

/// A temporary folder for files, which is removed with this object.
class Folder {
  public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    /// The path; empty if no folder could be made.
    const std::filesystem::path& path() const { return path_; }
    /// Why no folder could be made, as a sentence.
    static std::string problem();

  private:
    std::filesystem::path path_;
};

} // namespace spangle::cli::pair
