// Where what a tool writes goes. A regular file is written whole or not at all: a new file takes its place
// when everything is in it. Devices, pipes and open descriptors are written to as they are, and never
// replaced.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace spangle::sim {

class Output {
  public:
    Output() = default;
    /// Gives up what was not committed: of a regular file nothing is seen.
    ~Output();
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    /// Empty, or why nothing can be written there. "-" is standard output; symbolic links are followed. The
    /// file that has this name stays as it is until commit().
    std::string open(const std::string& path);
    bool is_open() const { return file_ >= 0; }
    /// The bytes share this program's standard output with whatever else it prints.
    bool on_standard_output() const { return descriptor_ == 1; }

    /// Keeps bytes to be written. False when something was lost already; commit() then says what.
    bool write(std::string_view bytes);
    /// What was written so far, in bytes.
    std::uint64_t size() const { return size_; }
    /// Hands on what is kept, to those who look while a program runs. False as of write().
    bool flush();
    /// Everything is written, and a regular file has its name from here on. Empty, or what went wrong: then
    /// the file that had the name is still there.
    std::string commit();

  private:
    std::string path_;       ///< as the user gave it, for messages
    std::string target_;     ///< of a regular file: where its links end
    std::string unfinished_; ///< name of the new file; empty: it has none yet, or nothing is replaced
    int file_ = -1;
    int descriptor_ = -1;   ///< of this program that `path` names, or -1
    bool replaces_ = false; ///< a regular file, or none that exists
    int error_ = 0;         ///< of the first write that failed
    std::uint64_t size_ = 0;
    std::string kept_;

    std::string open_descriptor();
    std::string open_new_file(bool exists);
    std::string open_device();
    int take_place();
    void discard();
    std::string problem(int error) const;
};

/// The whole file at once. Empty, or what went wrong.
std::string write_file(const std::string& path, std::string_view bytes);
/// Whether this name means the program's own standard output.
bool is_standard_output(std::string path);
/// What a program prints: commit() at its end says whether all of it arrived.
Output& standard_output();

} // namespace spangle::sim
