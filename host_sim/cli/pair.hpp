// The drop-in pair as the command line uses it: programs that others linked, in processes of their own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace spangle::cli::pair {

/// Programs that are run from here on find the pair before the system's GL. Empty, or why there is none.
std::string use();

/// Sets a variable that the pair reads (docs/programs.md); empty: it is not set.
void set(const char* variable, const std::string& value);

/// Runs a program to its end: its status, as process::run() has it. `words` names a file that takes what the
/// program prints; empty: nothing is taken.
int run(const std::vector<std::string>& program, const std::filesystem::path& words = {});

/// Why this file cannot be replayed, as a sentence without a name in front; empty: apitrace can read it.
std::string trace_problem(const std::string& trace);

/// Makes a retracer draw to pbuffers, of which each that it swaps is shown. The command that replays a trace.
std::vector<std::string> retrace(const std::string& trace);

/// A folder for files, which is gone when this is.
class Folder {
  public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    /// Empty: none could be made.
    const std::filesystem::path& path() const { return path_; }
    /// Why not, as a sentence.
    static std::string problem();

  private:
    std::filesystem::path path_;
};

} // namespace spangle::cli::pair
