#include "tests/support/process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

namespace voxprite::test {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks(20);

std::vector<char*> pointersTo(const std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
    pointers.push_back(nullptr);
    return pointers;
}

}  // namespace

std::string contentOf(const std::filesystem::path& path) {
    std::ostringstream content;
    content << std::ifstream(path, std::ios::binary).rdbuf();
    return content.str();
}

Process::Process(const std::vector<std::string>& arguments,
                 const std::vector<std::string>& environment, const std::filesystem::path& output,
                 int inheritedDescriptor) {
    id_ = ::fork();
    if (id_ != 0) return;
    const int log = ::open(output.c_str(), O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC, 0600);
    ::dup2(log, 1);
    ::dup2(log, 2);
    if (inheritedDescriptor >= 0) ::fcntl(inheritedDescriptor, F_SETFD, 0);
    for (const std::string& variable : environment) ::putenv(const_cast<char*>(variable.c_str()));
    ::execvp(arguments.front().c_str(), pointersTo(arguments).data());
    ::perror(arguments.front().c_str());
    ::_exit(127);
}

Process::~Process() {
    if (!running()) return;
    ::kill(id_, SIGTERM);
    ::waitpid(id_, nullptr, 0);
}

void Process::kill() {
    if (!running()) return;
    ::kill(id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
    id_ = -1;
}

Process& Process::operator=(Process&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(status_, other.status_);
    return *this;
}

bool Process::running() {
    if (id_ <= 0) return false;
    int status = 0;
    if (::waitpid(id_, &status, WNOHANG) == 0) return true;
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    id_ = -1;
    return false;
}

int Process::wait(std::chrono::seconds longest) {
    const auto deadline = std::chrono::steady_clock::now() + longest;
    while (running() && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::sleep_for(kBetweenLooks);
    }
    return running() ? -1 : status_;
}

void VirtualDisplay::start(glm::ivec2 screenPx, const std::filesystem::path& folder) {
    // The server chooses a free number and writes it to the pipe once it is ready.
    int pipe[2] = {-1, -1};
    ASSERT_EQ(::pipe2(pipe, O_CLOEXEC), 0);
    const std::string screen =
        std::to_string(screenPx.x) + "x" + std::to_string(screenPx.y) + "x24";
    server_ = Process({"Xvfb", "-displayfd", std::to_string(pipe[1]), "-screen", "0", screen,
                       "+extension", "GLX", "-nolisten", "tcp", "-noreset"},
                      {}, folder / "xvfb.log", pipe[1]);
    ::close(pipe[1]);
    std::string number;
    for (char digit = 0; ::read(pipe[0], &digit, 1) == 1 && digit != '\n';) number += digit;
    ::close(pipe[0]);
    ASSERT_FALSE(number.empty()) << "Xvfb did not start: " << contentOf(folder / "xvfb.log");
    name_ = ":" + number;
}

}  // namespace voxprite::test
