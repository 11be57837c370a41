// The files that tools write. A regular file is written whole or not at all: a new file takes its place when
// everything is in it. Devices, pipes and open descriptors are written to as they are, and never replaced.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace spangle::sim {

class Output {
  public:
    Output() = default;
    /// Gives up what was not committed; a regular file then keeps its old content.
    ~Output();
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    /// Opens the output; "-" is standard output, and symbolic links are followed. An existing file of this
    /// name stays as it is until commit(). Returns why nothing can be written there, or an empty string.
    std::string open(const std::string& path);
    bool is_open() const { return file_ >= 0; }

    /// Keeps bytes to be written. Returns false when something was lost already; commit() then says what.
    bool write(std::string_view bytes);
    /// The number of bytes written so far.
    std::uint64_t size() const { return size_; }
    /// Writes the bytes that are kept, for those who read while the program runs. Returns false as write()
    /// does.
    bool flush();
    /// Writes everything, and gives a regular file its name. Returns what went wrong, or an empty string.
    /// After a failure the old file is still there.
    std::string commit();

  private:
    std::string path_;           ///< path as the user gave it, for messages
    std::string target_;         ///< path of a regular file after its symbolic links
    std::string temporary_name_; ///< name of the new file; empty: without a name, or nothing is replaced
    int file_ = -1;
    int descriptor_ = -1;        ///< descriptor of this program that `path_` names, or -1
    bool replaces_file_ = false; ///< writes a regular file, which may not exist yet
    int error_ = 0;              ///< errno of the first write that failed
    std::uint64_t size_ = 0;
    std::string buffer_;

    std::string open_descriptor();
    std::string open_new_file(bool exists);
    std::string open_device();
    int take_place();
    void discard();
    std::string problem(int error) const;
};

/// Writes a whole file at once. Returns what went wrong, or an empty string.
std::string write_file(const std::string& path, std::string_view bytes);
/// Whether this name means the program's own standard output.
bool is_standard_output(std::string path);
/// What a program prints. commit() at its end tells whether all of it arrived.
Output& standard_output();

} // namespace spangle::sim
