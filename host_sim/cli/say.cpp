#include "host_sim/cli/say.hpp"

#include <cstdio>

namespace spangle::cli {
namespace {

std::string& taken_by() {
    static std::string option;
    return option;
}

} // namespace

void tell(const std::string& text) {
    (void)std::fwrite(text.data(), 1, text.size(), stderr);
}

int refuse(const std::string& why, int status) {
    tell("spangle: " + why + "\n");
    return status;
}

void print_text(const std::string& text) {
    if (taken_by().empty())
        sim::standard_output().write(text);
    else
        tell(text);
}

std::string claim_output(const char* option, const std::string& path) {
    if (path.empty() || !sim::is_standard_output(path))
        return "";
    if (!taken_by().empty())
        return taken_by() + " and " + option + " both write to standard output; name a file for one of them";
    taken_by() = option;
    return "";
}

const std::string& claiming_option() {
    return taken_by();
}

std::string open(sim::Output& file, const char* option, const std::string& path) {
    if (path.empty())
        return "";
    const std::string rule = claim_output(option, path);
    return rule.empty() ? file.open(path) : rule;
}

std::string finish(sim::Output& file, const sim::Image& picture) {
    std::string bytes;
    if (std::string problem = sim::encode_png(picture, bytes); !problem.empty())
        return "no picture: " + problem;
    file.write(bytes);
    return file.commit();
}

} // namespace spangle::cli
