#include "host_sim/trade/spawn.hpp"

#include <cerrno>
#include <cstdio>

#include <sys/wait.h>
#include <unistd.h>

namespace spangle::trade {

int spawn(const std::vector<std::string>& words, std::string& said) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    std::FILE* const files[] = {std::tmpfile(), std::tmpfile()};
    int status = could_not_run << 8;
    if (files[0] != nullptr && files[1] != nullptr) {
        const pid_t child = fork();
        if (child == 0) {
            dup2(fileno(files[0]), STDOUT_FILENO);
            dup2(fileno(files[1]), STDERR_FILENO);
            if (std::freopen("/dev/null", "r", stdin) != nullptr)
                execvp(arguments[0], arguments.data());
            _exit(errno == ENOENT ? no_program : could_not_run);
        }
        while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
            continue;
    }
    for (std::FILE* const file : files) {
        if (file == nullptr)
            continue;
        std::rewind(file);
        char piece[4096];
        for (std::size_t n; (n = std::fread(piece, 1, sizeof piece, file)) > 0;)
            said.append(piece, n);
        std::fclose(file);
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : could_not_run;
}

} // namespace spangle::trade
