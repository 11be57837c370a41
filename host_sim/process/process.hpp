// Other programs: started, waited for, and what they said.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace spangle::process {

/// Statuses of shells: there is no such program; it could not be run; it ended by a signal, whose number is
/// added.
inline constexpr int no_program = 127, could_not_run = 126, of_signals = 128;

/// Where a stream of the program goes: a file descriptor, or one of these.
inline constexpr int inherited = -1, nowhere = -2;
struct Streams {
    int in = inherited, out = inherited, error = inherited;
};

struct Ended {
    int status;    ///< its own, or one of the three above
    int error = 0; ///< why it could not be run, as errno has it; 0: it ran
};

/// Runs a program of PATH to its end. Signals do in it what they do by default.
Ended run(const std::vector<std::string>& words, const Streams& streams = {});

/// A file without a name, for what a program reads or says.
class Scratch {
  public:
    Scratch() : file_(std::tmpfile()) {}
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    /// -1: there is no such file, because none could be made.
    int descriptor() const { return file_ != nullptr ? fileno(file_) : -1; }
    /// Puts `text` there, to be read from its beginning. False: it has no place.
    bool put(const std::string& text);
    /// All that was written.
    std::string text() const;

  private:
    std::FILE* file_;
};

} // namespace spangle::process
