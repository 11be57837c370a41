// Tests where a tool's output goes: files are written whole, devices and pipes as they are, and every loss is
// reported.
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "host_sim/output/output.hpp"

namespace {

namespace fs = std::filesystem;
using spangle::sim::Output;
using spangle::sim::write_file;

struct OutputTest : testing::Test {
    fs::path folder = fs::path(testing::TempDir()) / ("output-" + std::to_string(getpid()));

    OutputTest() {
        fs::remove_all(folder);
        fs::create_directory(folder);
    }
    ~OutputTest() override { fs::remove_all(folder); }

    std::string path(const char* name) const { return (folder / name).string(); }
    static std::string text_of(const std::string& file) {
        std::ifstream in(file, std::ios::binary);
        std::stringstream text;
        text << in.rdbuf();
        return text.str();
    }
    /// Returns the number of names in the folder; no file may be left beside the output.
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }
};

TEST_F(OutputTest, AFileHasItsNameWhenItIsWhole) {
    const std::string file = path("picture.png");
    {
        Output output;
        ASSERT_EQ(output.open(file), "");
        EXPECT_TRUE(output.write("half"));
        EXPECT_TRUE(output.flush());
        EXPECT_FALSE(fs::exists(file)) << "nobody sees half of it";
    }
    EXPECT_EQ(files(), 0u) << "what was not committed is gone";
    Output output;
    ASSERT_EQ(output.open(file), "");
    output.write("the whole");
    EXPECT_EQ(output.size(), 9u);
    EXPECT_EQ(output.commit(), "");
    EXPECT_EQ(text_of(file), "the whole");
    EXPECT_EQ(files(), 1u);
}

TEST_F(OutputTest, WhatWasThereStaysUntilThen) {
    const std::string file = path("kept.txt");
    ASSERT_EQ(write_file(file, "before"), "");
    ASSERT_EQ(chmod(file.c_str(), 0640), 0);
    Output output;
    ASSERT_EQ(output.open(file), "");
    output.write(std::string(300000, 'x'));
    EXPECT_EQ(text_of(file), "before");
    ASSERT_EQ(output.commit(), "");
    EXPECT_EQ(fs::file_size(file), 300000u);
    struct stat status {};
    ASSERT_EQ(stat(file.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777u, 0640u) << "it allows what the old one did";
}

TEST_F(OutputTest, LinksAreFollowedToTheFileTheyName) {
    fs::create_directory(folder / "deep");
    fs::create_symlink("deep/second", folder / "first");
    fs::create_symlink("../real.txt", folder / "deep/second");
    ASSERT_EQ(write_file(path("first"), "new"), "") << "the last of them names nothing yet";
    ASSERT_EQ(write_file(path("first"), "newer"), "");
    EXPECT_TRUE(fs::is_symlink(folder / "first"));
    EXPECT_TRUE(fs::is_symlink(folder / "deep/second"));
    EXPECT_EQ(text_of(path("real.txt")), "newer");
    fs::create_symlink("round", folder / "about");
    fs::create_symlink("about", folder / "round");
    EXPECT_NE(write_file(path("round"), "x").find("symbolic links"), std::string::npos);
}

/// The device must be the same file afterwards: a program that runs as root could replace it.
TEST_F(OutputTest, DevicesAreWrittenToAsTheyAre) {
    fs::create_symlink("/dev/null", folder / "nothing");
    for (const std::string& device : {std::string("/dev/null"), path("nothing")}) {
        struct stat before {
        }, after{};
        ASSERT_EQ(stat("/dev/null", &before), 0);
        EXPECT_EQ(write_file(device, "gone"), "");
        ASSERT_EQ(stat("/dev/null", &after), 0);
        EXPECT_TRUE(S_ISCHR(after.st_mode));
        EXPECT_EQ(before.st_ino, after.st_ino);
    }
    EXPECT_TRUE(fs::is_symlink(folder / "nothing"));
}

TEST_F(OutputTest, PipesAreWrittenToAsTheyAre) {
    const std::string pipe = path("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::string read;
    std::thread reader([&] { read = text_of(pipe); });
    EXPECT_EQ(write_file(pipe, std::string(200000, 'p')), "");
    reader.join();
    EXPECT_EQ(read.size(), 200000u);
    EXPECT_TRUE(fs::is_fifo(pipe));
}

/// Output to a descriptor goes on where it is; the file behind it is neither truncated nor replaced.
TEST_F(OutputTest, DescriptorsAreWrittenToWhereTheyAre) {
    const std::string file = path("behind");
    const int descriptor = open(file.c_str(), O_CREAT | O_RDWR, 0600);
    ASSERT_GE(descriptor, 0);
    ASSERT_EQ(::write(descriptor, "one ", 4), 4);
    const std::string number = std::to_string(descriptor);
    EXPECT_EQ(write_file("/dev/fd/" + number, "two "), "");
    EXPECT_EQ(write_file("/proc/self/fd/" + number, "three "), "");
    fs::create_symlink("/dev/fd/" + number, folder / "link");
    EXPECT_EQ(write_file(path("link"), "four "), "");
    ASSERT_EQ(::write(descriptor, "five", 4), 4) << "it is open still";
    close(descriptor);
    EXPECT_EQ(text_of(file), "one two three four five");
    EXPECT_NE(write_file("/dev/fd/" + number, "x"), "") << "it is closed";
}

TEST_F(OutputTest, NamesOfStandardOutput) {
    for (const char* name : {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"})
        EXPECT_TRUE(spangle::sim::is_standard_output(name)) << name;
    fs::create_symlink("/dev/stdout", folder / "out");
    EXPECT_TRUE(spangle::sim::is_standard_output(path("out")));
    for (const char* name : {"/dev/stderr", "/dev/fd/10", "./-", "/dev/fd/", "/dev/fd/1x"})
        EXPECT_FALSE(spangle::sim::is_standard_output(name)) << name;
}

TEST_F(OutputTest, WhatIsLostIsTold) {
    EXPECT_EQ(write_file("/dev/full", "x"),
              "cannot write '/dev/full': No space left on device; make room there, or name another place");
    Output output;
    ASSERT_EQ(output.open("/dev/full"), "");
    bool kept = true;
    for (int i = 0; i < 100 && kept; ++i)
        kept = output.write(std::string(10000, 'x'));
    EXPECT_FALSE(kept) << "a long file need not be finished";
    EXPECT_NE(output.commit().find("No space left"), std::string::npos);
    EXPECT_NE(write_file(path("no/such/file"), "x").find("there is no folder"), std::string::npos);
    EXPECT_NE(write_file(folder.string(), "x").find("it is a folder"), std::string::npos);
    EXPECT_NE(write_file("", "x"), "");
    Output closed;
    closed.write("nowhere");
    EXPECT_NE(closed.commit(), "") << "what has no place to go is lost";
}

/// If a regular file cannot be finished, the old file stays as it was and no new file is left.
TEST_F(OutputTest, AFullDiskLeavesTheOldFile) {
    const std::string file = path("old");
    ASSERT_EQ(write_file(file, "as it was"), "");
    // The file size limit of this process stands for a full disk; its signal would end the program.
    signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    rlimit small = before;
    small.rlim_cur = 100000;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string lost = write_file(file, std::string(200000, 'x')),
                      fresh = write_file(path("fresh"), std::string(200000, 'x'));
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_NE(lost.find("make room there"), std::string::npos) << lost;
    EXPECT_NE(fresh, "");
    EXPECT_EQ(text_of(file), "as it was");
    EXPECT_EQ(files(), 1u);
}

} // namespace
