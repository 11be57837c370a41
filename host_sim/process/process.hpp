// Runs other programs, waits for their end, and keeps what they print.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace spangle::process {

/// Statuses as shells have them: there is no such program; it could not be run; it ended by a signal, whose
/// number is added.
inline constexpr int no_program = 127, could_not_run = 126, of_signals = 128;

/// The place of a program's stream: a file descriptor, or one of these values.
inline constexpr int inherited = -1, nowhere = -2;
struct Streams {
    int in = inherited, out = inherited, error = inherited;
};

struct ExitStatus {
    int status;    ///< exit status of the program, or one of the three above
    int error = 0; ///< errno of why it could not be run; 0: it ran
};

/// Runs a program, found by PATH, to its end. Signals have their default actions in it.
ExitStatus run(const std::vector<std::string>& words, const Streams& streams = {});

/// A file without a name, for what a program reads or prints.
class TemporaryFile {
  public:
    TemporaryFile() : file_(std::tmpfile()) {}
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    /// The file's descriptor; -1 if no file could be made.
    int descriptor() const { return file_ != nullptr ? fileno(file_) : -1; }
    /// Stores `text`, to be read from its beginning. Returns false if it could not be stored.
    bool put(const std::string& text);
    /// All that was written to the file.
    std::string text() const;

  private:
    std::FILE* file_;
};

} // namespace spangle::process
